#pragma once

#include "app/procedures/base/procedure_entry.h"
#include "app/procedures/calibrate/calibrate_procedure.h"
#include "app/procedures/identify/axes_identification.h"

#include <span>
#include <string_view>

namespace halbench::app {

using IdentifyEntry = ProcedureEntry<IdentifyConfig, IdentifyOutcome, IdentifyPrediction>;
using CalibrateEntry = ProcedureEntry<CalibrateConfig, CalibrateResult, CalibratePrediction>;

/// A published figure that another published figure contradicts.
struct Contradiction {
    const char* said;
    const char* follows;  ///< from the publication's own numbers
    const char* decision; ///< what this program does
};

/// A constant that a user may know, for example from a balance, and give to the identification.
struct KnownConstant {
    std::string_view symbol; ///< as IdentifyEntry::setGiven takes it
    std::string_view unit;   ///< SI
    std::string_view title;
};

/// One kind of actuator: the procedures that it performs in its own way.
struct Actuator {
    std::string_view model; ///< of the profile
    std::string_view title;
    IdentifyEntry identify;
    CalibrateEntry calibrate;
    /// The calibration from a recorded motion instead of a device, with the board's values as the recording
    /// notes them; nullptr where it takes the device. Errors: UnknownName, InvalidInput, Usage, OutOfRange,
    /// that of `checkAbort`.
    Result<CalibrateResult> (*calibrateRecording)(const Recording& recording,
                                                  const std::vector<ParameterValue>& noted,
                                                  const CalibrateConfig& config,
                                                  const AbortCheck& checkAbort) = nullptr;
    std::span<const Contradiction> contradictions = {};
    std::span<const KnownConstant> knownConstants = {}; ///< a form has a field for each
    /// Values that are each in range but impossible together with the others on the device. Errors:
    /// OutOfRange, of the device; nullptr where none are.
    Result<void> (*checkTogether)(devices::Device& device, std::span<const ParameterValue> values) = nullptr;
};

/// The table of actuators, one row each.
std::span<const Actuator> actuators();

/// Adds a row, for tests: before the first device is opened, since the table is not guarded. A row of the
/// same model is replaced.
void addActuator(const Actuator& actuator);

/// The row of a model. A board without a profile is judged by its signals and parameters and takes the first
/// row, of one axis that turns.
const Actuator& actuatorOf(std::string_view model);

/// Writes values that a user chose, in one transaction, unless they are impossible together. Errors: of
/// Actuator::checkTogether and of the device.
Result<void> writeChosenValues(devices::Device& device, std::span<const ParameterValue> values);

} // namespace halbench::app
