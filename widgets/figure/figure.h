#pragma once

#include <optional>
#include <string>
#include <vector>

namespace halbench::widgets {

/// Plain values a plot is drawn from; no Qt, so that whoever computes can fill them. All in the units of the
/// axes.

enum class CurveStyle {
    Line,
    DashedLine,
    DottedLine,
    DashDotLine,
    Points,
    HollowPoints,
    Crosses,
    Band ///< outline of an area, filled faintly behind the curves; it does not count for the extent of an
         ///< axis
};

/// Places that are marked one by one, not joined.
constexpr bool isMarkers(CurveStyle style) {
    return style == CurveStyle::Points || style == CurveStyle::HollowPoints || style == CurveStyle::Crosses;
}

struct Curve {
    std::string label; ///< legend text; an empty label keeps the curve out of the legend
    std::vector<double> x;
    std::vector<double> y; ///< as long as x; a value that is not finite interrupts the line
    CurveStyle style = CurveStyle::Line;
    std::optional<int> colour; ///< curve role 0 ... 7 of the theme; default: by position in the panel
    bool isRight = false;      ///< of the right axis, which the panel then has
    std::vector<double> parameter = {}; ///< what each sample belongs to, on the figure's parameter axis
};

/// A straight reference line across the panel with its text at the edge, e.g. a limit or a crossover.
struct ReferenceLine {
    enum class Direction { Horizontal, Vertical };
    Direction direction = Direction::Horizontal;
    double at = 0.0;
    std::string label;
    bool isFaint = false; ///< beside those that decide
};

/// Titled `quantity [unit]`; an empty unit leaves the bracket out.
struct Axis {
    std::string quantity;
    std::string unit;
    bool isLogarithmic = false;
    std::optional<double> min; ///< given extent; default: from the data, rounded outwards
    std::optional<double> max;
    std::optional<double>
        tickStep; ///< distance of labelled ticks, e.g. 45 for degrees; default: 1, 2 or 5 x 10^n
};

struct Panel {
    Axis y;
    std::vector<Curve> curves;
    std::vector<ReferenceLine> lines;
    int height_px = 220;
    std::optional<Axis> right = {};
};

/// One picture: panels stacked above one shared horizontal axis.
struct Figure {
    std::string title; ///< also the accessible name of the picture
    Axis x;
    std::vector<Panel> panels;
    bool isEqualScale = false; ///< a unit is as long on both axes of the one panel, for a picture of a place
    bool isLinked = false;     ///< what is probed is read in every panel at the same abscissa
    std::optional<Axis> parameter = {}; ///< what the curves run along when it is not the horizontal axis
};

} // namespace halbench::widgets
