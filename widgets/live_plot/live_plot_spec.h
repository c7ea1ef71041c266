#pragma once

#include "widgets/live_plot/axes/time_view.h"
#include "widgets/live_plot/axes/value_range.h"

#include <QString>

#include <optional>
#include <string>
#include <vector>

namespace halbench::widgets {

/// A unit that a signal can be shown in.
struct UnitChoice {
    std::string key;     ///< its name in files, e.g. "mrad"; empty: the one of the preferences
    QString text;        ///< as shown
    double factor = 1.0; ///< shown value = factor x SI value
    int decimals = 3;

    bool operator==(const UnitChoice&) const = default;
};

/// One signal as a plot shows it.
struct PlotCurve {
    std::string signal;                       ///< its name in the history
    QString label;                            ///< in words, translated
    QString unit;                             ///< shown, e.g. "°"
    double factor = 1.0;                      ///< shown value = factor x SI value, e.g. 180/pi
    int decimals = 3;                         ///< of the live value
    bool isRight = false;                     ///< its values are on the right axis
    bool isSensor = false;                    ///< a reading, which comes in the steps of a converter
    std::string ownUnit = {};                 ///< the key of the one that was chosen for it; empty: none was
    std::vector<UnitChoice> unitChoices = {}; ///< none: it has one unit only
    QString ownName = {};                     ///< that the user gave it; empty: none

    bool operator==(const PlotCurve&) const = default;
};

/// As it is shown: the user's name, else its label.
inline const QString& nameOf(const PlotCurve& curve) {
    return curve.ownName.isEmpty() ? curve.label : curve.ownName;
}

/// A stretch of values to be warned of, in the unit shown; either end may be infinite.
struct LimitBand {
    enum class Role { Warn, Bad };
    double from = 0.0;
    double to = 0.0;
    Role role = Role::Warn;

    bool operator==(const LimitBand&) const = default;
};

/// An axis of values, titled `quantity [unit]`.
struct PlotAxis {
    QString quantity = {};
    QString unit = {};
    std::optional<ValueRange> fixedRange = {}; ///< default: follows the data

    bool operator==(const PlotAxis&) const = default;
};

/// One plot of a stack; what is said here of an axis is of the left one.
struct PlotSpec {
    QString quantity;
    QString unit;
    std::vector<PlotCurve> curves;
    std::vector<LimitBand> bands;
    std::optional<ValueRange> fixedRange; ///< default: follows the data
    PlotAxis right = {};                  ///< of the curves that are on the right
    std::optional<OwnTime> ownTime = {};  ///< how its own time axis begins; default: the one of the stack
    int column = 0;                       ///< of the stack, from the left
    double height_ratio = 1.0;            ///< to the mean of its column's plots
    double width_ratio = 1.0;             ///< of its column, to the mean of all; the first plot's counts

    bool operator==(const PlotSpec&) const = default;
};

bool hasRightAxis(const PlotSpec& plot);
/// Whether a curve of this unit can be on that axis: it has no other.
bool takes(const PlotSpec& plot, bool isRight, const QString& unit);
/// Puts one of the plot's curves on an axis; the axis gets its quantity from it if it has none yet. False: it
/// is there already, or the axis has another unit, or nothing would be left on the left one.
bool putOnAxis(PlotSpec& plot, const std::string& signal, bool isRight);
/// After curves went: an axis without curves forgets what it showed, and what is left is on the left one.
void settleAxes(PlotSpec& plot);

/// Plots in the order of their columns, those of one as they were; columns without plots are gone. All plots
/// of a column say how wide it is.
void settleColumns(std::vector<PlotSpec>& plots);
/// The plot as it comes into that column: with its width, as high as the mean of its plots.
PlotSpec placedIn(const std::vector<PlotSpec>& plots, int column, PlotSpec plot);
/// Heights and widths have a mean of 1 again, after plots came and went.
void settleSizes(std::vector<PlotSpec>& plots);
/// Of the plots of a column, from the top, and of all columns, from the left.
std::vector<double> heightsIn(const std::vector<PlotSpec>& plots, int column);
std::vector<double> widthsOf(const std::vector<PlotSpec>& plots);
void setHeights(std::vector<PlotSpec>& plots, int column, const std::vector<double>& heights);
void setWidths(std::vector<PlotSpec>& plots, const std::vector<double>& widths);

/// Where a trigger waits for a signal, in its SI unit.
struct PlotLevel {
    std::string signal;
    double level = 0.0;
    double hysteresis = 0.0;

    bool operator==(const PlotLevel&) const = default;
};

/// What the tree of signals drags: names, one a line, UTF-8.
inline constexpr char SignalsMimeType[] = "application/x-halbench-signals";

} // namespace halbench::widgets
