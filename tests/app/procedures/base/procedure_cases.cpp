#include "tests/app/procedures/base/procedure_cases.h"

#include "app/procedures/apply/apply_procedure.h"
#include "app/procedures/apply/live_apply_procedure.h"
#include "app/procedures/calibrate/calibrate_procedure.h"
#include "app/procedures/frequency/frequency_procedure.h"
#include "app/procedures/identify/identify_procedure.h"
#include "app/procedures/move/move_procedure.h"
#include "app/procedures/record/capture_procedure.h"
#include "app/procedures/record/record_procedure.h"
#include "app/procedures/relay/relay_procedure.h"
#include "tests/app/procedures/uncertain_motor.h"

namespace halbench::app {
namespace {

using State = ProcedureState;

template <typename T>
Result<void> withoutValue(const Result<T>& result) {
    return result ? Result<void>() : Result<void>(failure(result.error()));
}

MotorEstimate publishedMotor() {
    MotorEstimate motor;
    motor.values = {{"J", 5.5e-4}, {"c", 1.23e-3}, {"Kf", 2.05e-2}, {"phi", 1.43e-2}};
    return motor;
}

Result<void> record(devices::Device& device, const ProcedureObserver& observer) {
    RecordConfig config;
    config.duration_s = 0.5;
    return withoutValue(runRecord(device, config, observer));
}

Result<void> captureSpeed(devices::Device& device, const ProcedureObserver& observer) {
    CaptureConfig config;
    config.signals = {"speed"};
    return withoutValue(runCapture(device, config, observer));
}

Result<void> moveOneStep(devices::Device& device, const ProcedureObserver& observer) {
    MoveConfig config;
    config.reference.amplitude = 1.7;
    config.duration_s = 1.0;
    return withoutValue(runMove(device, config, observer));
}

constexpr double NewGain_A_per_rad = 12.0;

Result<void> applyVerified(devices::Device& device, const ProcedureObserver& observer) {
    ApplyConfig config;
    config.values = {{"gain.kp", NewGain_A_per_rad}, {"gain.kd", 0.2}};
    config.verification.emplace();
    config.verification->reference.amplitude = 1.7;
    config.verification->duration_s = 1.5;
    config.verification->motor = publishedMotor();
    return withoutValue(runApply(device, config, observer));
}

Result<void> applyInSteps(devices::Device& device, const ProcedureObserver& observer) {
    LiveApplyConfig config;
    config.motor = uncertainMotor(0.02);
    config.target.gains.proportional = NewGain_A_per_rad;
    config.target.gains.derivative = 0.05;
    config.duration_s = 1.0;
    return withoutValue(runLiveApply(device, config, observer));
}

Result<void> identifyShortly(devices::Device& device, const ProcedureObserver& observer) {
    IdentifyConfig config;
    config.sweep = {2.0, 4.0, 0.5};
    config.directions = SweepDirections::Forward;
    config.coastDownsPerDirection = 1;
    return withoutValue(runIdentify(device, config, observer));
}

Result<void> identifyFrequency(devices::Device& device, const ProcedureObserver& observer) {
    FrequencyConfig config;
    config.from_Hz = 2.0;
    config.to_Hz = 6.0;
    config.periods = 4;
    return withoutValue(runFrequency(device, config, {}, observer));
}

Result<void> relayShortly(devices::Device& device, const ProcedureObserver& observer) {
    RelayConfig config;
    config.cycles = 40;
    return withoutValue(runRelay(device, config, observer));
}

Result<void> calibrateAndApply(devices::Device& device, const ProcedureObserver& observer) {
    CalibrateConfig config;
    config.apply = true;
    config.frictionStarts = 2;
    return withoutValue(runCalibrate(device, config, observer));
}

} // namespace

std::vector<ProcedureCase> procedureCases() {
    return {
        {"record", {State::Prepare, State::Record, State::Done}, record, {}, true},
        {"capture", {State::Prepare, State::Record, State::Done}, captureSpeed, {}, true},
        {"move", {State::Prepare, State::Excite, State::Record, State::Judge, State::Done}, moveOneStep, {}},
        {"apply",
         {State::Prepare, State::Propose, State::Apply, State::Verify, State::Done},
         applyVerified,
         NewGain_A_per_rad},
        {"live_apply",
         {State::Prepare, State::Propose, State::Apply, State::Verify, State::Done},
         applyInSteps,
         NewGain_A_per_rad},
        {"identify",
         {State::Prepare, State::Excite, State::Record, State::Fit, State::Judge, State::Done},
         identifyShortly,
         {}},
        {"frequency",
         {State::Prepare, State::Excite, State::Record, State::Fit, State::Judge, State::Done},
         identifyFrequency,
         {}},
        {"relay",
         {State::Prepare, State::Excite, State::Record, State::Fit, State::Judge, State::Done},
         relayShortly,
         {}},
        {"calibrate",
         {State::Prepare, State::Excite, State::Propose, State::Apply, State::Verify, State::Done},
         calibrateAndApply,
         {}},
    };
}

} // namespace halbench::app
