#include "app/cli/command_output.h"
#include "app/cli/command_support.h"
#include "app/cli/frequency_options.h"
#include "app/documents/axes_frequency_documents.h"
#include "app/documents/text/output_file.h"
#include "app/headless/command_header.h"
#include "app/headless/recording_file.h"
#include "app/procedures/base/axis_choice.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

std::string marginText(const control::MeasuredMargin& margin, const char* unit) {
    if (!margin.value) {
        return "withheld";
    }
    return fmt::format("{:.4g} {} [{:.4g}, {:.4g}] at {:.4g} Hz", *margin.value, unit, margin.interval->first,
                       margin.interval->second, *margin.frequency_rad_s / (2.0 * Pi));
}

std::string peakText(const char* name, const MeasuredPeak& peak) {
    if (peak.withheld != MeasuredPeak::Withheld::No) {
        return fmt::format("{:<14} withheld\n", name);
    }
    return fmt::format("{:<14} {:.4g} [{:.4g}, {:.4g}] at {:.4g} Hz\n", name, peak.value,
                       std::max(0.0, peak.value - peak.radius), peak.value + peak.radius,
                       peak.frequency_rad_s / (2.0 * Pi));
}

/// Where the response of an axis to the command of another is largest against that to its own.
std::string couplingText(const AxesFrequencyResult& result, std::size_t axis) {
    std::string text;
    for (std::size_t other = 0; other < result.axes.size(); ++other) {
        const auto i = static_cast<Eigen::Index>(axis);
        const auto j = static_cast<Eigen::Index>(other);
        if (i == j) {
            continue;
        }
        const AxesFrequencyPoint* largest = nullptr;
        const auto size = [&](const AxesFrequencyPoint& point) {
            return std::abs(point.plant.value(i, j) / point.plant.value(i, i));
        };
        for (const AxesFrequencyPoint& point : result.points) {
            const bool isSeen = std::abs(point.plant.value(i, j)) > point.plant.radius(i, j);
            if (point.isUsed[axis] && isSeen && (largest == nullptr || size(point) > size(*largest))) {
                largest = &point;
            }
        }
        const std::string& id = result.axes[other].axis.id;
        text += largest == nullptr
                    ? fmt::format("  from {:<7} not seen above the scatter\n", id)
                    : fmt::format("  from {:<7} at most {:.3g} {}/{} of its own response, at {:.4g} Hz\n", id,
                                  size(*largest), result.axes[axis].axis.effortUnit,
                                  result.axes[other].axis.effortUnit,
                                  largest->plant.frequency_rad_s / (2.0 * Pi));
    }
    return text;
}

std::string responseText(const AxesFrequencyResult& result) {
    std::string text = fmt::format("{:<14} {}, coherence from {:.3g}\n", "frequencies", result.points.size(),
                                   result.config.leastCoherence);
    for (std::size_t i = 0; i < result.axes.size(); ++i) {
        const AxisResponse& response = result.axes[i];
        const auto used = std::count_if(result.points.begin(), result.points.end(),
                                        [i](const AxesFrequencyPoint& point) { return point.isUsed[i]; });
        text += fmt::format("axis {:<9} {} frequencies used\n", response.axis.id, used);
        text += fmt::format("  phase margin {}\n", marginText(response.margins.phase_deg, "deg"));
        text += fmt::format("  gain margin  {}\n", marginText(response.margins.gain_dB, "dB"));
        text += couplingText(result, i);
    }
    text += peakText("largest S", result.sensitivity);
    text += peakText("largest T", result.complementary);
    return text + findingLines(result.quality);
}

} // namespace

Result<AxesFrequencyConfig> axesFrequencyConfigFrom(const IdentifyOptions& options) {
    const bool isOtherExcitation =
        !options.frequency.excitation.empty() && options.frequency.excitation != "multisine";
    if (const auto fits = refuseGiven({{"--base-rad-s", !options.base.empty()},
                                       {"--amplitude-deg", !options.frequency.amplitude.empty()},
                                       {"--calibration", !options.frequency.calibrationFile.empty()},
                                       {"--excitation", isOtherExcitation}},
                                      "belongs to a motor", "this device is excited by multisines of effort");
        !fits) {
        return failure(fits.error());
    }
    AxesFrequencyConfig config;
    config.axis = options.axis;
    double periods = config.periods;
    const Result<void> taken =
        takeNumbers({{"--from-hz", options.frequency.from, config.from_Hz},
                     {"--to-hz", options.frequency.to, config.to_Hz},
                     {"--effort-ratio", options.frequency.effortRatio, config.effort_ratio},
                     {"--periods", options.frequency.periods, periods},
                     {"--coherence", options.frequency.coherence, config.leastCoherence}});
    const Result<int> whole =
        taken ? wholePeriods(periods, options.frequency.periods) : failure(taken.error());
    if (!whole) {
        return failure(whole.error());
    }
    config.periods = *whole;
    return config;
}

CommandResult runAxesFrequencyCommand(CommandContext& context, const IdentifyOptions& options,
                                      devices::Device& device) {
    const Result<AxesFrequencyConfig> config = axesFrequencyConfigFrom(options);
    if (!config) {
        return failure(config.error());
    }
    if (const auto axes = chosenAxes(device.catalogue(), config->axis); !axes) {
        return failure(axes.error().code, "--axis: " + axes.error().message, axes.error().hint);
    }
    const ResultHeader header = headerFor(context, AxisFrequencySchema, device);
    const Result<AxesFrequencyResult> result = runAxesFrequency(device, *config, observerFor(context));
    if (!result) {
        return failure(result.error());
    }
    const Result<void> files =
        writeResponseFiles(options, result->recording, axesFrequencyTable(*result), device, header.started);
    const CommandOutput kept{axesFrequencyDocument(header, *result), responseText(*result), options.out};
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
