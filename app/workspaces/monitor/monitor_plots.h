#pragma once

#include "app/workbench/display_quantity.h"
#include "app/workspaces/monitor/monitor_view.h"
#include "devices/device.h"
#include "widgets/live_plot/cursor_pairs.h"
#include "widgets/live_plot/live_plot_spec.h"

#include <QStringList>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace halbench::app {

/// Temperatures from which the plots warn, as the device's profile and its limit say.
struct TemperatureBands {
    std::optional<double> warn_degC;
    std::optional<double> bad_degC;
};
TemperatureBands temperatureBands(const devices::Catalogue& catalogue, std::optional<double> limit_degC);

/// A signal as the plots show it: words, display unit, decimals.
widgets::PlotCurve curveFor(const SignalSpec& spec, const DisplayUnits& units);

/// What the Monitor shows of a device at first: Hall sensors, angle with reference, speed, currents, coil
/// temperatures with their bands; for a device without these roles its first signals, by unit.
std::vector<widgets::PlotSpec> defaultPlots(const devices::Catalogue& catalogue,
                                            const TemperatureBands& bands, const DisplayUnits& units);

/// A plot for one more signal.
widgets::PlotSpec plotFor(const SignalSpec& spec, const TemperatureBands& bands, const DisplayUnits& units);

/// The same curves, as the device and the user's units show them now. Axes are as they were: curves that do
/// not fit them any more are for widgets::settleUnits.
std::vector<widgets::PlotSpec> inUnits(std::vector<widgets::PlotSpec> plots,
                                       const devices::Catalogue& catalogue, const TemperatureBands& bands,
                                       const DisplayUnits& units);

/// Plots as they were chosen; signals that the device does not have are left out and named in `missing`. An
/// axis held in another unit than the plot has now is let go. What units of single signals part is parted.
std::vector<widgets::PlotSpec> chosenPlots(const std::vector<PlotChoice>& choices,
                                           const devices::Catalogue& catalogue, const TemperatureBands& bands,
                                           const DisplayUnits& units, QStringList& missing);

/// Units of single signals that were chosen and do not fit what this device sends, in words; chosenPlots
/// shows these signals as the user prefers.
QStringList unfitUnits(const std::vector<PlotChoice>& choices, const devices::Catalogue& catalogue);

/// Pairs of cursors as they were chosen, and back.
widgets::CursorPairs cursorPairs(const MonitorView& view);
void keepCursors(const widgets::CursorPairs& pairs, MonitorView& view);

/// Names of all signals in the plots.
std::set<std::string> plottedSignals(const std::vector<widgets::PlotSpec>& plots);

} // namespace halbench::app
