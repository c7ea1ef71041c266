#include "app/cli/command_output.h"
#include "app/cli/command_support.h"
#include "app/cli/relay_options.h"
#include "app/documents/model_file.h"
#include "app/documents/relay_document.h"
#include "app/documents/text/numbers.h"
#include "app/headless/command_header.h"
#include "app/headless/recording_file.h"
#include "app/procedures/base/axis_choice.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

std::string relayText(const RelayResult& result) {
    std::string text = estimateLine("ultimate gain", ultimateGainOf(result));
    text += estimateLine("its period", ultimatePeriodOf(result));
    if (result.ultimate) {
        text += fmt::format("{:<14} {:.4g} deg  [{:.4g}, {:.4g}] at {:.4g} rad/s\n", "phase",
                            result.ultimate->phase_deg, result.ultimate->phase95_deg.first,
                            result.ultimate->phase95_deg.second, result.cycle.frequency_rad_s);
    }
    text += fmt::format("{:<14} {} cycles of {:.3g} deg, {:.3g} A, frequency scattering by {:.2g} %\n",
                        "swing", result.cycle.cycles, radiansToDegrees(result.cycle.amplitude),
                        result.cycle.input, 100.0 * result.cycle.frequencyScatter_ratio);
    const RelayPrediction& predicted = result.plan.predicted;
    text += fmt::format("{:<14} {:.4g} A/rad", predicted.isOfThisMotor ? "model" : "published",
                        predicted.at.gain);
    if (predicted.gain95) {
        text += fmt::format("  [{:.4g}, {:.4g}]{}", predicted.gain95->first, predicted.gain95->second,
                            result.agreement == RelayAgreement::Agrees      ? ", agrees"
                            : result.agreement == RelayAgreement::Disagrees ? ", DISAGREES"
                                                                            : "");
    }
    return text + "\n" + findingLines(result.quality);
}

} // namespace

Result<void> checkRelayOptions(const IdentifyOptions& options) {
    if (!options.isRelay) {
        return refuseGiven({{"--model", !options.relay.model.empty()},
                            {"--relay-gain", !options.relay.gain.empty()},
                            {"--relay-current", !options.relay.current.empty()},
                            {"--cycles", !options.relay.cycles.empty()}},
                           "belongs to the relay experiment", "add --relay");
    }
    return refuseGiven({{"--frequency", options.isFrequency},
                        {"--given", !options.sweep.given.empty()},
                        {"--current-tolerance-percent", !options.sweep.currentTolerance.empty()},
                        {"--currents", !options.sweep.currents.empty()},
                        {"--directions", !options.sweep.directions.empty()},
                        {"--bare", !options.sweep.bare.empty()},
                        {"--added-inertia", !options.sweep.addedInertia.empty()},
                        {"--excitation", !options.frequency.excitation.empty()},
                        {"--from-hz", !options.frequency.from.empty()},
                        {"--to-hz", !options.frequency.to.empty()},
                        {"--amplitude-deg", !options.frequency.amplitude.empty()},
                        {"--effort-ratio", !options.frequency.effortRatio.empty()},
                        {"--periods", !options.frequency.periods.empty()},
                        {"--coherence", !options.frequency.coherence.empty()},
                        {"--bode", !options.frequency.bodeFile.empty()},
                        {"--calibration", !options.frequency.calibrationFile.empty()}},
                       "does not belong to the relay experiment", "leave it or --relay out");
}

Result<RelayConfig> relayConfigFrom(const IdentifyOptions& options) {
    RelayConfig config;
    const auto base = optionalNumber("--base-rad-s", options.base);
    const auto current = optionalNumber("--relay-current", options.relay.current);
    const auto gain = optionalNumber("--relay-gain", options.relay.gain);
    const auto cycles = optionalNumber("--cycles", options.relay.cycles);
    for (const auto* number : {&base, &current, &gain, &cycles}) {
        if (!*number) {
            return failure(number->error());
        }
    }
    constexpr double Most = 1e6; // of an int, before the procedure judges it
    const double count = cycles->value_or(config.cycles);
    if (count != std::floor(count) || std::abs(count) > Most) {
        return failure(ErrorCode::Usage, "--cycles: '" + options.relay.cycles + "' is no whole number",
                       "write e.g. 100");
    }
    config.base_rad_s = *base;
    config.limit_A = *current;
    config.gain_A_per_rad = *gain;
    config.cycles = static_cast<int>(count);
    if (!options.relay.model.empty()) {
        Result<ModelFile> model = readModelFile(options.relay.model);
        if (!model) {
            return failure(model.error());
        }
        config.motor = std::move(model->estimate);
    }
    return config;
}

std::string relayPlanText(const RelayPlan& plan) {
    return fmt::format(
        "turns at {:.3g} rad/s for {:.3g} s, {:.3g} turns, and swings around that by {:.3g} deg every "
        "{:.3g} s; speed {:.3g} to {:.3g} rad/s, current up to {:.3g} A",
        plan.turn_rad_s, plan.duration_s(), std::abs(plan.travel_rad()) / (2.0 * Pi),
        radiansToDegrees(plan.predicted.amplitude_rad), plan.predicted.period_s, plan.predicted.lowest_rad_s,
        plan.predicted.peak_rad_s, plan.limit_A);
}

CommandResult runRelayCommand(CommandContext& context, const IdentifyOptions& options) {
    const Result<RelayConfig> config = relayConfigFrom(options);
    if (!config) {
        return failure(config.error());
    }
    const Result<std::unique_ptr<devices::Device>> device = openToMove(context, options.device);
    if (!device) {
        return failure(device.error());
    }
    const Result<std::vector<devices::AxisSpec>> axes = chosenAxes((*device)->catalogue(), options.axis);
    if (!axes) {
        return failure(axes.error().code, "--axis: " + axes.error().message, axes.error().hint);
    }
    const Result<RelayPlan> plan = planRelayOn(**device, *config);
    if (!plan) {
        return failure(plan.error());
    }
    context.console.log(LogLevel::Info, relayPlanText(*plan));
    const ResultHeader header = headerFor(context, "halbench.relay/1", **device);
    const Result<RelayResult> result = runRelay(**device, *config, observerFor(context));
    if (!result) {
        return failure(result.error());
    }
    const CommandOutput kept{relayDocument(header, *result), relayText(*result), options.out};
    if (!options.recordFile.empty()) {
        const Result<void> recorded =
            namingFile(options.recordFile, writeRecording(options.recordFile, result->recording, **device,
                                                          {header.started, {}, {}}));
        if (!recorded) {
            return endWithResult(context, kept, recorded.error());
        }
    }
    if (const Result<void> done = deliver(context, kept.document, kept.text, kept.out); !done) {
        return failure(done.error());
    }
    return exitCodeFor(result->quality);
}

} // namespace halbench::app
