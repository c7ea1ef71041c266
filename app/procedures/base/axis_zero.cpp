#include "app/procedures/base/axis_zero.h"

#include "app/procedures/base/procedure_steps.h"

namespace halbench::app {
namespace {

Result<bool> hasZero(devices::Device& device, const std::string& signal) {
    const std::string names[] = {signal};
    const auto values = device.readSignals(names);
    return values ? Result<bool>(values->front() > 0.5) : failure(values.error());
}

Result<void> home(devices::Device& device, const std::string& order, const ProcedureObserver& observer) {
    // The board homes nothing that is driven, and what was just disarmed brakes for up to 0.3 s.
    constexpr double Homing_s = 0.05, Braking_s = 0.35;
    const ParameterValue values[] = {{order, 1.0}};
    auto written = device.writeParameters(values);
    if (!written) {
        if (auto waited = waitObserved(device, observer, Braking_s, 0.0, 0.0, "homes"); !waited) {
            return waited;
        }
        written = device.writeParameters(values);
    }
    return written ? waitObserved(device, observer, Homing_s, 0.0, 0.0, "homes") : written;
}

} // namespace

Result<bool> awaitZero(devices::Device& device, const ProcedureObserver& observer) {
    const std::string signal = device.catalogue().signalForRole("homed");
    const std::string order = device.catalogue().parameterForRole("home");
    if (signal.empty()) {
        return false;
    }
    auto isKnown = hasZero(device, signal);
    const bool isHomedNow = isKnown && !*isKnown && !order.empty();
    if (isHomedNow) {
        if (auto homed = home(device, order, observer); !homed) {
            return failure(homed.error());
        }
        isKnown = hasZero(device, signal);
    }
    if (!isKnown) {
        return failure(isKnown.error());
    }
    return *isKnown ? Result<bool>(isHomedNow)
                    : failure(ErrorCode::Refused, "the device has no axis zero and cannot find it",
                              "Check its sensors, home the axes, then start again. Nothing was armed.");
}

Finding homedHere() {
    return {
        "homed_here",
        "the device was not homed: where it stood was taken for its first cell, from which positions and the "
        "ends of travel count",
        "When it stood in another cell, disarm it, bring it to the middle of its travel, set hb.home to 1 "
        "and "
        "start again."};
}

} // namespace halbench::app
