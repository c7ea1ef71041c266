#include "app/documents/axes_frequency_documents.h"
#include "app/documents/presets.h"
#include "app/documents/relay_document.h"
#include "app/documents/result_documents.h"
#include "app/experiments/step_configs.h"
#include "app/experiments/step_runs.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "control/base/units.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

/// What `apply` writes, and the motor that its prediction is made from.
struct Proposal {
    std::vector<ParameterValue> values;
    std::optional<MotorEstimate> motor;
};

Result<Proposal> proposalOf(StepRun& run, const ExperimentStep& step) {
    Proposal proposal;
    if (const std::optional<std::string> name = step.text("gains")) {
        const TuneOutcome* tuned = run.find<TuneOutcome>(*name);
        if (tuned == nullptr) {
            return failure(missingResult(*name));
        }
        Result<std::vector<ParameterValue>> values =
            lawForDevice(LoopLaw(tuned->result.law, tuned->result.filtered), run.device.catalogue());
        if (!values) {
            return failure(values.error());
        }
        proposal = {*std::move(values), tuned->motor};
    } else {
        Result<Preset> preset = findPreset(run.device.info().model, *step.text("preset"));
        if (!preset) {
            return failure(preset.error());
        }
        proposal.values = std::move(preset->values);
        addPlainShaping(proposal.values, run.device.catalogue());
    }
    if (const std::optional<std::string> name = step.text("model")) {
        const IdentifyResult* model = run.find<IdentifyResult>(*name);
        if (model == nullptr) {
            return failure(missingResult(*name));
        }
        proposal.motor = motorEstimate(*model);
    }
    return proposal;
}

} // namespace

Result<StepOutcome> runIdentifyStep(StepRun& run, const ExperimentStep& step) {
    const Actuator& actuator = actuatorOf(run.device.info().model);
    Result<IdentifyConfig> config = identifyConfigOf(step, actuator);
    if (!config) {
        return failure(config.error());
    }
    config->seed = run.seed;
    if (const std::optional<std::string> bare = step.text("bare")) {
        const IdentifyResult* first = run.find<IdentifyResult>(*bare);
        if (first == nullptr) {
            return failure(missingResult(*bare));
        }
        config->added = AddedInertia{motorEstimate(*first), *step.number("added_inertia_kg_m2")};
    }
    Result<IdentifyOutcome> result = actuator.identify.run(run.device, *config, observerFor(run.context));
    if (!result) {
        return failure(result.error());
    }
    StepOutcome outcome;
    outcome.quality = qualityOf(*result);
    outcome.body = identificationBody(*result);
    std::visit([&outcome](auto& found) { outcome.detail = std::move(found); }, *result);
    return outcome;
}

namespace {

Result<StepOutcome> axesFrequencyStep(StepRun& run, const ExperimentStep& step) {
    Result<AxesFrequencyResult> result =
        runAxesFrequency(run.device, axesFrequencyConfigOf(step), observerFor(run.context));
    if (!result) {
        return failure(result.error());
    }
    StepOutcome outcome;
    outcome.quality = result->quality;
    outcome.body = axesFrequencyBody(*result);
    outcome.detail = *std::move(result);
    return outcome;
}

} // namespace

Result<StepOutcome> runFrequencyStep(StepRun& run, const ExperimentStep& step) {
    if (run.device.catalogue().axes.size() > 1) {
        return axesFrequencyStep(run, step);
    }
    const Result<LoopConditions> conditions = conditionsOf(run);
    if (!conditions) {
        return failure(conditions.error());
    }
    Result<FrequencyResult> result =
        runFrequency(run.device, frequencyConfigOf(step), conditions->stray, observerFor(run.context));
    if (!result) {
        return failure(result.error());
    }
    StepOutcome outcome;
    outcome.quality = result->quality;
    outcome.body = frequencyBody(*result);
    outcome.detail = *std::move(result);
    return outcome;
}

