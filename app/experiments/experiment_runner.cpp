#include "app/experiments/experiment_runner.h"

#include "app/analyses/registry/analyses.h"
#include "app/experiments/step_configs.h"
#include "app/experiments/step_runs.h"
#include "app/procedures/base/restored_result.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

struct StepKind {
    const char* kind;
    Result<StepOutcome> (*run)(StepRun&, const ExperimentStep&);
};

constexpr std::array Kinds = {
    StepKind{"identify", runIdentifyStep}, StepKind{"frequency", runFrequencyStep},
    StepKind{"relay", runRelayStep},       StepKind{"calibrate", runCalibrateStep},
    StepKind{"tune", runTuneStep},         StepKind{"analyse", runAnalyseStep},
    StepKind{"apply", runApplyStep},       StepKind{"move", runMoveStep},
    StepKind{"record", runRecordStep},     StepKind{"set", runSetStep},
    StepKind{"wait", runWaitStep},
};

bool records(const std::string& kind) {
    return kind == "identify" || kind == "frequency" || kind == "relay" || kind == "move" || kind == "record";
}

Result<StepOutcome> runStep(StepRun& run, const ExperimentStep& step) {
    for (const StepKind& entry : Kinds) {
        if (step.kind == entry.kind) {
            const auto before = records(step.kind) ? devices::parameterNotes(run.device)
                                                   : std::vector<devices::RecordingMeta::ParameterNote>();
            Result<StepOutcome> outcome = entry.run(run, step);
            if (outcome) {
                outcome->parametersBefore = before;
            }
            return outcome;
        }
    }
    if (const Analysis* analysis = findAnalysis(step.kind)) {
        return runAnalysisStep(run, step, *analysis);
    }
    return failure(ErrorCode::Internal, "step kind '" + step.kind + "' has no runner");
}

bool hasRefusal(const std::vector<StepOutcome>& steps) {
    for (const StepOutcome& step : steps) {
        if (step.quality.verdict == Verdict::Refused) {
            return true;
        }
    }
    return false;
}

/// Names the step in an error of its procedure.
Error inStep(const ExperimentStep& step, Error error) {
    error.message = fmt::format("step \"{}\": {}", step.name, error.message);
    return error;
}

} // namespace

RunOutcome runExperiment(CommandContext& context, devices::Device& device, const Experiment& experiment,
                         std::uint64_t seed, const std::string& folder) {
    RunOutcome outcome;
    for (const ExperimentStep& step : experiment.steps) {
        const Result<void> fits =
            step.kind == "move" ? checkAxisOf(device.catalogue(), step) : Result<void>();
        if (!fits) {
            outcome.stoppedBy = inStep(step, fits.error());
            return outcome;
        }
    }
    Result<RestoreGuard> guard = RestoreGuard::take(device);
    if (!guard) {
        outcome.stoppedBy = guard.error();
        return outcome;
    }
    outcome.parametersAtStart = guard->snapshot();
    StepRun run{context, device, seed, folder, outcome.steps};
    for (const ExperimentStep& step : experiment.steps) {
        context.console.log(LogLevel::Info, fmt::format("{} \"{}\"", step.kind, step.name));
        Result<StepOutcome> done = checkInterrupt(context).and_then([&] { return runStep(run, step); });
        if (!done) {
            outcome.stoppedBy = inStep(step, done.error());
            break;
        }
        done->kind = step.kind;
        done->name = step.name;
        outcome.steps.push_back(*std::move(done));
    }
    if (!outcome.stoppedBy) {
        guard->keep();
    } else if (const auto restored = guard->restore(); !restored) {
        outcome.stoppedBy = unconfirmedRestore(*outcome.stoppedBy, restored.error());
    }
    outcome.checks = judgeChecks(experiment.checks, outcome.steps);
    outcome.passed = !outcome.stoppedBy && !hasRefusal(outcome.steps);
    for (const CheckOutcome& check : outcome.checks) {
        outcome.passed = outcome.passed && check.passed;
    }
    return outcome;
}

} // namespace halbench::app
