#pragma once

#include "devices/device.h"
#include "models/htm/htm_ideal_loop.h"
#include "models/htm/htm_parameters.h"

#include <optional>

namespace halbench::app {

/// The motor that predictions are made for.
struct KnownMotor {
    models::RotorConfig rotor;
    double torqueConstant_Nm_per_A = 1.43e-2;
};

/// A simulated motor's own constants without its imperfections, else the published ones for a device of
/// model htm; nothing for any other device.
std::optional<KnownMotor> knownMotor(const devices::DeviceInfo& device);

/// All parameters of a simulated motor. Errors: of its address; Usage for any other device.
Result<models::HtmParameters> simulatedMotor(const devices::DeviceInfo& device);

} // namespace halbench::app
