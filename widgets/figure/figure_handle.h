#pragma once

#include "widgets/figure/figure_painter.h"

#include <QPointF>
#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace halbench::widgets {

/// A place of a figure that can be taken and moved; in the units of its panel's axes.
struct FigureHandle {
    enum class Way { Horizontal, Vertical, Free };
    std::size_t panel = 0;
    double x = 0.0;
    double y = 0.0;
    Way way = Way::Free;
    QString name; ///< what moves with it

    bool operator==(const FigureHandle&) const = default;
};

/// Where a handle is drawn; nothing when it is not finite, outside its panel or of no panel.
std::optional<QPointF> placeOfHandle(const Figure& figure, const FigureLayout& layout,
                                     const FigureHandle& handle);

/// The nearest handle within reach of a pointer.
std::optional<std::size_t> handleAt(const Figure& figure, const FigureLayout& layout,
                                    const std::vector<FigureHandle>& handles, const QPointF& at);

/// What the axes of a panel say at a place, also beside the panel.
QPointF valuesAt(const Figure& figure, const FigureLayout& layout, std::size_t panel, const QPointF& at);

/// `figure` with the axes of `drawn` as they are on the screen: what is held must not run away under the
/// hand because its axis finds another extent. As it is when the two have not the same panels.
Figure withAxesOf(Figure figure, const Figure& drawn, const FigureLayout& layout);

void drawHandle(QPainter& painter, const QPointF& place, bool isHeld, const Theme& theme);

} // namespace halbench::widgets
