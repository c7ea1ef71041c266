#pragma once

#include "widgets/figure/figure_painter.h"

#include <QPointF>
#include <QString>

#include <cstddef>
#include <optional>

namespace halbench::widgets {

/// One sample of a drawn figure.
struct FigurePoint {
    std::size_t panel = 0;
    std::size_t curve = 0;
    std::size_t index = 0;

    bool operator==(const FigurePoint&) const = default;
};

/// Where a sample is drawn; nothing when it is not finite or outside its panel.
std::optional<QPointF> placeOf(const Figure& figure, const FigureLayout& layout, const FigurePoint& point);

/// The drawn sample that is nearest to a place, if any lies within the reach. Curves without a label count
/// only when they are the only ones of their panel.
std::optional<FigurePoint> nearestPoint(const Figure& figure, const FigureLayout& layout, const QPointF& at,
                                        double reach_px);

/// The next (steps = 1) or previous (-1) sample of the curve that can be seen; the same at its ends.
FigurePoint neighbour(const Figure& figure, const FigureLayout& layout, const FigurePoint& point, int steps);

/// "measured: current amplitude 2.4 A, speed 13.2 rad/s" in the user's notation.
QString pointText(const Figure& figure, const FigurePoint& point);

/// What the picture shows, for those who hear it: title, then for each panel quantity, range and curves.
QString figureSummary(const Figure& figure);

} // namespace halbench::widgets
