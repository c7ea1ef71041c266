#include "control/analysis/frequency_scan.h"

#include "control/base/assert.h"
#include "control/base/units.h"
#include "control/lti/frequency_response.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace halbench::control {

namespace {

using Complex = std::complex<double>;

/// Image in the s plane; absent for a root that is an integrator or a pure delay.
std::optional<Complex> continuousImage(Complex root, const TimeBase& base) {
    constexpr double IntegratorDistance = 1e-5; // a double root at 1 is only found to 1e-8
    if (base.isContinuous()) {
        return root == 0.0 ? std::nullopt : std::optional(root);
    }
    if (std::abs(root - 1.0) < IntegratorDistance || std::abs(root) < IntegratorDistance) {
        return std::nullopt;
    }
    return std::log(root) / base.period_s();
}

std::vector<Complex> characteristicPoints(const TransferFunction& system) {
    std::vector<Complex> points;
    for (const auto& list : {poles(system), zeros(system)}) {
        for (const Complex& root : list) {
            if (const auto image = continuousImage(root, system.timeBase())) {
                points.push_back(*image);
            }
        }
    }
    return points;
}

std::vector<Complex> characteristicPoints(const DeltaSystem& system) {
    std::vector<Complex> points;
    for (const auto& list : {system.poles(), system.zeros()}) {
        for (const Complex& root : list) {
            if (root != 0.0 && root != -1.0) { // an integrator or a pure delay
                points.push_back(rateOf(root, system.timeBase().period_s()));
            }
        }
    }
    return points;
}

/// Moves an end of the range outward while the magnitude still changes and has not left 1 far behind.
template <typename System>
double extended(const System& system, double end_rad_s, double factor) {
    constexpr int MaxDecades = 12;
    for (int i = 0; i < MaxDecades; ++i) {
        const double here = std::abs(system.atFrequency(end_rad_s));
        const double next = std::abs(system.atFrequency(end_rad_s * factor));
        const bool headsForOne = (here > 1.0) != (next > here);
        if (!headsForOne || std::abs(next - here) < 1e-3 * here || !std::isfinite(next)) {
            break;
        }
        end_rad_s *= factor;
    }
    return end_rad_s;
}

void addAround(std::vector<double>& frequencies, Complex point, double from_rad_s, double to_rad_s) {
    const double natural_rad_s = std::abs(point);
    const double width = std::max(std::abs(point.real()) / natural_rad_s, 1e-9);
    for (int i = -20; i <= 20; ++i) {
        const double frequency = natural_rad_s * (1.0 + 0.25 * i * width);
        if (width < 0.1 && frequency > from_rad_s && frequency < to_rad_s) {
            frequencies.push_back(frequency);
        }
    }
}

/// Lowest frequency at which rounding leaves four digits of the denominator of a sampled system.
double clearFrom_rad_s(const TransferFunction& system, const std::vector<double>& frequencies) {
    double sum = 0.0;
    for (const double coefficient : system.denominator()) {
        sum += std::abs(coefficient);
    }
    const auto isDrowned = [&](double frequency_rad_s) {
        const Complex z = std::polar(1.0, frequency_rad_s * system.timeBase().period_s());
        return std::abs(evaluate(system.denominator(), z)) < 1e-12 * sum;
    };
    // Only a cluster of poles at z = 1 does this, and it clears with distance.
    const auto clear = std::partition_point(frequencies.begin(), frequencies.end(), isDrowned);
    return clear == frequencies.end() ? frequencies.back() : *clear;
}

template <typename System>
std::vector<double> gridOver(const System& system, const std::vector<Complex>& points) {
    const TimeBase& base = system.timeBase();
    double slowest_rad_s = base.isSampled() ? 1.0 / base.period_s() : 1.0;
    double fastest_rad_s = slowest_rad_s;
    if (!points.empty()) {
        const auto [low, high] = std::minmax_element(
            points.begin(), points.end(), [](Complex a, Complex b) { return std::abs(a) < std::abs(b); });
        slowest_rad_s = std::min(base.isSampled() ? slowest_rad_s : std::abs(*low), std::abs(*low));
        fastest_rad_s = std::abs(*high);
    }
    const double nyquist_rad_s = base.isSampled() ? Pi / base.period_s() : HUGE_VAL;
    const double from_rad_s = extended(system, std::min(slowest_rad_s, nyquist_rad_s) / 100.0, 0.1);
    const double to_rad_s = base.isSampled()
                                ? nyquist_rad_s
                                : extended(system, std::max(fastest_rad_s, from_rad_s) * 100.0, 10.0);

    constexpr double PointsPerDecade = 200.0;
    const double decades = std::log10(to_rad_s / from_rad_s);
    std::vector<double> frequencies =
        logarithmicFrequencies(from_rad_s, to_rad_s, static_cast<int>(decades * PointsPerDecade) + 2);
    const auto extra = static_cast<std::ptrdiff_t>(frequencies.size()); // what is before it is in order
    for (const Complex& point : points) {
        addAround(frequencies, point, from_rad_s, to_rad_s);
    }
    std::sort(frequencies.begin() + extra, frequencies.end());
    std::inplace_merge(frequencies.begin(), frequencies.begin() + extra, frequencies.end());
    frequencies.erase(std::unique(frequencies.begin(), frequencies.end()), frequencies.end());
    return frequencies;
}

struct Sample {
    double x = 0.0;
    double value = 0.0;

