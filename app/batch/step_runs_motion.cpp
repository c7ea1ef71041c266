#include "app/batch/result_documents.h"
#include "app/batch/step_configs.h"
#include "app/batch/step_runs.h"
#include "app/procedures/position_law_parameters.h"
#include "app/procedures/procedure_steps.h"
#include "control/base/units.h"

#include <algorithm>

namespace halbench::app {

namespace {

/// Largest minus smallest position in the evaluated part of a step: the size of a limit cycle.
std::optional<double> peakToPeak_deg(const MoveConfig& config, const Recording& recording) {
    std::vector<double> position = recording.column("truth.position");
    position = position.empty() ? recording.column("position") : position;
    const double from_s = config.evaluateFrom_s.value_or(0.5 * config.duration_s);
    const double to_s = config.evaluateTo_s.value_or(config.duration_s);
    std::vector<double> evaluated;
    for (std::size_t row = 0; row < position.size(); ++row) {
        if (recording.time_s[row] >= from_s && recording.time_s[row] <= to_s) {
            evaluated.push_back(position[row]);
        }
    }
    if (evaluated.empty() || config.reference.shape != MoveReference::Shape::Step) {
        return std::nullopt;
    }
    const auto [smallest, largest] = std::minmax_element(evaluated.begin(), evaluated.end());
    return radiansToDegrees(*largest - *smallest);
}

} // namespace

Result<StepOutcome> runMoveStep(StepRun& run, const ExperimentStep& step) {
    Result<MoveConfig> config = moveConfigOf(step);
    if (!config) {
        return failure(config.error());
    }
    const Result<models::PositionLaw> law = readPositionLaw(run.device);
    if (!law) {
        return failure(law.error());
    }
    Result<MoveResult> result = runMove(run.device, *config, observerFor(run.context));
    if (!result) {
        return failure(result.error());
    }
    StepOutcome outcome;
    outcome.quality = result->quality;
    outcome.body = moveBody(*result);
    outcome.body.set("peak_to_peak_deg", peakToPeak_deg(*config, result->recording));
    outcome.detail = MoveOutcome{*std::move(config), *law, *std::move(result)};
    return outcome;
}

Result<StepOutcome> runRecordStep(StepRun& run, const ExperimentStep& step) {
    Result<RecordResult> result = runRecord(run.device, recordConfigOf(step), observerFor(run.context));
    if (!result) {
        return failure(result.error());
    }
    StepOutcome outcome;
    outcome.quality = result->quality;
    outcome.body.set("rows", static_cast<std::uint64_t>(result->rows));
    outcome.body.set("lost_rows", result->lostRows);
    outcome.detail = *std::move(result);
    return outcome;
}

Result<StepOutcome> runSetStep(StepRun& run, const ExperimentStep& step) {
    const std::vector<ParameterValue> values = valuesOf(step);
    if (const Result<void> written = run.device.writeParameters(values); !written) {
        return failure(written.error());
    }
    StepOutcome outcome;
    outcome.body.set("values", toJson(values));
    return outcome;
}

Result<StepOutcome> runWaitStep(StepRun& run, const ExperimentStep& step) {
    const double duration_s = *step.number("duration_s");
    const Result<void> waited =
        waitObserved(run.device, observerFor(run.context), duration_s, 0.0, 1.0, step.name);
    if (!waited) {
        return failure(waited.error());
    }
    StepOutcome outcome;
    outcome.body.set("duration_s", duration_s);
    return outcome;
}

} // namespace halbench::app
