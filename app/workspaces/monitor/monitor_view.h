#pragma once

#include "app/workbench/trigger_choice.h"
#include "devices/acquisition/derived_signals.h"
#include "widgets/live_plot/axes/time_view.h"
#include "widgets/live_plot/axes/value_range.h"
#include "widgets/live_plot/curve_look.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// One plot as a project keeps it: names of signals, and the values' axis where the user fixed it.
struct PlotChoice {
    std::vector<std::string> signalNames;
    std::optional<widgets::ValueRange> range; ///< in `unit`; none: follows the data
    std::string unit;                         ///< as shown; only with a range
    std::vector<std::string> rightNames = {}; ///< of those on the right axis, and the same of that
    std::optional<widgets::ValueRange> rightRange = {};
    std::string rightUnit = {};
    std::optional<widgets::OwnTime> ownTime = {};  ///< its own time axis; none: the one of all plots
    int column = 0;                                ///< beside each other, from the left
    std::map<std::string, std::string> units = {}; ///< of signals that have their own: its name in files
    double height_ratio = 1.0;                     ///< to the mean of its column's plots
    double width_ratio = 1.0; ///< of its column, to the mean of all; said by the first plot there

    bool operator==(const PlotChoice&) const = default;
};

/// A pair of cursors as a project keeps it, on the device's time axis.
struct CursorChoice {
    std::string name;
    double a_s = 0.0;
    double b_s = 0.0;
    bool isMeasuring = false; ///< one of them

    bool operator==(const CursorChoice&) const = default;
};

/// View of the Monitor as a project keeps it. No plots: those of the device's profile.
struct MonitorView {
    std::vector<PlotChoice> plots;
    bool isFollowing = true;
    std::optional<double> span_s; ///< time shown while following
    double rate_Hz = 0.0;         ///< rows a second; 0: as usual
    TriggerChoice trigger;
    std::vector<devices::DerivedSignal> derived;
    std::vector<CursorChoice> cursors; ///< none: one pair that nobody named, which is not kept
    bool areCursorsShown = false;      ///< where there are some
    widgets::CurveLooks looks = {};    ///< of signals, where the user chose them

    bool operator==(const MonitorView&) const = default;
};

} // namespace halbench::app
