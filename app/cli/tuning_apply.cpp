#include "app/cli/tuning_apply.h"

#include "app/cli/command_support.h"
#include "app/documents/result_documents.h"
#include "app/procedures/apply/live_apply_procedure.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "app/tuning/gains_judgement.h"
#include "app/tuning/loop_conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace halbench::app {

namespace {

/// A real device does not get the gains of another motor without a word of its user; a simulated one cannot
/// be harmed.
Result<void> admitMotor(const TuneOptions& options, const std::optional<devices::DeviceInfo>& identified,
                        const devices::DeviceInfo& device) {
    const std::optional<Finding> foreign = foreignMotor(identified, device);
    if (!foreign || device.isSimulated || options.takesForeignModel) {
        return {};
    }
    return failure(ErrorCode::ConsentMissing, "--apply: " + foreign->message,
                   foreign->hint + ", or repeat the command with --foreign-model");
}

/// Gains that were found for another device: likewise.
Result<void> admitGains(const TuneOptions& options, const std::optional<GainsFile>& gains,
                        const devices::DeviceInfo& device) {
    const std::optional<Finding> foreign = gains ? foreignGains(*gains, device) : std::nullopt;
    if (!foreign || device.isSimulated || options.takesForeignModel) {
        return {};
    }
    return failure(ErrorCode::ConsentMissing, "--gains: " + foreign->message,
                   foreign->hint + ", or repeat the command with --foreign-model");
}

/// A model of another loop than the device has: likewise.
Result<void> admitTiming(const TuneOptions& options, const MotorEstimate& motor,
                         const control::LoopTiming& device) {
    const Result<void> same = checkTimingOfModel(motor.timing, device);
    if (same || options.takesForeignModel) {
        return {};
    }
    return failure(ErrorCode::Refused, "--apply: " + same.error().message,
                   same.error().hint + ", or repeat the command with --foreign-model");
}

/// Gains of a file that are sampled otherwise than the device does: likewise.
Result<void> admitPeriod(const TuneOptions& options, const std::optional<GainsFile>& gains,
                         const control::LoopTiming& device) {
    const Result<void> same = gains ? checkPeriodOfGains(gains->timing, device) : Result<void>();
    if (same || options.takesForeignModel) {
        return {};
    }
    return failure(ErrorCode::Refused, "--apply: " + same.error().message,
                   same.error().hint + ", or repeat the command with --foreign-model");
}

/// The device's law has what these gains need; then nothing has to be said of that any more.
Result<void> admitLaw(const TuneOptions& options, TuneResult& result, const devices::Catalogue& catalogue) {
    if (!result.filtered) {
        return {};
    }
    if (options.isLive) {
        return failure(
            ErrorCode::Usage,
            "--live: gains with set-point weights or filters are applied at once, not in small steps",
            "leave --live out");
    }
    if (const auto offered = checkOffered(*result.filtered, boardLawSpec(catalogue)); !offered) {
        return failure(offered.error().code, "--apply: " + offered.error().message, offered.error().hint);
    }
    const auto isAnswered = [](const Finding& finding) { return finding.code == "needs_filtered_law"; };
    std::erase_if(result.warnings, isAnswered);
    std::erase_if(result.quality.findings, isAnswered);
    return {};
}

/// Opened, once it is this motor, or another one with a word of the user.
Result<void> openOther(CommandContext& context, const TuneOptions& options, TuningSource& source) {
    Result<std::unique_ptr<devices::Device>> device =
        openToMove(context, options.applyDevice, [&](const devices::DeviceInfo& opened) {
            const Result<void> motor = admitMotor(options, source.header.device, opened);
            return motor ? admitGains(options, source.gains, opened) : motor;
        });
    if (!device) {
        return failure(device.error());
    }
    source.device = *std::move(device);
    return {};
}

/// As it is judged for this loop: designed before, or of --gains.
Result<TuneResult> judgeFor(const TuningSource& source, const TuneResult& before,
                            const LoopConditions& conditions) {
    const double load_A = before.disturbance ? before.disturbance->load_A : DisturbanceLoad_A;
    if (source.gains) {
        return judgeGains(*source.gains, source.estimate, conditions, {source.header.seed, load_A});
    }
    TuneConfig config;
    config.load_A = load_A;
    config.method = before.method;
    config.targets = before.targets;
    config.conditions = conditions;
    config.seed = source.header.seed;
    return judgeLaw(source.estimate, before.law, config);
}

} // namespace

