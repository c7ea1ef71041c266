#pragma once

#include "control/history/sample_history.h"
#include "widgets/live_plot/history_curve.h"
#include "widgets/theme/theme.h"

#include <QColor>
#include <QPointF>
#include <QString>

#include <vector>

class QPainter;

namespace halbench::widgets {

/// Values of the curves of a plot at the pointer.
struct HoverReadout {
    struct Line {
        QColor colour; ///< of the curve; invalid for the time
        QString text;

        bool operator==(const Line&) const = default;
    };
    QPointF place; ///< of the pointer, on the canvas
    std::vector<Line> lines;

    bool operator==(const HoverReadout&) const = default;
};

/// The time, counted from `origin_s` and with `decimals`, then each visible curve with its unit; of a curve
/// without a sample there, "–".
HoverReadout hoverReadout(const QPointF& place, double time_s, double origin_s, int decimals,
                          const std::vector<HistoryCurve*>& curves, const control::SampleHistory& history);

/// A thin line at the pointer and the values beside it, inside the canvas.
void drawHover(QPainter& painter, const HoverReadout& hover, const QRectF& canvas, const Theme& theme);

} // namespace halbench::widgets
