#include "app/procedures/identify/axes_procedure.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/offered_procedure.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/base/restored_result.h"
#include "app/procedures/identify/axes_estimate.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::app {
namespace {

Result<void> setMass(IdentifyConfig& config, std::string_view symbol, double value) {
    if (symbol != "m") {
        return failure(ErrorCode::UnknownName, fmt::format("this device has no constant '{}'", symbol),
                       "known is m (moving mass of an axis, kg)");
    }
    if (!std::isfinite(value)) {
        return failure(ErrorCode::NotFinite, "m is not a finite number", {});
    }
    if (value <= 0.0) {
        return failure(ErrorCode::OutOfRange, fmt::format("m = {} must be positive", value), {});
    }
    config.constants = {{"m", value}};
    return {};
}

bool hasMotorOptions(const IdentifyConfig& config) {
    const IdentifyConfig plain;
    return config.added || config.directions != plain.directions ||
           config.sweep.from_A != plain.sweep.from_A || config.sweep.to_A != plain.sweep.to_A ||
           config.sweep.step_A != plain.sweep.step_A || config.speedLimit_rad_s != plain.speedLimit_rad_s ||
           config.usableSpeed_rad_s != plain.usableSpeed_rad_s;
}

Result<void> check(const devices::Catalogue& catalogue, const IdentifyConfig& config) {
    if (const auto axes = chosenAxes(catalogue, config.axis); !axes) {
        return failure(axes.error());
    }
    if (hasMotorOptions(config)) {
        return failure(ErrorCode::Usage, "a sweep of currents, directions or added inertia are for a motor",
                       "leave them out; this device takes an axis and a given m");
    }
    return {};
}

IdentifyPrediction predict(const IdentifyConfig&, double start_degC) {
    // Of one axis whose speed window leaves the sweeps their time.
    constexpr double Window = 0.1, Speed = 1.0, Ends_s = 1.5;
    IdentifyPrediction prediction;
    prediction.duration_s = durationOf(axisPlan({}, Window, Speed)) + Ends_s;
    prediction.highestTemperature_degC = start_degC;
    return prediction;
}

AxesIdentifyResult estimateFrom(AxesMotion motion, const std::vector<AxisPlan>& plans,
                                const IdentifyConfig& config, const MeasuredTiming& timing) {
    AxesEstimate estimate(config.constants.empty() ? std::nullopt
                                                   : std::optional(config.constants.front().value));
    for (std::size_t i = 0; i < plans.size(); ++i) {
        estimate.add(plans[i].axis, fitAxis(motion.axes[i], plans[i].slowest), timing);
    }
    AxesIdentifyResult result = std::move(estimate).result();
    nameRowLoss(result.quality, motion.loss);
    result.duration_s = motion.duration_s;
    result.recording = std::move(motion.recording);
    return result;
}

Result<AxesIdentifyResult> measure(devices::Device& device, const IdentifyConfig& config,
                                   const ProcedureObserver& observer, const MeasuredTiming& timing) {
    const auto plans = axisPlans(device, *chosenAxes(device.catalogue(), config.axis)); // checked before
    if (!plans) {
        return failure(plans.error());
    }
    auto motion = recordAxes(device, *plans, observer);
    if (!motion) {
        return failure(motion.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Fit); !entered) {
        return failure(entered.error());
    }
    AxesIdentifyResult result = estimateFrom(*std::move(motion), *plans, config, timing);
    if (auto entered = enterState(observer, ProcedureState::Judge); !entered) {
        return failure(entered.error());
    }
    return result;
}

Result<IdentifyOutcome> identify(devices::Device& device, const IdentifyConfig& config,
                                 const ProcedureObserver& observer) {
    if (auto offered = checkProcedureOffered(device.catalogue(), "identify"); !offered) {
        return failure(offered.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Prepare); !entered) {
        return failure(entered.error());
    }
    if (auto checked = check(device.catalogue(), config); !checked) {
        return failure(checked.error());
    }
    std::vector<std::string> others;
    for (const devices::AxisSpec& axis : device.catalogue().axes) {
        for (const std::string& name : {targetOf(axis), axis.generator + ".shape"}) {
            if (device.catalogue().findParameter(name) != nullptr) {
                others.push_back(name);
            }
        }
    }
    auto guard = RestoreGuard::take(device, others);
    if (!guard) {
        return failure(guard.error());
    }
    const MeasuredTiming timing = timingOf(device.catalogue(), guard->snapshot());
    auto result = restoredResult(*guard, measure(device, config, observer, timing));
    const auto entered = enterState(observer, result ? ProcedureState::Done : ProcedureState::Restored);
    if (!result || !entered) {
        return failure(result ? entered.error() : result.error());
    }
    return IdentifyOutcome(*std::move(result));
}

} // namespace

ProcedureEntry<IdentifyConfig, IdentifyOutcome, IdentifyPrediction> axesIdentification() {
    return {setMass, check, predict, identify};
}

} // namespace halbench::app
