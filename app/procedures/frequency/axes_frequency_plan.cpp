#include "app/procedures/frequency/axes_frequency_plan.h"

#include "app/procedures/base/checked_range.h"
#include "app/procedures/tune/loop_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

// Of the lowest frequency: neighbours are at most half of it apart, less where a band would be too coarse.
constexpr int FewestCycles = 2;
constexpr int MostCycles = 16;
constexpr double WidestBand_ratio = 5.0;
constexpr int MostLinesPerAxis = 6;  // few lines are strong ones
constexpr double Settle_ratio = 1.0; // of a period, at the least
constexpr double Swing_ratio = 0.5;  // of the test step, which proves a loop without leaving the linear range

Result<void> checkConfig(const AxesFrequencyConfig& config, double period_s) {
    const double highest_Hz = std::min(200.0, 0.4 / period_s); // of the board's generator; of the rate
    if (auto valid = checkRange("lowest frequency (Hz)", config.from_Hz, 0.1, highest_Hz); !valid) {
        return valid;
    }
    if (auto valid = checkRange("highest frequency (Hz)", config.to_Hz, config.from_Hz, highest_Hz); !valid) {
        return valid;
    }
    if (config.to_Hz < 2.0 * config.from_Hz) {
        return failure(
            ErrorCode::OutOfRange,
            fmt::format("{:.3g} to {:.3g} Hz is less than an octave", config.from_Hz, config.to_Hz),
            "widen the band: margins need neighbours on both sides");
    }
    if (auto valid = checkRange("effort of each axis over its limit", config.effort_ratio, 0.001, 0.5);
        !valid) {
        return valid;
    }
    if (auto valid = checkRange("periods", config.periods, 4, 256); !valid) {
        return valid;
    }
    return checkRange("minimum coherence", config.leastCoherence, 0.5, 0.999);
}

/// As many lines as resolution and strength allow, at least two for each axis.
std::optional<AxesBand> bandOf(double from_line, double to_line, std::size_t axes, int least) {
    AxesBand band;
    band.first = std::max(least, static_cast<int>(std::ceil(from_line - 1e-9)));
    const double width = to_line - band.first;
    const auto count = static_cast<double>(axes);
    band.spacing = std::max(1, static_cast<int>(std::lround(width / (count * MostLinesPerAxis))));
    band.linesPerAxis = static_cast<int>(std::floor((width / band.spacing + 1.0 + 1e-9) / count));
    return band.linesPerAxis < 2 ? std::nullopt : std::optional(band);
}

/// All bands for a period; nothing when one has no room for two lines of each axis.
std::optional<std::vector<AxesBand>> bandsOf(const AxesFrequencyConfig& config, double once_s,
                                             std::size_t axes) {
    const double widths = std::log(config.to_Hz / config.from_Hz) / std::log(WidestBand_ratio);
    const int count = std::max(1, static_cast<int>(std::ceil(widths - 1e-9)));
    std::vector<AxesBand> bands;
    int least = 1;
    for (int i = 0; i < count; ++i) {
        const auto edge_Hz = [&](int place) {
            return config.from_Hz *
                   std::pow(config.to_Hz / config.from_Hz, static_cast<double>(place) / count);
        };
        const auto band = bandOf(edge_Hz(i) * once_s, edge_Hz(i + 1) * once_s, axes, least);
        if (!band) {
            return std::nullopt;
        }
        bands.push_back(*band);
        least = band->lines(axes).back() + 1;
    }
    return bands;
}

} // namespace

std::vector<int> AxesBand::lines(std::size_t axes) const {
    std::vector<int> result;
    for (int m = 0; m < linesPerAxis * static_cast<int>(axes); ++m) {
        result.push_back(first + m * spacing);
    }
    return result;
}

std::vector<int> AxesBand::linesOf(std::size_t axis, std::size_t experiment, std::size_t axes) const {
    const int grid = static_cast<int>((axis + experiment) % axes);
    std::vector<int> result;
    for (int k = 0; k < linesPerAxis; ++k) {
        result.push_back(first + (grid + k * static_cast<int>(axes)) * spacing);
    }
    return result;
}

double AxesFrequencyPlan::experiment_s(int periods) const {
    return settle_s + period_s * static_cast<double>(rowsPerPeriod) * periods;
}

double AxesFrequencyPlan::duration_s(int periods) const {
    const auto bandCount = static_cast<double>(bands.size());
    return bandCount * (experiment_s(1) + static_cast<double>(axes()) * experiment_s(periods));
}

Result<AxesFrequencyPlan> planAxesFrequency(const AxesFrequencyConfig& config,
                                            const std::vector<devices::AxisSpec>& axes,
                                            const std::vector<double>& efforts, double period_s) {
    if (auto valid = checkConfig(config, period_s); !valid) {
        return failure(valid.error());
    }
    AxesFrequencyPlan plan;
    plan.period_s = period_s;
    std::optional<std::vector<AxesBand>> bands;
    for (int cycles = FewestCycles; !bands && cycles <= MostCycles; ++cycles) {
        plan.rowsPerPeriod = static_cast<std::size_t>(std::ceil(cycles / (config.from_Hz * period_s) - 1e-6));
        bands = bandsOf(config, period_s * static_cast<double>(plan.rowsPerPeriod), axes.size());
    }
    if (!bands) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("from {:.3g} to {:.3g} Hz there is no room for two lines of each axis",
                                   config.from_Hz, config.to_Hz),
                       "measure from a lower or to a higher frequency");
    }
    plan.bands = *std::move(bands);
    const double once_s = period_s * static_cast<double>(plan.rowsPerPeriod);
    plan.settle_s = Settle_ratio * once_s;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        plan.settle_s = std::max(plan.settle_s, axes[i].settle_s);
        plan.effort.push_back(config.effort_ratio * efforts[i]);
        plan.reach.push_back(Swing_ratio * loopAxisOf(axes[i]).testStep);
    }
    return plan;
}

} // namespace halbench::app
