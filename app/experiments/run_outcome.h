#pragma once

#include "app/actuators/htm/amplifier_analysis.h"
#include "app/actuators/htm/motor_analysis.h"
#include "app/analyses/analysis.h"
#include "app/documents/text/json_value.h"
#include "app/experiments/experiment.h"
#include "app/procedures/apply/apply_axes.h"
#include "app/procedures/calibrate/calibrate_procedure.h"
#include "app/procedures/frequency/axes_frequency.h"
#include "app/procedures/frequency/frequency_procedure.h"
#include "app/procedures/identify/axes_identification.h"
#include "app/procedures/move/move_procedure.h"
#include "app/procedures/move/move_repetition.h"
#include "app/procedures/record/record_procedure.h"
#include "app/procedures/relay/relay_procedure.h"
#include "app/procedures/tune/tune.h"
#include "devices/recording/recording_meta.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace halbench::app {

/// A move with what ran it: the law on the board, for the report's ideal loop.
struct MoveOutcome {
    MoveConfig config;
    control::SampledPositionLaw law;
    MoveResult result; ///< of a repeated move: the last run
    std::optional<MoveRepetition> repetition;
};

/// Gains with the motor they were designed for.
struct TuneOutcome {
    MotorEstimate motor;
    TuneResult result;
    std::uint64_t seed = 1; ///< of the motors that were drawn
};

/// Loops of several axes with the model they were designed for.
struct TuneAxesOutcome {
    AxisModel model;
    TuneAxesResult result;
};

/// The procedure's own result, for later steps and the report.
using StepDetail =
    std::variant<std::monostate, IdentifyResult, AxesIdentifyResult, FrequencyResult, AxesFrequencyResult,
                 RelayResult, CalibrateResult, TuneOutcome, AnalysisResult, AmplifierAnalysis, MotorAnalysis,
                 ApplyResult, MoveOutcome, RecordResult, TuneAxesOutcome, ApplyAxesResult, AnalysisOutcome>;

struct StepOutcome {
    std::string kind;
    std::string name;
    DataQuality quality;
    JsonValue body = JsonValue::object(); ///< as in result.json; checks look their quantities up here
    StepDetail detail;
    /// Of a step that records: on the board when it began.
    std::vector<devices::RecordingMeta::ParameterNote> parametersBefore;
    bool isStreamed = false; ///< NAME.csv was written while it recorded

    /// What is written as NAME.csv; nullptr when the step recorded nothing.
    const Recording* recording() const;
};

struct CheckOutcome {
    std::string quantity; ///< STEP.QUANTITY
    std::optional<double> value;
    std::string unit;
    std::optional<double> min;
    std::optional<double> max;
    std::string reason;
    bool passed = false;
};

/// Result of a whole run. `stoppedBy` holds the error of a step that ended it early.
struct RunOutcome {
    std::vector<StepOutcome> steps;
    std::vector<CheckOutcome> checks;
    std::vector<ParameterValue> parametersAtStart; ///< on the board, before the first step
    std::optional<Error> stoppedBy;
    bool passed = false;
};

/// A number in a step's body by its path: members by name (a name may hold dots), items by index. `.ci95_lo`
/// and `.ci95_hi` mean the ends of the interval beside `.value`; J, c, Kf and phi stand for the long names of
/// parameters. Nothing when it is missing or not a number.
std::optional<double> findQuantity(const JsonValue& body, const std::string& path);

/// Unit of a quantity: the member "unit" beside it, else what its name ends with.
std::string quantityUnit(const JsonValue& body, const std::string& path);

/// Judges every check; a missing step, missing quantity or non-finite value fails.
std::vector<CheckOutcome> judgeChecks(const std::vector<ExperimentCheck>& checks,
                                      const std::vector<StepOutcome>& steps);

} // namespace halbench::app