Result<void> openToApply(CommandContext& context, const TuneOptions& options, TuningSource& source,
                         TuneResult& result) {
    if (options.applyDevice.empty()) {
        return {};
    }
    std::vector<Finding> found;
    if (!source.device || options.applyDevice != options.device) {
        if (const Result<void> opened = openOther(context, options, source); !opened) {
            return opened;
        }
        if (const auto foreign = foreignMotor(source.header.device, source.device->info())) {
            found.push_back(*foreign);
        }
    }
    if (source.device->catalogue().axes.size() > 1) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("--apply: the model is of a single loop, the {} has several axes",
                                   source.device->info().model),
                       "identify its axes and tune with that model");
    }
    const devices::DeviceInfo& info = source.device->info();
    if (const auto foreign = source.gains ? foreignGains(*source.gains, info) : std::nullopt;
        foreign && found.empty()) {
        found.push_back(*foreign);
    }
    const Result<LoopConditions> conditions = loopConditionsOf(*source.device);
    if (!conditions) {
        return failure(conditions.error());
    }
    if (const Result<void> fits = admitTiming(options, source.estimate, conditions->timing); !fits) {
        return fits;
    }
    if (const Result<void> fits = admitPeriod(options, source.gains, conditions->timing); !fits) {
        return fits;
    }
    if (const auto timing = otherTiming(result.conditions.timing, conditions->timing)) {
        LoopConditions there = *conditions;
        there.stray = source.conditions.stray; // with its calibration
        auto judged = judgeFor(source, result, there);
        if (!judged) {
            return failure(judged.error());
        }
        judged->bounds = judged->bounds ? judged->bounds : result.bounds;
        result = *std::move(judged);
        result.quality.verdict = std::max(result.quality.verdict, Verdict::Doubtful);
        found.push_back(*timing);
    }
    if (const Result<void> runs = admitLaw(options, result, source.device->catalogue()); !runs) {
        return runs;
    }
    for (const Finding& finding : found) {
        if (!options.out.empty()) { // else it stands among what is printed
            context.console.log(LogLevel::Warning, finding.message + "; " + finding.hint);
        }
        addFinding(result, finding);
    }
    return checkJudgement(result);
}

Result<AppliedGains> applyInSteps(CommandContext& context, TuningSource& source, const TuneResult& result) {
    if (const Result<void> kept = backUp(context, *source.device); !kept) {
        return failure(kept.error());
    }
    const Result<LoopConditions> conditions = loopConditionsOf(*source.device); // its delay, its limit
    if (!conditions) {
        return failure(conditions.error());
    }
    LiveApplyConfig config;
    config.target = result.law;
    config.motor = source.estimate;
    config.conditions = *conditions;
    config.conditions.stray = source.conditions.stray; // with its calibration
    config.draws.seed = source.header.seed;
    Result<LiveApplyResult> applied = runLiveApply(*source.device, config, observerFor(context));
    if (!applied) {
        return failure(applied.error());
    }
    const auto within = std::count_if(applied->steps.begin(), applied->steps.end(),
                                      [](const LiveStepResult& step) { return step.isWithin; });
    return AppliedGains{
        applied->apply, liveApplyBody(*applied),
        fmt::format("{} of {} steps went within the predicted band\n", within, applied->plannedSteps)};
}

Result<AppliedGains> applyGains(CommandContext& context, TuningSource& source, const TuneResult& result) {
    Result<std::vector<ParameterValue>> values =
        lawForDevice(LoopLaw(result.law, result.filtered), source.device->catalogue());
    if (!values) {
        return failure(values.error());
    }
    if (const Result<void> kept = backUp(context, *source.device); !kept) {
        return failure(kept.error());
    }
    ApplyConfig config;
    config.values = *std::move(values);
    config.verification = stepVerification(source.estimate);
    Result<ApplyResult> applied = runApply(*source.device, config, observerFor(context));
    if (!applied) {
        return failure(applied.error());
    }
    return AppliedGains{*applied, applyBody(*applied), {}};
}

} // namespace halbench::app
