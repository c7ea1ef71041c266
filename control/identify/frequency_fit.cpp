#include "control/identify/frequency_fit.h"

#include "control/base/distributions.h"
#include "control/base/units.h"
#include "control/identify/least_squares.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

constexpr int Images = 200;
constexpr int Unknowns = 3;

/// The rotor's part for k = 1, without feed-through.
Complex shape(double damping_1_s, double lag_s, double period_s, double frequency_rad_s) {
    Complex sum = 0.0;
    for (int n = -Images; n <= Images; ++n) {
        const Complex s(0.0, frequency_rad_s + 2.0 * Pi * n / period_s);
        sum += 1.0 / (s * s * (s + damping_1_s) * (1.0 + lag_s * s));
    }
    return (1.0 - std::polar(1.0, -frequency_rad_s * period_s)) / period_s * sum;
}

/// What a shift of the angle by the current looks like: the sensors show the current of the sample before.
Complex oneSampleLate(double period_s, double frequency_rad_s) {
    return std::polar(1.0, -frequency_rad_s * period_s);
}

/// One linear step around `damping_1_s`: columns k, feed-through and k da.
struct Step {
    LinearFit fit;
    double damping_1_s;
};

Result<Step> stepAround(std::span<const PlantPoint> points, double period_s, double lag_s,
                        double damping_1_s) {
    const auto rows = static_cast<Eigen::Index>(2 * points.size());
    Eigen::MatrixXd design(rows, Unknowns);
    Eigen::VectorXd observed(rows);
    Eigen::VectorXd weights(rows);
    const double h_1_s = 1e-4 * (1.0 + std::abs(damping_1_s));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double w = points[i].frequency_rad_s;
        const Complex value = shape(damping_1_s, lag_s, period_s, w);
        const Complex slope = (shape(damping_1_s + h_1_s, lag_s, period_s, w) -
                               shape(damping_1_s - h_1_s, lag_s, period_s, w)) /
                              (2.0 * h_1_s);
        const double freedom = 2.0 * (points[i].averages - 1);
        const double variance =
            points[i].radius * points[i].radius / (2.0 * fisherQuantileOfTwo(0.05, freedom));
        const auto row = static_cast<Eigen::Index>(2 * i);
        const Complex through = oneSampleLate(period_s, w);
        design.row(row) << value.real(), through.real(), slope.real();
        design.row(row + 1) << value.imag(), through.imag(), slope.imag();
        observed(row) = points[i].value.real();
        observed(row + 1) = points[i].value.imag();
        weights(row) = weights(row + 1) = 1.0 / variance;
    }
    auto fit = fitLinear(design, observed, weights);
    if (!fit) {
        return failure(fit.error());
    }
    return Step{std::move(*fit), damping_1_s};
}

Estimate estimate(double value, double halfWidth, const char* unit) {
    Estimate result;
    result.value = value;
    result.interval95 = {value - halfWidth, value + halfWidth};
    result.source = EstimateSource::Identified;
    result.unit = unit;
    return result;
}

FrequencyFit resultOf(const Step& step, std::size_t points, double lag_s, double gainError_ratio) {
    const LinearFit& fit = step.fit;
    const double k = fit.coefficients(0);
    // No point is known better than its scatter says, whatever the residuals do by luck.
    const double widening = std::max(1.0, fit.residualVariance);
    const double quantile = studentQuantile(0.975, fit.freedom);
    const auto halfWidth = [&](int i) { return quantile * std::sqrt(widening * fit.unscaled(i, i)); };
    FrequencyFit result;
    result.rotor = {step.damping_1_s, k, lag_s, fit.coefficients(1)};
    result.accelerationGain = estimate(k, halfWidth(0) + gainError_ratio * std::abs(k), "rad/s^2/A");
    result.feedthrough = estimate(fit.coefficients(1), halfWidth(1), "rad/A");
    result.dampingRate = estimate(step.damping_1_s, halfWidth(2) / std::abs(k), "1/s");
    result.misfit_ratio = std::sqrt(fit.residualVariance);
    result.points = static_cast<int>(points);
    return result;
}

} // namespace

std::complex<double> sampledPlantResponse(const SampledPlantModel& rotor, double period_s,
                                          double frequency_rad_s) {
    return rotor.feedthrough_rad_per_A * oneSampleLate(period_s, frequency_rad_s) +
           rotor.accelerationGain_rad_s2_A *
               shape(rotor.dampingRate_1_s, rotor.lag_s, period_s, frequency_rad_s);
}

Result<FrequencyFit> fitSampledPlant(std::span<const PlantPoint> points, double period_s, double lag_s,
                                     double gainError_ratio) {
    constexpr std::size_t FewestPoints = 5;
    const bool isScattered =
        std::all_of(points.begin(), points.end(), [](const PlantPoint& point) { return point.radius > 0.0; });
    if (points.size() < FewestPoints || !isScattered) {
        return failure(ErrorCode::Refused, "too few usable frequencies for a fit of the rotor",
                       "measure more frequencies, or with a larger amplitude");
    }
    constexpr int MostSteps = 50;
    constexpr double Converged_ratio = 1e-9;
    // Without damping the slope of the first step is well defined; the problem is nearly linear in a.
    double damping_1_s = 0.0;
    for (int i = 0; i < MostSteps; ++i) {
        const auto step = stepAround(points, period_s, lag_s, damping_1_s);
        if (!step) {
            return failure(step.error());
        }
        const double change_1_s = step->fit.coefficients(2) / step->fit.coefficients(0);
        if (!std::isfinite(change_1_s) || step->fit.freedom < 1) {
            break;
        }
        if (std::abs(change_1_s) < Converged_ratio * (1.0 + std::abs(damping_1_s))) {
            return resultOf(*step, points.size(), lag_s, gainError_ratio);
        }
        // Half the way at most down to a pole on the measured side.
        const double lowest_1_s = -0.5 * points.front().frequency_rad_s;
        damping_1_s = std::max(damping_1_s + change_1_s, lowest_1_s);
    }
    return failure(ErrorCode::Refused, "the measured response does not match a rotor",
                   "check its points for an angle error or a resonance");
}

} // namespace halbench::control
