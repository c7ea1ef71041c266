#include "control/identify/limit_forecast.h"

#include "control/base/distributions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace halbench::control {

namespace {

constexpr double Infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t MostGroups = 40;
constexpr double Copper_per_K = 0.00393;
constexpr double CopperMargin_ratio = 1.1;
constexpr double DitherShare_ratio = 0.4; ///< noise of so much of a step breaks it up
constexpr double MisfitFactor = 4.0;      ///< residuals beyond so many times what the sensor explains
constexpr int Decays = 60;                ///< values of b that are tried
constexpr int Directions = 24;            ///< on the edge of an ellipse

/// Groups of bins: times against the newest, and means.
struct Course {
    std::vector<double> time_s;
    std::vector<double> mean_degC;
    double width_s = 0.0;     ///< of a group
    double expected_K2 = 0.0; ///< variance of a mean by the sensor's noise and step
    double groupsPerFact = 1.0;
};

/// T = now + slope phi_b(t)
struct Fit {
    double b_per_s = 0.0;
    double now_degC = 0.0;
    double slope_K_per_s = 0.0;
    double squares_K2 = 0.0;
    std::array<double, 3> unscaled{}; ///< (X'X)^-1: now now, now slope, slope slope
    std::vector<double> residuals;
};

/// Mean of phi over a group: that of e^(-b t) is larger than its value in the middle by sinh(x)/x, x = b w/2.
double shape(double b_per_s, double time_s, double width_s) {
    if (b_per_s == 0.0) {
        return time_s;
    }
    const double half = 0.5 * b_per_s * width_s;
    const double growth = std::abs(half) < 1e-4 ? half * half / 6.0 : std::sinh(half) / half - 1.0;
    return -(std::expm1(-b_per_s * time_s) + growth * std::exp(-b_per_s * time_s)) / b_per_s;
}

Course courseOf(std::span<const ThermalBin> bins) {
    const std::size_t groups = std::min(MostGroups, bins.size());
    Course course{std::vector<double>(groups), std::vector<double>(groups), 0.0, 0.0, 1.0};
    course.width_s = ThermalBins::Width_s * static_cast<double>(bins.size()) / static_cast<double>(groups);
    double steps_K2 = 0.0;
    double step_K = Infinite;
    double samples = 0.0;
    std::vector<double> counts(groups, 0.0);
    for (std::size_t i = 0; i < bins.size(); ++i) {
        const std::size_t group = i * groups / bins.size();
        course.time_s[group] += bins[i].time_s - bins.back().time_s;
        course.mean_degC[group] += bins[i].mean_degC;
        counts[group] += 1.0;
        steps_K2 += bins[i].stepSquares_K2;
        step_K = std::min(step_K, bins[i].leastStep_K);
        samples += static_cast<double>(bins[i].samples);
    }
    for (std::size_t group = 0; group < groups; ++group) {
        course.time_s[group] /= counts[group];
        course.mean_degC[group] /= counts[group];
    }
    const auto count = static_cast<double>(groups);
    const double noise_K2 = steps_K2 / (2.0 * samples);
    const bool isDithered = noise_K2 >= DitherShare_ratio * DitherShare_ratio * step_K * step_K;
    course.expected_K2 = isDithered ? noise_K2 * count / samples : step_K * step_K / 12.0;
    if (!isDithered) { // on a stair every tread tells one thing
        const double treads = std::abs(course.mean_degC.back() - course.mean_degC.front()) / step_K;
        course.groupsPerFact = count / std::clamp(treads, 3.0, count);
    }
    return course;
}

Fit fitAt(const Course& course, double b_per_s) {
    const auto count = static_cast<double>(course.time_s.size());
    double x = 0.0, xx = 0.0, y = 0.0, xy = 0.0;
    for (std::size_t i = 0; i < course.time_s.size(); ++i) {
        const double each = shape(b_per_s, course.time_s[i], course.width_s);
        x += each;
        xx += each * each;
        y += course.mean_degC[i];
        xy += each * course.mean_degC[i];
    }
    const double determinant = count * xx - x * x;
    Fit fit;
    fit.b_per_s = b_per_s;
    fit.slope_K_per_s = (count * xy - x * y) / determinant;
    fit.now_degC = (y - fit.slope_K_per_s * x) / count;
    fit.unscaled = {xx / determinant, -x / determinant, count / determinant};
    for (std::size_t i = 0; i < course.time_s.size(); ++i) {
        fit.residuals.push_back(course.mean_degC[i] - fit.now_degC -
                                fit.slope_K_per_s * shape(b_per_s, course.time_s[i], course.width_s));
        fit.squares_K2 += fit.residuals.back() * fit.residuals.back();
    }
    return fit;
}

/// From the steepest runaway that copper allows over a straight line to what has settled within the stretch,
/// in rising order.
std::vector<double> decaysOf(const Course& course) {
    const double stretch_s = -course.time_s.front();
    const Fit straight = fitAt(course, 0.0);
    const double error_K_per_s = 2.0 * std::sqrt(straight.unscaled[2] * course.expected_K2);
    const double kappa_per_K = Copper_per_K / std::max(0.5, 1.0 + Copper_per_K * (straight.now_degC - 25.0));
    const double runaway_per_s =
        CopperMargin_ratio * kappa_per_K * std::max(0.0, straight.slope_K_per_s + error_K_per_s);
    std::vector<double> decays_per_s;
    for (const double share : {1.0, 0.75, 0.5, 0.25, 0.0}) {
        if (share == 0.0 || runaway_per_s > 0.0) {
            decays_per_s.push_back(-share * runaway_per_s);
        }
    }
    for (int i = 0; i < Decays; ++i) {
        constexpr double Slowest = 1e-3;
        constexpr double Range = 1e4;
        decays_per_s.push_back(Slowest * std::pow(Range, i / (Decays - 1.0)) / stretch_s);
    }
    return decays_per_s;
}

std::size_t bestOf(const std::vector<Fit>& fits) {
    const auto best = std::min_element(fits.begin(), fits.end(), [](const Fit& one, const Fit& other) {
        return one.squares_K2 < other.squares_K2;
    });
    return static_cast<std::size_t>(best - fits.begin());
}

/// Fits between the neighbours of the best one, where good data decide within one step of the others.
void refine(const Course& course, std::vector<Fit>& fits) {
    constexpr int Between = 8;
    const std::size_t best = bestOf(fits);
    const std::size_t low = best > 0 ? best - 1 : best;
    const std::size_t high = std::min(best + 1, fits.size() - 1);
    std::vector<Fit> finer;
    for (std::size_t i = low; i < high; ++i) {
        for (int part = 1; part < Between; ++part) {
            const double share = static_cast<double>(part) / Between;
            finer.push_back(fitAt(course, fits[i].b_per_s + share * (fits[i + 1].b_per_s - fits[i].b_per_s)));
        }
    }
    fits.insert(fits.end(), finer.begin(), finer.end());
    std::sort(fits.begin(), fits.end(),
              [](const Fit& one, const Fit& other) { return one.b_per_s < other.b_per_s; });
}

std::vector<Fit> fitsOf(const Course& course) {
    constexpr int Refinements = 4;
    std::vector<Fit> fits;
    for (const double b_per_s : decaysOf(course)) {
        fits.push_back(fitAt(course, b_per_s));
    }
    for (int i = 0; i < Refinements; ++i) {
        refine(course, fits);
    }
    return fits;
}

/// How many groups tell as much as one that is independent of its neighbours.
double groupsPerFact(const Course& course, const Fit& best) {
    double neighbours_K2 = 0.0;
    for (std::size_t i = 1; i < best.residuals.size(); ++i) {
        neighbours_K2 += best.residuals[i] * best.residuals[i - 1];
    }
    const double correlation =
        best.squares_K2 > 0.0 ? std::clamp(neighbours_K2 / best.squares_K2, 0.0, 0.95) : 0.0;
    const double most = static_cast<double>(course.time_s.size()) / 3.0;
    return std::clamp((1.0 + correlation) / (1.0 - correlation), course.groupsPerFact,
                      std::max(most, course.groupsPerFact));
}

double timeToLimit_s(double now_degC, double slope_K_per_s, double b_per_s, double limit_degC) {
    if (now_degC >= limit_degC) {
        return 0.0;
    }
    if (slope_K_per_s <= 0.0) {
        return Infinite;
    }
    const double straight_s = (limit_degC - now_degC) / slope_K_per_s;
    const double share = b_per_s * straight_s;
    if (share >= 1.0) {
        return Infinite;
    }
    const double time_s = b_per_s == 0.0 ? straight_s : -std::log1p(-share) / b_per_s;
    return time_s <= LimitForecast::Longest_s ? time_s : Infinite;
}

/// What the data do not refuse.
struct Span {
    double least_s = Infinite;
    double most_s = 0.0;
    double coldest_degC = Infinite;
    double hottest_degC = -Infinite;

