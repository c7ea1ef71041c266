#include "app/cli/tuning_source.h"

#include "app/cli/identify_options.h"
#include "app/headless/command_header.h"
#include "app/tuning/loop_conditions.h"
#include "control/design/design_targets.h"

#include <algorithm>

namespace halbench::app {

namespace {

/// A target that no motor can have, or not on this board, is refused before one is moved to be identified.
Result<void> checkBeforeMotion(const TuneConfig& config, const LoopConditions& conditions) {
    const auto& methods = control::designMethods();
    const auto method = std::find_if(methods.begin(), methods.end(),
                                     [&](const auto& known) { return known.name == config.method; });
    const auto targets = targetsOnBoard(config.method, config.targets, conditions);
    return targets ? control::checkTargets(*method, conditions.timing, *targets) : failure(targets.error());
}

} // namespace

Result<TuningSource> sourceFromFile(const CommandContext& context, const std::string& path) {
    Result<ModelFile> model = readModelFile(path);
    if (!model) {
        return failure(model.error());
    }
    TuningSource source;
    source.header = headerFor(context, "halbench.gains/1");
    source.header.device = model->device;
    source.header.seed = context.global.seed.value_or(model->seed);
    const Result<LoopConditions> conditions = loopConditionsOf(*model);
    if (!conditions) {
        return failure(conditions.error());
    }
    source.estimate = std::move(model->estimate);
    source.conditions = *conditions;
    return source;
}

Result<TuningSource> sourceFromDevice(CommandContext& context, const TuneOptions& options,
                                      const TuneConfig& wanted, std::unique_ptr<devices::Device> device) {
    SweepOptions sweep;
    sweep.given = options.given;
    Result<IdentifyConfig> config = identifyConfigFrom(sweep, options.axis, actuatorOf(device->info().model));
    if (!config) {
        return failure(config.error());
    }
    TuningSource source;
    source.header = headerFor(context, "halbench.gains/1", *device);
    config->seed = source.header.seed;
    const Result<LoopConditions> conditions = loopConditionsOf(*device);
    if (!conditions) {
        return failure(conditions.error());
    }
    const Result<void> possible =
        options.gainsFile.empty() ? checkBeforeMotion(wanted, *conditions) : Result<void>();
    if (!possible) {
        return failure(possible.error());
    }
    source.conditions = *conditions;
    const Result<IdentifyResult> identified = runIdentify(*device, *config, observerFor(context));
    if (!identified) {
        return failure(identified.error());
    }
    source.estimate = motorEstimate(*identified);
    source.device = std::move(device);
    return source;
}

} // namespace halbench::app
