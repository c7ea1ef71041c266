#pragma once

#include "app/analyses/analysis.h"
#include "app/experiments/run_outcome.h"
#include "app/headless/command_context.h"
#include "app/tuning/loop_conditions.h"

namespace halbench::app {

/// Input of every step of a run: the device and the results of the steps before it.
struct StepRun {
    CommandContext& context;
    devices::Device& device;
    std::uint64_t seed;
    const std::string& folder; ///< where recordings go as they come; empty: nowhere
    const std::vector<StepOutcome>& earlier;

    /// The detail of an earlier step of this type, nullptr without one.
    template <typename Detail>
    const Detail* find(const std::string& name) const {
        for (const StepOutcome& step : earlier) {
            if (step.name == name) {
                return std::get_if<Detail>(&step.detail);
            }
        }
        return nullptr;
    }
};

/// Says that an earlier step has nothing that a later one could use.
Error missingResult(const std::string& step);

/// The surroundings of the loop on this device, with what the run's calibrations found of the stray field.
/// Errors: of the device.
Result<LoopConditions> conditionsOf(StepRun& run);

// Steps of kind tune, apply and analyse on a device with several axes; the functions below decide by it.
Result<StepOutcome> tuneAxesStep(StepRun& run, const ExperimentStep& step);
Result<StepOutcome> applyAxesStep(StepRun& run, const ExperimentStep& step, const TuneAxesOutcome& tuned);

// One function a kind. Name and kind of the outcome are set by the caller. Errors: of the procedure.
Result<StepOutcome> runIdentifyStep(StepRun& run, const ExperimentStep& step);
Result<StepOutcome> runFrequencyStep(StepRun& run, const ExperimentStep& step);
Result<StepOutcome> runRelayStep(StepRun& run, const ExperimentStep& step);
Result<StepOutcome> runCalibrateStep(StepRun& run, const ExperimentStep& step);
Result<StepOutcome> runTuneStep(StepRun& run, const ExperimentStep& step);
Result<StepOutcome> runAnalyseStep(StepRun& run, const ExperimentStep& step);
Result<StepOutcome> runApplyStep(StepRun& run, const ExperimentStep& step);
Result<StepOutcome> runMoveStep(StepRun& run, const ExperimentStep& step);
Result<StepOutcome> runRecordStep(StepRun& run, const ExperimentStep& step);
Result<StepOutcome> runSetStep(StepRun& run, const ExperimentStep& step);
Result<StepOutcome> runWaitStep(StepRun& run, const ExperimentStep& step);
Result<StepOutcome> runAnalysisStep(StepRun& run, const ExperimentStep& step, const Analysis& analysis);

} // namespace halbench::app
