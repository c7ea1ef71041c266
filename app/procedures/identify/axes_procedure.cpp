#include "app/procedures/identify/axes_procedure.h"

#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/identify/axes_estimate.h"
#include "app/procedures/identify/axes_run.h"

#include <fmt/format.h>

namespace halbench::app {
namespace {

Result<void> setMass(IdentifyConfig& config, std::string_view symbol, double value) {
    if (symbol != "m") {
        return failure(ErrorCode::UnknownName, fmt::format("this device has no constant '{}'", symbol),
                       "known is m (moving mass of an axis, kg)");
    }
    if (const auto valid = checkGivenInertia(symbol, value); !valid) {
        return valid;
    }
    config.constants = {{"m", value}};
    return {};
}

Result<void> check(const devices::Catalogue& catalogue, const IdentifyConfig& config) {
    return checkAxesOptions(catalogue, config, "leave them out; this device takes an axis and a given m");
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
                                   const ProcedureObserver& observer,
                                   const std::vector<devices::AxisSpec>& axes, const MeasuredTiming& timing) {
    const auto plans = axisPlans(device, axes);
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

/// Generators, and what sends them to the law.
std::vector<std::string> generatorsOf(const devices::Catalogue& catalogue) {
    std::vector<std::string> names;
    for (const devices::AxisSpec& axis : catalogue.axes) {
        for (const std::string& name : {targetOf(axis), axis.generator + ".shape"}) {
            if (catalogue.findParameter(name) != nullptr) {
                names.push_back(name);
            }
        }
    }
    return names;
}

Result<IdentifyOutcome> identify(devices::Device& device, const IdentifyConfig& config,
                                 const ProcedureObserver& observer) {
    return runAxes({check, generatorsOf, measure}, device, config, observer);
}

} // namespace

ProcedureEntry<IdentifyConfig, IdentifyOutcome, IdentifyPrediction> axesIdentification() {
    return {setMass, check, predict, identify};
}

} // namespace halbench::app
