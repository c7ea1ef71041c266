#pragma once

#include "app/procedures/frequency/axes_frequency.h"

#include <cstddef>
#include <vector>

namespace halbench::app {

/// Lines of all axes in one band, in multiples of the period's frequency: `first`, `first + spacing` ... The
/// axes take them in turn, so that no two are excited at the same frequency at once.
struct AxesBand {
    int first = 1;
    int spacing = 1;
    int linesPerAxis = 2;

    /// All lines of the band, ascending.
    std::vector<int> lines(std::size_t axes) const;
    /// Lines of one axis in one experiment: those of the next axis in the next experiment.
    std::vector<int> linesOf(std::size_t axis, std::size_t experiment, std::size_t axes) const;
};

struct AxesFrequencyPlan {
    double period_s = 1e-3; ///< of the loop
    std::size_t rowsPerPeriod = 0;
    double settle_s = 0.0; ///< left out before the first period of each experiment
    std::vector<AxesBand> bands;
    std::vector<double> effort; ///< amplitude of each axis, of a sine of the same rms
    std::vector<double> reach;  ///< position that an axis may swing to either side
    std::size_t axes() const { return effort.size(); }
    double frequency_Hz(int line) const {
        return static_cast<double>(line) / (period_s * static_cast<double>(rowsPerPeriod));
    }
    double experiment_s(int periods) const;
    /// Of all experiments and the pilots before them.
    double duration_s(int periods) const;
};

/// A pilot at this share of the effort shows how far each axis swings before it is excited fully.
inline constexpr double Pilot_ratio = 0.3;

/// Bands of less than a factor five; one period holds at least two of the lowest frequency and all
/// experiments use it. `efforts`: what each axis has at its limit. An axis may swing by half of its test
/// step. Errors: NotFinite, OutOfRange, naming what to change.
Result<AxesFrequencyPlan> planAxesFrequency(const AxesFrequencyConfig& config,
                                            const std::vector<devices::AxisSpec>& axes,
                                            const std::vector<double>& efforts, double period_s);

} // namespace halbench::app
