#include "control/design/design_targets.h"

#include "control/base/units.h"
#include "control/design/optimal_designs.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace halbench::control {

namespace {

/// A target with the numbers it may be.
struct TargetRange {
    std::string_view name;
    std::optional<double> value;
    double least; ///< not itself when it is 0
    double most;
    std::string_view hint = {};
};

Result<void> checkTarget(const TargetRange& target, const DesignMethod& method) {
    if (!target.value) {
        return {};
    }
    if (!std::isfinite(*target.value)) {
        return failure(ErrorCode::NotFinite,
                       fmt::format("the target {} is not a finite number", target.name));
    }
    if (method.targets.find(target.name) == std::string_view::npos) {
        return failure(ErrorCode::Usage,
                       fmt::format("method {} does not read the target {}", method.name, target.name),
                       "leave it out, or choose the method that reads it");
    }
    if (*target.value <= 0.0 || *target.value < target.least || *target.value > target.most) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("the target {} = {} is not between {:.4g} and {:.6g}", target.name,
                                   *target.value, target.least, target.most),
                       std::string(target.hint));
    }
    return {};
}

} // namespace

Result<void> checkTargets(const DesignMethod& method, const LoopTiming& timing,
                          const DesignTargets& targets) {
    const double nyquist_rad_s = Pi / timing.period_s;
    const TargetRange ranges[] = {
        {"zeta", targets.zeta, 0.0, 10.0},
        {"omega-rad-s", targets.omega_rad_s, 0.0, nyquist_rad_s},
        {"bandwidth-hz", targets.bandwidth_Hz, 0.0, nyquist_rad_s / (2.0 * Pi)},
        {"phase-margin-deg", targets.phaseMargin_deg, 0.0, 90.0},
        {"max-sensitivity", targets.mostMs_ratio, least_error::LeastMs_ratio, least_error::MostMs_ratio,
         "1.4 is robust, 1.7 usual, 2 fast"},
        {"current-limit-a", targets.currentLimit_A, 0.0, 1e3, "give the maximum current of the motor in A"},
        {"step-deg", targets.step_deg, 0.0, 360.0, "give the largest step without saturation, in degrees"},
        {"ultimate-gain", targets.ultimateGain_A_per_rad, 0.0, 1e5},
        {"ultimate-period", targets.ultimatePeriod_s, 0.0, 1e3}};
    for (const TargetRange& range : ranges) {
        if (const auto valid = checkTarget(range, method); !valid) {
            return valid;
        }
    }
    if (targets.step_deg && !targets.currentLimit_A) {
        return failure(ErrorCode::Usage, "the target step-deg needs the target current-limit-a",
                       "give the current limit for this step");
    }
    if (targets.ultimateGain_A_per_rad.has_value() != targets.ultimatePeriod_s.has_value()) {
        return failure(ErrorCode::Usage, "ultimate gain and ultimate period must be given together",
                       "give both from the relay experiment, or omit both");
    }
    return {};
}

} // namespace halbench::control
