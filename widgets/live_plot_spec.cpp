#include "widgets/live_plot_spec.h"

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
    for (PlotSpec& plot : plots) {
        if (plot.column != before) {
            before = plot.column;
            ++column;
        }
        plot.column = column;
    }
}

} // namespace halbench::widgets