Result<StepOutcome> runRelayStep(StepRun& run, const ExperimentStep& step) {
    RelayConfig config = relayConfigOf(step);
    if (const std::optional<std::string> name = step.text("model")) {
        const IdentifyResult* model = run.find<IdentifyResult>(*name);
        if (model == nullptr) {
            return failure(missingResult(*name));
        }
        config.motor = motorEstimate(*model);
    }
    Result<RelayResult> result = runRelay(run.device, config, observerFor(run.context));
    if (!result) {
        return failure(result.error());
    }
    StepOutcome outcome;
    outcome.quality = result->quality;
    outcome.body = relayBody(*result);
    outcome.detail = *std::move(result);
    return outcome;
}

Result<StepOutcome> runCalibrateStep(StepRun& run, const ExperimentStep& step) {
    Result<CalibrateConfig> config = calibrateConfigOf(step);
    if (!config) {
        return failure(config.error());
    }
    config->seed = run.seed;
    const CalibrateEntry& calibrate = actuatorOf(run.device.info().model).calibrate;
    Result<CalibrateResult> result = calibrate.run(run.device, *config, observerFor(run.context));
    if (!result) {
        return failure(result.error());
    }
    StepOutcome outcome;
    outcome.quality = result->quality;
    outcome.body = calibrationBody(*result);
    outcome.detail = *std::move(result);
    return outcome;
}

Result<StepOutcome> runTuneStep(StepRun& run, const ExperimentStep& step) {
    if (run.device.catalogue().axes.size() > 1) {
        return tuneAxesStep(run, step);
    }
    for (const char* key : {"model_file", "axis"}) {
        if (step.find(key) != nullptr) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("'{}' is for a device with several axes", key), "leave it out");
        }
    }
    const IdentifyResult* model = run.find<IdentifyResult>(*step.text("model"));
    if (model == nullptr) {
        return failure(missingResult(*step.text("model")));
    }
    const Result<LoopConditions> conditions = conditionsOf(run);
    if (!conditions) {
        return failure(conditions.error());
    }
    TuneConfig config;
    config.method = step.text("method").value_or(config.method);
    config.targets = designTargetsOf(step);
    if (const std::optional<std::string> name = step.text("relay")) {
        const RelayResult* relay = run.find<RelayResult>(*name);
        if (relay == nullptr || !relay->ultimate) {
            return failure(missingResult(*name));
        }
        config.targets.ultimateGain_A_per_rad = ultimateGainOf(*relay).value;
        config.targets.ultimatePeriod_s = ultimatePeriodOf(*relay).value;
    }
    config.conditions = *conditions;
    config.seed = run.seed;
    const MotorEstimate motor = motorEstimate(*model);
    if (const auto fits = checkTimingOfModel(motor.timing, conditions->timing); !fits) {
        return failure(fits.error());
    }
    Result<TuneResult> result = runTune(motor, config);
    if (!result) {
        return failure(result.error());
    }
    StepOutcome outcome;
    outcome.quality = result->quality;
    outcome.body = gainsBody(*result);
    outcome.detail = TuneOutcome{motor, *std::move(result), run.seed};
    return outcome;
}

Result<StepOutcome> runApplyStep(StepRun& run, const ExperimentStep& step) {
    if (const auto* axes = run.find<TuneAxesOutcome>(step.text("gains").value_or(""))) {
        return applyAxesStep(run, step, *axes);
    }
    Result<Proposal> proposal = proposalOf(run, step);
    if (!proposal) {
        return failure(proposal.error());
    }
    ApplyConfig config;
    config.values = proposal->values;
    if (const std::optional<double> height_deg = step.number("verify_step_deg")) {
        ApplyVerification verification;
        verification.reference.shape = MoveReference::Shape::Step;
        verification.reference.amplitude = degreesToRadians(*height_deg);
        verification.motor = proposal->motor.value_or(MotorEstimate{});
        config.verification = verification;
    }
    Result<ApplyResult> result = runApply(run.device, config, observerFor(run.context));
    if (!result) {
        return failure(result.error());
    }
    StepOutcome outcome;
    outcome.quality = result->quality;
    outcome.quality.verdict = result->isKept ? outcome.quality.verdict : Verdict::Refused;
    outcome.body = applyBody(*result);
    outcome.detail = *std::move(result);
    return outcome;
}

} // namespace halbench::app
