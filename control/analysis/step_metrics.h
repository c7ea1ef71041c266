#pragma once

#include "control/base/result.h"

#include <optional>
#include <span>

namespace halbench::control {

/// Thresholds of the step figures, relative to the height of the step.
struct StepThresholds {
    double riseFrom_ratio = 0.1;
    double riseTo_ratio = 0.9;
    double settlingBand_ratio = 0.02;
};

/// Figures of one step response, all measured against the *reference* (not against where the response ended,
/// so that a stuck motor shows as an error and not as a perfect step). Times count from the step; thresholds
/// are crossed on straight lines between the samples.
struct StepMetrics {
    std::optional<double> riseTime_s;     ///< 10-90 %; absent when 90 % was never reached
    double overshoot_percent = 0.0;       ///< of the step's height; 0 when the reference was never exceeded
    std::optional<double> peakTime_s;     ///< of the farthest value; absent without overshoot
    std::optional<double> settlingTime_s; ///< after it the response stays within 2 %; absent when it did not
    double finalError_rad = 0.0;          ///< reference - response at the end (unit of the response)
};

/// `time_s` ascending from the instant of the step, `response` beside it; the reference jumps from `from` to
/// `to`. Sample finely (1 ms for the motor): overshoot between coarse samples is lost.
/// Errors: InvalidInput (lengths, fewer than 2 samples, step of no height), NotFinite.
Result<StepMetrics> measureStep(std::span<const double> time_s, std::span<const double> response,
                                double from_rad, double to_rad, const StepThresholds& thresholds = {});

} // namespace halbench::control
