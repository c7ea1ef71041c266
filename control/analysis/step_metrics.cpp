#include "control/analysis/step_metrics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace halbench::control {

namespace {

/// Time at which the straight line between two samples reaches a level.
double reached_s(std::span<const double> time_s, std::span<const double> y, std::size_t i, double level) {
    const double share = (level - y[i - 1]) / (y[i] - y[i - 1]);
    return time_s[i - 1] + share * (time_s[i] - time_s[i - 1]);
}

std::optional<double> firstReached_s(std::span<const double> time_s, std::span<const double> y,
                                     double level) {
    if (y.front() >= level) {
        return time_s.front();
    }
    for (std::size_t i = 1; i < y.size(); ++i) {
        if (y[i] >= level) {
            return reached_s(time_s, y, i, level);
        }
    }
    return std::nullopt;
}

std::optional<double> settled_s(std::span<const double> time_s, std::span<const double> y, double band) {
    if (std::abs(y.back() - 1.0) > band) {
        return std::nullopt;
    }
    for (std::size_t i = y.size() - 1; i > 0; --i) {
        if (std::abs(y[i - 1] - 1.0) > band) {
            return reached_s(time_s, y, i, y[i - 1] > 1.0 ? 1.0 + band : 1.0 - band);
        }
    }
    return time_s.front();
}

Result<void> check(std::span<const double> time_s, std::span<const double> response, double from, double to) {
    if (time_s.size() != response.size() || time_s.size() < 2) {
        return failure(ErrorCode::InvalidInput,
                       "a step response needs at least two samples, each with its time");
    }
    const auto isFinite = [](double x) { return std::isfinite(x); };
    if (!std::all_of(time_s.begin(), time_s.end(), isFinite) ||
        !std::all_of(response.begin(), response.end(), isFinite) || !std::isfinite(from) ||
        !std::isfinite(to)) {
        return failure(ErrorCode::NotFinite, "the step response contains a value that is not finite");
    }
    if (from == to) {
        return failure(ErrorCode::InvalidInput, "the step height is zero");
    }
    if (!std::is_sorted(time_s.begin(), time_s.end())) {
        return failure(ErrorCode::InvalidInput, "the times of the step response are not ascending");
    }
    return {};
}

} // namespace

Result<StepMetrics> measureStep(std::span<const double> time_s, std::span<const double> response,
                                double from_rad, double to_rad, const StepThresholds& thresholds) {
    if (const auto valid = check(time_s, response, from_rad, to_rad); !valid) {
        return failure(valid.error());
    }
    std::vector<double> y;
    y.reserve(response.size());
    for (const double value : response) {
        y.push_back((value - from_rad) / (to_rad - from_rad));
    }
    const double start_s = time_s.front();
    StepMetrics metrics;
    const auto low_s = firstReached_s(time_s, y, thresholds.riseFrom_ratio);
    const auto high_s = firstReached_s(time_s, y, thresholds.riseTo_ratio);
    if (low_s && high_s) {
        metrics.riseTime_s = *high_s - *low_s;
    }
    const auto peak = std::max_element(y.begin(), y.end());
    if (*peak > 1.0) {
        metrics.overshoot_percent = 100.0 * (*peak - 1.0);
        metrics.peakTime_s = time_s[static_cast<std::size_t>(peak - y.begin())] - start_s;
    }
    if (const auto end_s = settled_s(time_s, y, thresholds.settlingBand_ratio)) {
        metrics.settlingTime_s = *end_s - start_s;
    }
    metrics.finalError_rad = to_rad - response.back();
    return metrics;
}

} // namespace halbench::control
