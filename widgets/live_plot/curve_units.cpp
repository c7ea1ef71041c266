#include "widgets/live_plot/curve_units.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace halbench::widgets {
namespace {

using Place = std::vector<PlotCurve>::iterator;

const QString& unitOf(const PlotSpec& plot, bool isRight) {
    return isRight ? plot.right.unit : plot.unit;
}

/// A held axis means its unit.
void setUnitOf(PlotSpec& plot, bool isRight, const QString& unit) {
    if (unitOf(plot, isRight) != unit) {
        (isRight ? plot.right.unit : plot.unit) = unit;
        (isRight ? plot.right.fixedRange : plot.fixedRange) = std::nullopt;
    }
}

bool isAlone(const PlotSpec& plot, const PlotCurve& curve) {
    return std::none_of(plot.curves.begin(), plot.curves.end(), [&](const PlotCurve& other) {
        return other.isRight == curve.isRight && other.signal != curve.signal;
    });
}

/// To the other axis; what that does not take is returned, in a plot of its own.
std::optional<PlotSpec> moveOut(PlotSpec& plot, Place curve) {
    const QString quantity = curve->isRight ? plot.right.quantity : plot.quantity;
    if (takes(plot, !curve->isRight, curve->unit)) {
        if (!curve->isRight && !hasRightAxis(plot)) {
            plot.right = {quantity, curve->unit, {}};
        }
        curve->isRight = !curve->isRight;
        return std::nullopt;
    }
    PlotSpec own;
    own.quantity = quantity;
    own.unit = curve->unit;
    own.column = plot.column;
    own.curves.push_back(std::move(*curve));
    own.curves.front().isRight = false;
    plot.curves.erase(curve);
    return own;
}

/// Where it is alone on its axis.
void takeAxisAlong(PlotSpec& plot, PlotCurve& curve) {
    const bool isBack = curve.isRight && plot.unit == curve.unit && plot.quantity == plot.right.quantity;
    if (isBack) {
        curve.isRight = false;
    } else {
        setUnitOf(plot, curve.isRight, curve.unit);
    }
}

} // namespace

const UnitChoice* findChoice(const PlotCurve& curve, const std::string& key) {
    const auto found = std::find_if(curve.unitChoices.begin(), curve.unitChoices.end(),
                                    [&](const UnitChoice& choice) { return choice.key == key; });
    return found == curve.unitChoices.end() ? nullptr : &*found;
}

UnitChange showIn(PlotSpec& plot, const std::string& signal, const std::string& unit) {
    const auto curve = std::find_if(plot.curves.begin(), plot.curves.end(),
                                    [&](const PlotCurve& each) { return each.signal == signal; });
    const UnitChoice* choice = curve == plot.curves.end() ? nullptr : findChoice(*curve, unit);
    if (choice == nullptr || curve->ownUnit == unit) {
        return {};
    }
    curve->ownUnit = unit;
    curve->factor = choice->factor;
    curve->decimals = choice->decimals;
    curve->unit = choice->text;
    UnitChange change{true};
    if (isAlone(plot, *curve)) {
        takeAxisAlong(plot, *curve);
    } else if (curve->unit != unitOf(plot, curve->isRight)) {
        change.below = moveOut(plot, curve);
    }
    settleAxes(plot);
    return change;
}

std::vector<PlotSpec> settleUnits(PlotSpec& plot) {
    for (const bool isRight : {false, true}) {
        const auto first = std::find_if(plot.curves.begin(), plot.curves.end(),
                                        [&](const PlotCurve& curve) { return curve.isRight == isRight; });
        if (first != plot.curves.end()) {
            setUnitOf(plot, isRight, first->unit);
        }
    }
    settleAxes(plot);
    std::vector<PlotSpec> below;
    const auto misfit = [&plot] {
        return std::find_if(plot.curves.begin(), plot.curves.end(), [&](const PlotCurve& curve) {
            return curve.unit != unitOf(plot, curve.isRight);
        });
    };
    for (Place found = misfit(); found != plot.curves.end(); found = misfit()) {
        std::optional<PlotSpec> own = moveOut(plot, found);
        if (!own) {
            continue;
        }
        const auto same = std::find_if(below.begin(), below.end(),
                                       [&](const PlotSpec& each) { return each.unit == own->unit; });
        if (same == below.end()) {
            below.push_back(*std::move(own));
        } else {
            same->curves.push_back(own->curves.front());
        }
    }
    return below;
}

void settleUnits(std::vector<PlotSpec>& plots) {
    for (std::size_t i = 0; i < plots.size(); ++i) {
        std::vector<PlotSpec> below = settleUnits(plots[i]);
        plots.insert(plots.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     std::make_move_iterator(below.begin()), std::make_move_iterator(below.end()));
    }
}

} // namespace halbench::widgets
