#include "app/documents/axis_loop_documents.h"
#include "app/experiments/step_configs.h"
#include "app/experiments/step_runs.h"
#include "app/procedures/base/doubtful_source.h"
#include "app/tuning/axis_conditions.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::app {

namespace {

/// Of an identify step, or of a file of the same kind of device.
Result<AxisModel> modelOf(const StepRun& run, const ExperimentStep& step) {
    if (const std::optional<std::string> path = step.text("model_file")) {
        auto file = readAxisModelFile(*path);
        if (!file) {
            return failure(file.error());
        }
        const auto& identified = file->header.device;
        if (identified && identified->model != run.device.info().model) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("{}: the model is of a device '{}', this one is a '{}'", *path,
                                       identified->model, run.device.info().model),
                           "identify this device and use its model for tuning");
        }
        return std::move(file->model);
    }
    const std::string name = *step.text("model");
    const auto found = std::find_if(run.earlier.begin(), run.earlier.end(),
                                    [&](const StepOutcome& earlier) { return earlier.name == name; });
    if (found == run.earlier.end()) {
        return failure(missingResult(name));
    }
    auto model = axisModelOf(found->body, "step \"" + name + "\"");
    if (!model) {
        return failure(model.error());
    }
    if (!*model) {
        return failure(missingResult(name));
    }
    (*model)->doubts = doubtsOfModel(found->quality);
    return **std::move(model);
}

Result<void> checkTimings(const AxisModel& model, const AxisConditions& conditions) {
    for (const LoopConditions& each : conditions) {
        const std::string& id = each.axis.value().id;
        if (const auto same = checkTimingOfModel(model.find(id)->timing, each.timing); !same) {
            return failure(same.error().code, fmt::format("axis {}: {}", id, same.error().message),
                           same.error().hint);
        }
    }
    return {};
}

} // namespace

Result<StepOutcome> tuneAxesStep(StepRun& run, const ExperimentStep& step) {
    auto model = modelOf(run, step);
    const auto axes = model ? chosenAxesOf(*model, step.text("axis").value_or("")) : failure(model.error());
    if (!axes) {
        return failure(axes.error());
    }
    const auto conditions = axisConditionsOf(run.device, *axes);
    const auto fits = conditions ? checkTimings(*model, *conditions) : failure(conditions.error());
    if (!fits) {
        return failure(fits.error());
    }
    TuneAxesConfig config;
    config.method = step.text("method").value_or(config.method);
    config.targets = designTargetsOf(step);
    config.seed = run.seed;
    auto result = tuneAxes(*model, *conditions, config);
    if (!result) {
        return failure(result.error());
    }
    StepOutcome outcome;
    outcome.quality = result->quality;
    outcome.body = axisGainsBody(*result);
    outcome.detail = TuneAxesOutcome{*std::move(model), *std::move(result)};
    return outcome;
}

Result<StepOutcome> applyAxesStep(StepRun& run, const ExperimentStep& step, const TuneAxesOutcome& tuned) {
    if (step.find("verify_step_deg") != nullptr) {
        return failure(ErrorCode::InvalidInput, "'verify_step_deg' is not for a device with several axes",
                       "leave it out: every axis makes the test step of its profile");
    }
    if (tuned.result.quality.verdict == Verdict::Refused) {
        return failure(ErrorCode::Refused, "the gains of this step are rejected; nothing was written",
                       "see the findings of the tune step");
    }
    const auto config = applyAxesConfig(run.device.catalogue(), tuned.model, tuned.result);
    if (!config) {
        return failure(config.error());
    }
    auto result = runApplyAxes(run.device, *config, observerFor(run.context));
    if (!result) {
        return failure(result.error());
    }
    StepOutcome outcome;
    outcome.quality = result->quality;
    outcome.quality.verdict = result->isKept ? outcome.quality.verdict : Verdict::Refused;
    outcome.body = appliedAxesBody(*result);
    outcome.detail = *std::move(result);
    return outcome;
}

} // namespace halbench::app
