#pragma once

#include "app/actuators/actuator.h"
#include "app/experiments/run_outcome.h"

namespace halbench::app {

// From a validated step of an experiment to the configuration of its procedure. Errors: what the procedure's
// own setters say, with the step's place in the file in front.

Result<IdentifyConfig> identifyConfigOf(const ExperimentStep& step, const Actuator& actuator);
FrequencyConfig frequencyConfigOf(const ExperimentStep& step);
/// The same of a device with several axes.
AxesFrequencyConfig axesFrequencyConfigOf(const ExperimentStep& step);
/// Without the model of an earlier step.
RelayConfig relayConfigOf(const ExperimentStep& step);
Result<CalibrateConfig> calibrateConfigOf(const ExperimentStep& step);
Result<MoveConfig> moveConfigOf(const ExperimentStep& step);
/// How often a move is made, for an axis of the device. Errors: InvalidInput (a limit in a unit that the
/// axis has not), of chosenAxis().
Result<RepeatConfig> repeatConfigOf(const devices::Catalogue& catalogue, const ExperimentStep& step);
/// The axis of a move is one of the device's and its reference and limits in units of that. Errors: of
/// chosenAxis(), checkQuantity(), repeatConfigOf().
Result<void> checkAxisOf(const devices::Catalogue& catalogue, const ExperimentStep& step);
/// A recording that waits for a device that is lost (`reconnect`).
bool isWaitingStep(const ExperimentStep& step);
RecordConfig recordConfigOf(const ExperimentStep& step);
control::DesignTargets designTargetsOf(const ExperimentStep& step);
std::vector<ParameterValue> valuesOf(const ExperimentStep& step);

/// Everything that can be judged without moving: configurations, names and limits against the device's
/// catalogue. Errors: as above; UnknownName, NotFinite, OutOfRange of the device.
Result<void> checkAgainstDevice(const Experiment& experiment, const devices::Device& device);

} // namespace halbench::app