    void take(double now_degC, double slope_K_per_s, double b_per_s, double limit_degC) {
        const double time_s = timeToLimit_s(now_degC, slope_K_per_s, b_per_s, limit_degC);
        least_s = std::min(least_s, time_s);
        most_s = std::max(most_s, time_s);
        const double final_degC =
            b_per_s > 0.0 ? now_degC + slope_K_per_s / b_per_s : (slope_K_per_s > 0.0 ? Infinite : -Infinite);
        coldest_degC = std::min(coldest_degC, final_degC);
        hottest_degC = std::max(hottest_degC, final_degC);
    }
};

/// `variance_K2`: of one group; `width`: the quantile.
void takeEdge(Span& span, const Fit& fit, double variance_K2, double width, double limit_degC) {
    const double now_K = std::sqrt(fit.unscaled[0] * variance_K2);
    const double cross = fit.unscaled[1] * variance_K2 / now_K;
    const double rest = std::sqrt(std::max(0.0, fit.unscaled[2] * variance_K2 - cross * cross));
    for (int i = 0; i < Directions; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / Directions;
        span.take(fit.now_degC + width * now_K * std::cos(angle),
                  fit.slope_K_per_s + width * (cross * std::cos(angle) + rest * std::sin(angle)), fit.b_per_s,
                  limit_degC);
    }
}

LimitForecast concluded(LimitForecast forecast, const Fit& best, const Span& span) {
    using Verdict = LimitForecast::Verdict;
    if (span.least_s == Infinite) {
        forecast.verdict = Verdict::NotReached;
        if (std::isfinite(span.coldest_degC) && std::isfinite(span.hottest_degC)) {
            forecast.final95_degC = {span.coldest_degC, span.hottest_degC};
        }
        return forecast;
    }
    forecast.earliest_s = span.least_s;
    forecast.verdict = span.most_s == Infinite ? Verdict::NotBefore : Verdict::Reached;
    if (forecast.verdict == Verdict::Reached) {
        const double likely_s =
            timeToLimit_s(best.now_degC, best.slope_K_per_s, best.b_per_s, forecast.limit_degC);
        forecast.time_s = std::clamp(likely_s, span.least_s, span.most_s);
        forecast.interval95_s = {span.least_s, span.most_s};
    }
    return forecast;
}

} // namespace

