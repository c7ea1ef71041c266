#include "widgets/live_plot/live_plot_spec.h"

#include "widgets/controls/share_splitter.h"

#include <algorithm>

namespace halbench::widgets {
namespace {

bool hasCurves(const PlotSpec& plot, bool isRight) {
    return std::any_of(plot.curves.begin(), plot.curves.end(),
                       [&](const PlotCurve& curve) { return curve.isRight == isRight; });
}

PlotAxis axisFor(const PlotSpec& plot, const PlotCurve& curve) {
    const bool isOther = curve.unit != (curve.isRight ? plot.right.unit : plot.unit);
    const QString& quantity = curve.isRight ? plot.right.quantity : plot.quantity;
    return {isOther || quantity.isEmpty() ? curve.label : quantity, curve.unit, std::nullopt};
}

} // namespace

bool hasRightAxis(const PlotSpec& plot) {
    return hasCurves(plot, true);
}

bool takes(const PlotSpec& plot, bool isRight, const QString& unit) {
    return !hasCurves(plot, isRight) || (isRight ? plot.right.unit : plot.unit) == unit;
}

bool putOnAxis(PlotSpec& plot, const std::string& signal, bool isRight) {
    const auto found = std::find_if(plot.curves.begin(), plot.curves.end(), [&](const PlotCurve& curve) {
        return curve.signal == signal && curve.isRight != isRight;
    });
    if (found == plot.curves.end() || !takes(plot, isRight, found->unit)) {
        return false;
    }
    const auto lefts = std::count_if(plot.curves.begin(), plot.curves.end(),
                                     [](const PlotCurve& curve) { return !curve.isRight; });
    if (isRight && lefts < 2) {
        return false;
    }
    const bool isNew = !hasCurves(plot, isRight);
    const PlotAxis axis = axisFor(plot, *found);
    found->isRight = isRight;
    if (isNew && isRight) {
        plot.right = axis;
    }
    settleAxes(plot);
    return true;
}

void settleAxes(PlotSpec& plot) {
    if (!hasCurves(plot, false) && hasCurves(plot, true)) {
        plot.quantity = plot.right.quantity;
        plot.unit = plot.right.unit;
        plot.fixedRange = plot.right.fixedRange;
        plot.bands.clear();
        for (PlotCurve& curve : plot.curves) {
            curve.isRight = false;
        }
    }
    if (!hasCurves(plot, true)) {
        plot.right = {};
    }
}

void settleColumns(std::vector<PlotSpec>& plots) {
    std::stable_sort(plots.begin(), plots.end(),
                     [](const PlotSpec& left, const PlotSpec& right) { return left.column < right.column; });
    int column = -1;
    std::optional<int> before;
    double width_ratio = 1.0;
    for (PlotSpec& plot : plots) {
        if (plot.column != before) {
            before = plot.column;
            width_ratio = plot.width_ratio;
            ++column;
        }
        plot.column = column;
        plot.width_ratio = width_ratio;
    }
}

PlotSpec placedIn(const std::vector<PlotSpec>& plots, int column, PlotSpec plot) {
    const auto beside = std::find_if(plots.begin(), plots.end(),
                                     [column](const PlotSpec& other) { return other.column == column; });
    plot.column = column;
    plot.height_ratio = 1.0;
    plot.width_ratio = beside == plots.end() ? 1.0 : beside->width_ratio;
    return plot;
}

std::vector<double> heightsIn(const std::vector<PlotSpec>& plots, int column) {
    std::vector<double> heights;
    for (const PlotSpec& plot : plots) {
        if (plot.column == column) {
            heights.push_back(plot.height_ratio);
        }
    }
    return heights;
}

std::vector<double> widthsOf(const std::vector<PlotSpec>& plots) {
    std::vector<double> widths;
    std::optional<int> before;
    for (const PlotSpec& plot : plots) {
        if (plot.column != before) {
            before = plot.column;
            widths.push_back(plot.width_ratio);
        }
    }
    return widths;
}

void setHeights(std::vector<PlotSpec>& plots, int column, const std::vector<double>& heights) {
    auto height = heights.begin();
    for (PlotSpec& plot : plots) {
        if (plot.column == column && height != heights.end()) {
            plot.height_ratio = *height++;
        }
    }
}

void setWidths(std::vector<PlotSpec>& plots, const std::vector<double>& widths) {
    for (PlotSpec& plot : plots) {
        const auto column = static_cast<std::size_t>(plot.column);
        plot.width_ratio = column < widths.size() ? widths[column] : plot.width_ratio;
    }
}

void settleSizes(std::vector<PlotSpec>& plots) {
    const std::vector<double> widths = settledShares(widthsOf(plots));
    setWidths(plots, widths);
    for (int column = 0; column < static_cast<int>(widths.size()); ++column) {
        setHeights(plots, column, settledShares(heightsIn(plots, column)));
    }
}

} // namespace halbench::widgets
