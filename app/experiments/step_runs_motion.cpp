#include "app/actuators/actuator.h"
#include "app/documents/result_documents.h"
#include "app/documents/result_header.h"
#include "app/experiments/step_configs.h"
#include "app/experiments/step_runs.h"
#include "app/headless/command_header.h"
#include "app/headless/reconnecting_device.h"
#include "app/headless/recording_file.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/move/move_prediction.h"
#include "app/procedures/tune/loop_axis.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "app/tuning/axis_conditions.h"
#include "control/base/units.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

/// While it lives, the loss of the device is waited out if the step says so.
class ReturnWait {
public:
    ReturnWait(StepRun& run, const ExperimentStep& step, RecordingOutput& file)
        : m_device(isWaitingStep(step) ? dynamic_cast<devices::ReturningDevice*>(&run.device) : nullptr) {
        if (m_device != nullptr) {
            m_device->setEvents(eventsTo(warningsTo(run.context.console), file));
            m_device->setWaiting(true);
        }
    }
    ~ReturnWait() {
        if (m_device != nullptr) {
            m_device->setEvents({});
            m_device->setWaiting(false);
        }
    }
    ReturnWait(const ReturnWait&) = delete;
    ReturnWait& operator=(const ReturnWait&) = delete;

    Result<void> present() const {
        const bool isAway = m_device != nullptr && m_device->lost();
        return isAway ? failure(*m_device->lost()) : Result<void>();
    }

private:
    devices::ReturningDevice* m_device;
};

/// This key is in degrees.
Result<void> checkKeysOfAxis(const devices::Catalogue& catalogue, const ExperimentStep& step) {
    if (catalogue.axes.size() > 1 && step.find("lock_threshold_deg") != nullptr) {
        return failure(
            ErrorCode::InvalidInput,
            fmt::format("step \"{}\": 'lock_threshold_deg' is not for a device with several axes", step.name),
            "Leave it out.");
    }
    return {};
}

/// What the model of the last tuning foresees of a move, where it has that axis.
Result<std::optional<MoveFigures>> predictedOf(StepRun& run, const MoveConfig& config) {
    const TuneAxesOutcome* tuned = nullptr;
    for (const StepOutcome& earlier : run.earlier) {
        const auto* axes = std::get_if<TuneAxesOutcome>(&earlier.detail);
        tuned = axes != nullptr ? axes : tuned;
    }
    const IdentifiedAxis* axis = tuned != nullptr ? tuned->model.find(config.axis) : nullptr;
    if (axis == nullptr) {
        return std::optional<MoveFigures>();
    }
    const auto conditions = axisConditionsOf(run.device, {config.axis});
    return conditions ? predictAxisMove(run.device, config, estimateOfAxis(tuned->model, *axis),
                                        conditions->front().currentLimit_A)
                      : failure(conditions.error());
}

} // namespace

Result<StepOutcome> runMoveStep(StepRun& run, const ExperimentStep& step) {
    Result<MoveConfig> config = moveConfigOf(step);
    if (!config) {
        return failure(config.error());
    }
    const Result<control::SampledPositionLaw> law = readPositionLaw(run.device);
    if (!law) {
        return failure(law.error());
    }
    if (const Result<void> fits = checkKeysOfAxis(run.device.catalogue(), step); !fits) {
        return failure(fits.error());
    }
    const Result<RepeatConfig> repeat = repeatConfigOf(run.device.catalogue(), step);
    if (!repeat) {
        return failure(repeat.error());
    }
    const auto predicted = predictedOf(run, *config);
    if (!predicted) {
        return failure(predicted.error());
    }
    Result<RepeatedMove> result = runRepeatedMove(run.device, *config, *repeat, observerFor(run.context));
    if (!result) {
        return failure(result.error());
    }
    StepOutcome outcome;
    outcome.quality = result->last.quality;
    if (!result->last.isOneOfSeveral()) {
        outcome.body = moveBody(result->last);
    } else {
        outcome.body.set("axes", movedAxes(result->last, *predicted));
    }
    if (result->last.contour) {
        outcome.body.set("contour", contourBody(*result->last.contour));
    }
    const bool isOneOfSeveral = result->last.isOneOfSeveral();
    const std::string unit = isOneOfSeveral ? result->last.axis.positionUnit : std::string("deg");
    MoveOutcome detail{*std::move(config), *law, std::move(result->last), std::nullopt};
    if (step.find("repeat") != nullptr) {
        outcome.body.set("repetition", repetitionBody(result->repetition, unit));
        detail.repetition = std::move(result->repetition);
    }
    outcome.detail = std::move(detail);
    return outcome;
}

Result<StepOutcome> runRecordStep(StepRun& run, const ExperimentStep& step) {
    RecordingOutput file(run.device, run.folder + "/" + step.name + ".csv",
                         headerFor(run.context, "halbench.run/1", run.device).started,
                         warningsTo(run.context.console));
    Recording kept; // for the report
    RecordOutlet outlet = file.outlet();
    outlet.append = [&kept, toFile = outlet.append](const SampleBlock& block) {
        kept.append(block);
        return toFile(block);
    };
    const bool isStreamed = !run.folder.empty();
    const ReturnWait wait(run, step, file);
    Result<RecordResult> result =
        runRecord(run.device, recordConfigOf(step), observerFor(run.context), isStreamed ? &outlet : nullptr);
    if (result && result->trigger_s && isStreamed) {
        file.addMarker(*result->trigger_s, "trigger");
    }
    const Result<void> present = wait.present(); // away when the time was over: the recording is cut
    const Result<void> done = !result      ? failure(result.error())
                              : !present   ? present
                              : isStreamed ? file.finish()
                                           : Result<void>();
    if (!done) {
        return failure(file.stopped(done.error()));
    }
    if (isStreamed) {
        result->recording = std::move(kept);
    }
    StepOutcome outcome;
    outcome.isStreamed = isStreamed;
    outcome.quality = result->quality;
    outcome.body.set("rows", static_cast<std::uint64_t>(result->rows));
    outcome.body.set("lost_rows", result->lostRows);
    if (result->trigger_s) {
        outcome.body.set("trigger_s", *result->trigger_s);
    }
    if (isWaitingStep(step)) {
        outcome.body.set("gaps", static_cast<std::uint64_t>(result->gaps));
        outcome.body.set("gaps_s", result->gaps_s);
    }
    outcome.detail = *std::move(result);
    return outcome;
}

Result<StepOutcome> runSetStep(StepRun& run, const ExperimentStep& step) {
    const std::vector<ParameterValue> values = valuesOf(step);
    if (const Result<void> written = writeChosenValues(run.device, values); !written) {
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
