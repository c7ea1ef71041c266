#include "app/cli/command_output.h"
#include "app/cli/command_support.h"
#include "app/cli/frequency_options.h"
#include "app/documents/frequency_table.h"
#include "app/documents/result_documents.h"
#include "app/documents/text/numbers.h"
#include "app/documents/text/output_file.h"
#include "app/headless/command_header.h"
#include "app/headless/recording_file.h"
#include "app/procedures/base/axis_choice.h"
#include "app/tuning/loop_conditions.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

std::string marginLine(const char* name, const control::MeasuredMargin& margin, const char* unit) {
    if (!margin.value) {
        return fmt::format("{:<14} withheld\n", name);
    }
    return fmt::format("{:<14} {:.4g} {}  [{:.4g}, {:.4g}] at {:.4g} rad/s\n", name, *margin.value, unit,
                       margin.interval->first, margin.interval->second, *margin.frequency_rad_s);
}

std::string frequencyText(const FrequencyResult& result) {
    const auto used = std::count_if(result.points.begin(), result.points.end(),
                                    [](const FrequencyResultPoint& point) { return point.isUsed; });
    std::string text = fmt::format("{:<14} {} of {} used, coherence from {:.3g}\n", "frequencies", used,
                                   result.points.size(), result.config.leastCoherence);
    text += fmt::format("{:<14} {:.4g} rad/s, never below {:.4g} rad/s\n", "base speed", result.turn_rad_s,
                        result.lowestSpeed_rad_s);
    text += marginLine("phase margin", result.margins.phase_deg, "deg");
    text += marginLine("gain margin", result.margins.gain_dB, "dB");
    if (result.fit) {
        text += estimateLine("c_over_J", result.fit->dampingRate);
        text += estimateLine("phi_over_J", result.fit->accelerationGain);
        text += estimateLine("feedthrough", result.fit->feedthrough);
    }
    return text + findingLines(result.quality);
}

} // namespace

Result<void> writeResponseFiles(const IdentifyOptions& options, const Recording& recording,
                                const std::string& table, devices::Device& device,
                                const std::string& started) {
    if (!options.recordFile.empty()) {
        if (auto written = namingFile(
                options.recordFile, writeRecording(options.recordFile, recording, device, {started, {}, {}}));
            !written) {
            return written;
        }
    }
    return options.frequency.bodeFile.empty()
               ? Result<void>()
               : namingFile(options.frequency.bodeFile, writeFile(options.frequency.bodeFile, table));
}

Result<void> checkFrequencyOptions(const IdentifyOptions& options) {
    if (options.isFrequency) {
        return refuseGiven({{"--given", !options.sweep.given.empty()},
                            {"--current-tolerance-percent", !options.sweep.currentTolerance.empty()},
                            {"--currents", !options.sweep.currents.empty()},
                            {"--directions", !options.sweep.directions.empty()},
                            {"--bare", !options.sweep.bare.empty()},
                            {"--added-inertia", !options.sweep.addedInertia.empty()}},
                           "belongs to the sweep and not to --frequency", "leave one of the two out");
    }
    return refuseGiven({{"--excitation", !options.frequency.excitation.empty()},
                        {"--from-hz", !options.frequency.from.empty()},
                        {"--to-hz", !options.frequency.to.empty()},
                        {"--base-rad-s", !options.base.empty()},
                        {"--amplitude-deg", !options.frequency.amplitude.empty()},
                        {"--effort-ratio", !options.frequency.effortRatio.empty()},
                        {"--periods", !options.frequency.periods.empty()},
                        {"--coherence", !options.frequency.coherence.empty()},
                        {"--bode", !options.frequency.bodeFile.empty()},
                        {"--calibration", !options.frequency.calibrationFile.empty()}},
                       "belongs to a frequency response", "add --frequency");
}

