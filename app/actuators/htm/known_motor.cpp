#include "app/actuators/htm/known_motor.h"

#include "devices/device_uri.h"
#include "devices/simulated/htm/simulated_htm.h"

namespace halbench::app {

std::optional<KnownMotor> knownMotor(const devices::DeviceInfo& device) {
    if (device.model != "htm") {
        return std::nullopt;
    }
    KnownMotor motor;
    const Result<devices::DeviceUri> uri = devices::parseDeviceUri(device.uri);
    if (!uri || uri->scheme != "sim") {
        return motor;
    }
    if (const Result<models::HtmParameters> simulated = devices::htmParameters(uri->options)) {
        motor.rotor.inertia_kg_m2 = simulated->inertia_kg_m2;
        motor.rotor.viscousDamping_Nm_s = simulated->viscousDamping_Nm_s;
        motor.rotor.coulombFriction_Nm = simulated->coulombFriction_Nm;
        motor.torqueConstant_Nm_per_A = simulated->torqueConstant_Nm_per_A;
    }
    return motor;
}

Result<models::HtmParameters> simulatedMotor(const devices::DeviceInfo& device) {
    const Result<devices::DeviceUri> uri = devices::parseDeviceUri(device.uri);
    if (!uri) {
        return failure(uri.error());
    }
    if (uri->scheme != "sim" || device.model != "htm") {
        return failure(ErrorCode::Usage, "the parts of a motor are known of a simulated one only",
                       "use --device sim:htm");
    }
    return devices::htmParameters(uri->options);
}

} // namespace halbench::app
