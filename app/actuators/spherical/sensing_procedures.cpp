#include "app/actuators/spherical/sensing_procedures.h"

#include "app/actuators/spherical/sensing_board.h"
#include "app/actuators/spherical/sensing_calibrate.h"
#include "app/actuators/spherical/sensing_contradictions.h"
#include "app/procedures/base/offered_procedure.h"

namespace halbench::app {
namespace {

// What the profile does not offer, in the words of every procedure.
Error driveMissing() {
    return {ErrorCode::Usage, "this device senses and does not drive: there is nothing to identify",
            "use calibrate or record"};
}

Result<void> setNothing(IdentifyConfig&, std::string_view, double) {
    return failure(driveMissing());
}

Result<void> checkNothing(const devices::Catalogue& catalogue, const IdentifyConfig&) {
    const auto offered = checkProcedureOffered(catalogue, "identify");
    return failure(offered ? driveMissing() : offered.error());
}

IdentifyPrediction predictNothing(const IdentifyConfig&, double) {
    return {};
}

Result<IdentifyOutcome> identifyNothing(devices::Device& device, const IdentifyConfig& config,
                                        const ProcedureObserver&) {
    return failure(checkNothing(device.catalogue(), config).error());
}

} // namespace

Actuator sensingActuator() {
    return {"spherical",
            "Spherical motor, orientation sensing",
            {setNothing, checkNothing, predictNothing, identifyNothing},
            {nullptr, checkSensingCalibrate, predictSensingCalibrate, calibrateSensing},
            calibrateSensingRecording,
            sensingContradictions(),
            {},
            checkSensorPlaces};
}

} // namespace halbench::app