    bool isNegative() const { return value < 0.0; }
};

/// How far from the newest point to the other side the zero may lie: inverse quadratic interpolation where
/// the three points lie so that it converges, else the middle (Chandrupatla, Advances in Engineering Software
/// 28 (1997) 145).
double nextShare(const Sample& newest, const Sample& other, const Sample& before) {
    constexpr double Middle = 0.5;
    const double a = newest.value;
    const double b = other.value;
    const double c = before.value;
    const double place = (newest.x - other.x) / (before.x - other.x);
    const double height = (a - b) / (c - b);
    if (!(height * height < place && (1.0 - height) * (1.0 - height) < 1.0 - place)) {
        return Middle;
    }
    const double along = (before.x - newest.x) / (other.x - newest.x);
    const double share = a / (b - a) * c / (b - c) + along * a / (c - a) * b / (c - b);
    return std::isfinite(share) ? share : Middle;
}

} // namespace

FrequencyScan frequencyScan(const TransferFunction& system) {
    FrequencyScan scan{gridOver(system, characteristicPoints(system)), false};
    if (system.timeBase().isSampled()) {
        const double least_rad_s = clearFrom_rad_s(system, scan.frequency_rad_s);
        const auto isLost = [least_rad_s](double frequency) { return frequency < least_rad_s; };
        scan.isCut = std::erase_if(scan.frequency_rad_s, isLost) > 0;
    }
    return scan;
}

FrequencyScan frequencyScan(const DeltaSystem& system) {
    return {gridOver(system, characteristicPoints(system)), false};
}

std::vector<double> scanFrequencies(const TransferFunction& system) {
    return frequencyScan(system).frequency_rad_s;
}

double rootBetween(const std::function<double(double)>& function, double low, double high) {
    constexpr int MostRounds = 200; // a jump is halved: 53 rounds for two ends of one size
    Sample newest{high, function(high)};
    Sample other{low, function(low)};
    double share = 0.5;
    for (int i = 0; i < MostRounds; ++i) {
        const double x = newest.x + share * (other.x - newest.x);
        const Sample here{x, function(x)};
        const bool isSameSide = here.isNegative() == newest.isNegative();
        const Sample before = isSameSide ? newest : other;
        other = isSameSide ? other : newest;
        newest = here;
        const Sample best = std::abs(other.value) < std::abs(newest.value) ? other : newest;
        const double rounding = 2.0 * std::numeric_limits<double>::epsilon() * std::abs(best.x);
        const double least = rounding / std::abs(other.x - newest.x);
        if (best.value == 0.0 || !(least < 0.5)) {
            return best.x;
        }
        share = std::clamp(nextShare(newest, other, before), least, 1.0 - least);
    }
    return 0.5 * (newest.x + other.x);
}

double goldenMinimum(const std::function<double(double)>& function, double low, double high) {
    const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
    double left = high - ratio * (high - low);
    double right = low + ratio * (high - low);
    double atLeft = function(left);
    double atRight = function(right);
    // 60 rounds shrink by 3e-13; a minimum is only known to the square root of the rounding anyway.
    for (int i = 0; i < 60; ++i) {
        if (atLeft < atRight) {
            high = right;
            right = left;
            atRight = atLeft;
            left = high - ratio * (high - low);
            atLeft = function(left);
        } else {
            low = left;
            left = right;
            atLeft = atRight;
            right = low + ratio * (high - low);
            atRight = function(right);
        }
    }
    return 0.5 * (low + high);
}

double scanMinimum(const std::function<double(double)>& function, const std::vector<double>& points) {
    HB_ASSERT(!points.empty());
    std::size_t best = 0;
    double smallest = function(points.front());
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double value = function(points[i]);
        if (value < smallest) {
            smallest = value;
            best = i;
        }
    }
    const double low = points[best == 0 ? 0 : best - 1];
    const double high = points[best + 1 == points.size() ? best : best + 1];
    const double refined = goldenMinimum(function, low, high);
    return function(refined) < smallest ? refined : points[best];
}

} // namespace halbench::control
