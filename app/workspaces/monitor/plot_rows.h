#pragma once

#include "control/base/result.h"
#include "control/base/sample_block.h"
#include "control/history/sample_history.h"
#include "widgets/live_plot/live_plot_spec.h"

#include <QStringList>

#include <vector>

namespace halbench::widgets {
class LivePlotStack;
}

namespace halbench::app {

/// Values that are copied out of a history at once: the work of the window's thread, a fraction of a second.
constexpr std::size_t MostPlotValues = 4000000;

/// The samples of the plotted signals between two moments, both included, exactly as they came: a row for
/// each moment of any of them, NaN where a signal has no sample at that moment. In the order of the plots;
/// SI. Errors: OutOfRange (no samples, or more than `mostValues`).
Result<Recording> plotRows(const std::vector<widgets::PlotSpec>& plots, const control::SampleHistory& history,
                           control::TimeRange range, std::size_t mostValues = MostPlotValues);

/// What is taken of a stack: with cursors the stretch between them of all plots, without them what is in view
/// of the plots on the time axis that keys act on; `leftOut` names the other plots.
struct TakenPlots {
    std::vector<widgets::PlotSpec> plots;
    control::TimeRange range;
    QStringList leftOut;
};
TakenPlots takenPlots(const widgets::LivePlotStack& stack);

/// For a spreadsheet: columns parted by tabulators, a row of names, one of units, then the rows, in the units
/// and the notation of the screen; empty where there is no value.
QString plotTable(const Recording& rows, const std::vector<widgets::PlotSpec>& plots);

} // namespace halbench::app