Result<void> takeNumbers(std::initializer_list<NumberOption> numbers) {
    for (const NumberOption& number : numbers) {
        const Result<std::optional<double>> given = optionalNumber(number.option, number.text);
        if (!given) {
            return failure(given.error());
        }
        number.value = given->value_or(number.value);
    }
    return {};
}

Result<int> wholePeriods(double periods, const std::string& text) {
    constexpr double Most = 1e6; // of an int, before the procedure judges it
    if (periods != std::floor(periods) || std::abs(periods) > Most) {
        return failure(ErrorCode::Usage, "--periods: '" + text + "' is no whole number", "write e.g. 8");
    }
    return static_cast<int>(periods);
}

Result<FrequencyConfig> frequencyConfigFrom(const IdentifyOptions& options) {
    FrequencyConfig config;
    if (!options.frequency.excitation.empty()) {
        const Result<Excitation> named = excitation(options.frequency.excitation);
        if (!named) {
            return failure(ErrorCode::Usage, "--excitation: " + named.error().message, named.error().hint);
        }
        config.excitation = *named;
    }
    double periods = config.periods;
    const Result<std::optional<double>> amplitude_deg =
        optionalNumber("--amplitude-deg", options.frequency.amplitude);
    const Result<void> taken =
        takeNumbers({{"--from-hz", options.frequency.from, config.from_Hz},
                     {"--to-hz", options.frequency.to, config.to_Hz},
                     {"--base-rad-s", options.base, config.base_rad_s},
                     {"--periods", options.frequency.periods, periods},
                     {"--coherence", options.frequency.coherence, config.leastCoherence}});
    if (!taken || !amplitude_deg) {
        return failure(taken ? amplitude_deg.error() : taken.error());
    }
    const Result<int> whole = wholePeriods(periods, options.frequency.periods);
    if (!whole) {
        return failure(whole.error());
    }
    config.periods = *whole;
    if (*amplitude_deg) {
        config.amplitude_rad = degreesToRadians(**amplitude_deg);
    }
    return config;
}

CommandResult runFrequencyCommand(CommandContext& context, const IdentifyOptions& options) {
    const Result<FrequencyConfig> config = frequencyConfigFrom(options);
    if (!config) {
        return failure(config.error());
    }
    const Result<std::unique_ptr<devices::Device>> device = openToMove(context, options.device);
    if (!device) {
        return failure(device.error());
    }
    if ((*device)->catalogue().axes.size() > 1) {
        return runAxesFrequencyCommand(context, options, **device);
    }
    if (const Result<void> fits =
            refuseGiven({{"--effort-ratio", !options.frequency.effortRatio.empty()}},
                        "belongs to a device with several axes", "use --amplitude-deg here");
        !fits) {
        return failure(fits.error());
    }
    if (const auto axis = chosenAxes((*device)->catalogue(), options.axis); !axis) {
        return failure(axis.error().code, "--axis: " + axis.error().message, axis.error().hint);
    }
    Result<LoopConditions> conditions = loopConditionsOf(**device);
    if (!conditions) {
        return failure(conditions.error());
    }
    if (const Result<void> taken = takeCalibration(*conditions, options.frequency.calibrationFile); !taken) {
        return failure(taken.error());
    }
    const ResultHeader header = headerFor(context, "halbench.frequency/1", **device);
    const Result<FrequencyResult> result =
        runFrequency(**device, *config, conditions->stray, observerFor(context));
    if (!result) {
        return failure(result.error());
    }
    const Result<void> files =
        writeResponseFiles(options, result->recording, frequencyTable(*result), **device, header.started);
    const CommandOutput kept{frequencyDocument(header, *result), frequencyText(*result), options.out};
    if (!files) {
        return endWithResult(context, kept, files.error());
    }
    const Result<void> done = deliver(context, kept.document, kept.text, kept.out);
    if (!done) {
        return failure(done.error());
    }
    return exitCodeFor(result->quality);
}

} // namespace halbench::app
