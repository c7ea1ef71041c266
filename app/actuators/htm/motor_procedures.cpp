#include "app/actuators/htm/motor_procedures.h"

#include "app/actuators/htm/motor_contradictions.h"
#include "app/procedures/base/axis_choice.h"
#include "app/procedures/identify/identify_plan.h"

#include <array>

namespace halbench::app {
namespace {

constexpr std::array MotorConstants = {
    KnownConstant{"J", "kg*m^2", "Inertia"}, KnownConstant{"c", "N*m*s/rad", "Viscous damping"},
    KnownConstant{"Kf", "N*m", "Coulomb friction"}, KnownConstant{"phi", "N*m/A", "Torque constant"}};

Result<void> checkOnlyAxis(const devices::Catalogue& catalogue, const std::string& name) {
    if (catalogue.axes.empty() && name.empty()) {
        return {}; // a board without a profile is judged by its signals
    }
    const auto axes = chosenAxes(catalogue, name);
    return axes ? Result<void>() : failure(axes.error());
}

Result<void> setMotorConstant(IdentifyConfig& config, std::string_view symbol, double value) {
    return setGivenConstant(config.given, symbol, value);
}

Result<void> checkIdentify(const devices::Catalogue& catalogue, const IdentifyConfig& config) {
    if (auto axis = checkOnlyAxis(catalogue, config.axis); !axis) {
        return axis;
    }
    const ParameterSpec* limit = catalogue.findParameter(catalogue.parameterForRole("limit.current"));
    const auto currents_A = sweepCurrents_A(config.sweep, limit == nullptr ? 1e9 : limit->max);
    return currents_A ? Result<void>() : failure(currents_A.error());
}

Result<IdentifyOutcome> identify(devices::Device& device, const IdentifyConfig& config,
                                 const ProcedureObserver& observer) {
    if (auto axis = checkOnlyAxis(device.catalogue(), config.axis); !axis) {
        return failure(axis.error());
    }
    Result<IdentifyResult> result = runIdentify(device, config, observer);
    return result ? Result<IdentifyOutcome>(*std::move(result)) : failure(result.error());
}

Result<void> checkCalibrate(const devices::Catalogue&, const CalibrateConfig&) {
    return {};
}

CalibratePrediction predict(const CalibrateConfig& config, double) {
    return predictCalibrate(config);
}

} // namespace

Actuator motorActuator() {
    return {"htm",
            "Halbach torque motor",
            {setMotorConstant, checkIdentify, predictIdentify, identify},
            {nullptr, checkCalibrate, predict, runCalibrate},
            nullptr,
            motorContradictions(),
            MotorConstants};
}

} // namespace halbench::app