std::string_view forecastVerdictName(LimitForecast::Verdict verdict) {
    constexpr std::array<std::string_view, 5> Names = {"reached", "not_reached", "not_before", "at_limit",
                                                       "withheld"};
    return Names[static_cast<std::size_t>(verdict)];
}

std::string_view forecastReasonName(LimitForecast::Reason reason) {
    constexpr std::array<std::string_view, 4> Names = {"", "too_short", "no_step", "not_first_order"};
    return Names[static_cast<std::size_t>(reason)];
}

LimitForecast forecastLimit(std::span<const ThermalBin> bins, double limit_degC) {
    LimitForecast forecast;
    forecast.limit_degC = limit_degC;
    if (bins.empty()) {
        forecast.reason = LimitForecast::Reason::TooShort;
        return forecast;
    }
    forecast.now_degC = bins.back().mean_degC;
    forecast.stretch_s = bins.back().time_s - bins.front().time_s + ThermalBins::Width_s;
    if (forecast.now_degC >= limit_degC) {
        forecast.verdict = LimitForecast::Verdict::AtLimit;
        return forecast;
    }
    if (forecast.stretch_s < LimitForecast::LeastStretch_s || bins.size() < 8) {
        forecast.reason = LimitForecast::Reason::TooShort;
        return forecast;
    }
    const bool hasStep = std::any_of(bins.begin(), bins.end(),
                                     [](const ThermalBin& bin) { return std::isfinite(bin.leastStep_K); });
    if (!hasStep) {
        forecast.reason = LimitForecast::Reason::NoStep;
        return forecast;
    }
    const Course course = courseOf(bins);
    const std::vector<Fit> fits = fitsOf(course);
    const Fit& best = fits[bestOf(fits)];
    const double freedom = static_cast<double>(course.time_s.size()) - 3.0;
    if (best.squares_K2 / freedom > MisfitFactor * MisfitFactor * course.expected_K2) {
        forecast.reason = LimitForecast::Reason::NotFirstOrder;
        return forecast;
    }
    const double perFact = groupsPerFact(course, best);
    const double variance_K2 = std::max(best.squares_K2 / freedom, course.expected_K2) * perFact;
    const double facts = std::max(2.0, static_cast<double>(course.time_s.size()) / perFact - 3.0);
    const double width = studentQuantile(0.975, facts);
    Span span;
    for (const Fit& fit : fits) {
        if (fit.squares_K2 <= best.squares_K2 + width * width * variance_K2) {
            takeEdge(span, fit, variance_K2, width, limit_degC);
        }
    }
    return concluded(forecast, best, span);
}

} // namespace halbench::control
