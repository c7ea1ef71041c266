#include "control/identify/plateau.h"

#include "control/base/assert.h"
#include "control/base/units.h"
#include "control/identify/least_squares.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

std::size_t firstAtOrAfter(std::span<const double> time_s, double instant_s) {
    return static_cast<std::size_t>(std::lower_bound(time_s.begin(), time_s.end(), instant_s - 1e-9) -
                                    time_s.begin());
}

// The window lengthened to whole turns at the speed of the last window, when the record is long enough: both
// windows then hold the same ripple.
double wholeTurns_s(std::span<const double> time_s, std::span<const double> angle_rad, double window_s) {
    const std::size_t begin = firstAtOrAfter(time_s, time_s.back() - window_s);
    const double turns = std::fabs(angle_rad.back() - angle_rad[begin]) / (2.0 * Pi);
    if (!(turns > 0.0)) {
        return window_s;
    }
    const double longer_s = window_s * std::ceil(turns) / turns;
    return 2.0 * longer_s <= time_s.back() - time_s.front() ? longer_s : window_s;
}

} // namespace

Result<PlateauSpeed> fitPlateauSpeed(std::span<const double> time_s, std::span<const double> angle_rad) {
    HB_ASSERT(time_s.size() == angle_rad.size());
    if (time_s.size() < 3 || !(time_s.back() > time_s.front())) {
        return failure(ErrorCode::Refused, "a plateau has fewer than three samples",
                       "use a longer plateau time");
    }
    const double middle_s = mean(time_s);
    const double middle_rad = mean(angle_rad);
    double spread = 0.0;
    double product = 0.0;
    for (std::size_t i = 0; i < time_s.size(); ++i) {
        spread += (time_s[i] - middle_s) * (time_s[i] - middle_s);
        product += (time_s[i] - middle_s) * (angle_rad[i] - middle_rad);
    }
    PlateauSpeed result;
    result.speed_rad_s = product / spread;
    double squares = 0.0;
    for (std::size_t i = 0; i < time_s.size(); ++i) {
        const double rest = angle_rad[i] - middle_rad - result.speed_rad_s * (time_s[i] - middle_s);
        squares += rest * rest;
    }
    const double variance = squares / static_cast<double>(time_s.size() - 2);
    if (!std::isfinite(variance)) {
        return failure(ErrorCode::NotFinite, "a sample of a plateau is not a finite number",
                       "check the recording for faults");
    }
    result.angleNoise_rad = std::sqrt(variance);
    result.speedError_rad_s = std::sqrt(variance / spread);
    return result;
}

Result<PlateauSpeed> fitRippledSpeed(std::span<const double> time_s, std::span<const double> angle_rad) {
    HB_ASSERT(time_s.size() == angle_rad.size());
    constexpr double EnoughTravel_rad = 3.0 * Pi;
    constexpr std::size_t EnoughSamples = 12;
    if (angle_rad.size() < EnoughSamples ||
        !(std::fabs(angle_rad.back() - angle_rad.front()) >= EnoughTravel_rad)) {
        return fitPlateauSpeed(time_s, angle_rad);
    }
    const double middle_s = mean(time_s);
    const double middle_rad = mean(angle_rad);
    Eigen::MatrixXd design(static_cast<Eigen::Index>(time_s.size()), 6);
    Eigen::VectorXd angle(design.rows());
    for (std::size_t i = 0; i < time_s.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        design.row(row) << time_s[i] - middle_s, 1.0, std::cos(angle_rad[i]), std::sin(angle_rad[i]),
            std::cos(2.0 * angle_rad[i]), std::sin(2.0 * angle_rad[i]);
        angle(row) = angle_rad[i] - middle_rad;
    }
    const auto fit = fitLinear(design, angle);
    if (!fit) {
        return failure(fit.error());
    }
    return PlateauSpeed{fit->coefficients(0), std::sqrt(fit->covariance(0, 0)),
                        std::sqrt(fit->residualVariance)};
}

Result<Steadiness> testSteadiness(std::span<const double> time_s, std::span<const double> angle_rad,
                                  const SteadinessConfig& config) {
    HB_ASSERT(time_s.size() == angle_rad.size() && config.window_s > 0.0);
    constexpr std::size_t FewestSamples = 6;
    if (time_s.size() < FewestSamples || time_s.back() - time_s.front() < 2.0 * config.window_s - 0.05) {
        return failure(ErrorCode::Refused, "a plateau is shorter than two windows of the steadiness test",
                       "use a longer plateau time");
    }
    const double window_s = wholeTurns_s(time_s, angle_rad, config.window_s);
    const std::size_t second = firstAtOrAfter(time_s, time_s.back() - window_s);
    const std::size_t first = firstAtOrAfter(time_s, time_s.back() - 2.0 * window_s);
    const auto earlier =
        fitPlateauSpeed(time_s.subspan(first, second - first), angle_rad.subspan(first, second - first));
    const auto later = fitPlateauSpeed(time_s.subspan(second), angle_rad.subspan(second));
    if (!earlier || !later) {
        return failure(earlier ? later.error() : earlier.error());
    }
    Steadiness result;
    result.earlier_rad_s = earlier->speed_rad_s;
    result.later_rad_s = later->speed_rad_s;
    result.sigma_rad_s = std::hypot(earlier->speedError_rad_s, later->speedError_rad_s);
    const double allowed =
        std::max(3.0 * result.sigma_rad_s, config.tolerance_ratio * std::fabs(later->speed_rad_s));
    result.isSteady = std::fabs(later->speed_rad_s - earlier->speed_rad_s) <= allowed;
    return result;
}

} // namespace halbench::control
