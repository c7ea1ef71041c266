#include "widgets/live_plot/marker_flags.h"

#include <QFontMetricsF>
#include <QPainter>
#include <qwt_scale_map.h>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr double Margin_px = 4.0;
constexpr double Gap_px = 3.0;
constexpr int MostRows = 3; ///< the rest of the plot is for the curves
constexpr double MostOfPlot_ratio = 0.5;
constexpr double MostWidth_ratio = 0.4; ///< of the canvas, for one note
constexpr int LeastCharacters = 4;

/// What is free of a row to the right of a place that is free itself; nothing where it is not.
std::optional<double> freeUntil(const std::vector<MarkerFlag>& flags, double top, double left, double end) {
    for (const MarkerFlag& flag : flags) {
        if (flag.place.top() != top || flag.place.right() + Gap_px <= left) {
            continue;
        }
        if (flag.place.left() <= left) {
            return std::nullopt;
        }
        end = std::min(end, flag.place.left() - Gap_px);
    }
    return end;
}

/// The first row with room for all of the note, else the one with the most.
std::optional<QRectF> placeFor(const MarkerLine& line, const std::vector<MarkerFlag>& flags,
                               const QRectF& room, double height_px, double least_px) {
    const int rows = std::clamp(static_cast<int>(MostOfPlot_ratio * room.height() / height_px), 1, MostRows);
    const double wanted_px = std::max(least_px, std::min(line.wanted_px, MostWidth_ratio * room.width()));
    const double left = std::max(room.left(), std::min(line.x, room.right() - wanted_px));
    std::optional<QRectF> best;
    for (int row = 0; row < rows; ++row) {
        const double top = room.top() + row * height_px;
        const auto end = freeUntil(flags, top, left, room.right());
        const double width = end ? std::min(wanted_px, *end - left) : 0.0;
        if (width >= std::min(least_px, line.wanted_px) && (!best || width > best->width())) {
            best = QRectF(left, top, width, height_px);
        }
    }
    return best;
}

void drawFlag(QPainter& painter, const QRectF& place, const QString& note, bool isChosen,
              const Theme& theme) {
    const QFontMetricsF metrics(painter.font());
    painter.fillRect(place, isChosen ? theme.accent : theme.raised);
    painter.setPen(isChosen ? theme.panel : theme.text);
    const QRectF inside = place.adjusted(Margin_px, 0.0, -Margin_px, 0.0);
    const QString text = metrics.elidedText(note.simplified(), Qt::ElideRight, inside.width() + 0.5);
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, text);
}

} // namespace

std::vector<MarkerFlag> placeFlags(std::vector<MarkerLine> lines, std::optional<std::size_t> chosen,
                                   const QRectF& room, double height_px, double least_px) {
    std::stable_sort(lines.begin(), lines.end(), [&](const MarkerLine& one, const MarkerLine& other) {
        const bool isOne = chosen == one.marker;
        const bool isOther = chosen == other.marker;
        return isOne != isOther ? isOne : one.x < other.x;
    });
    std::vector<MarkerFlag> flags;
    for (const MarkerLine& line : lines) {
        if (line.x < room.left() || line.x > room.right() || line.wanted_px <= 0.0) {
            continue;
        }
        if (const auto place = placeFor(line, flags, room, height_px, least_px)) {
            flags.push_back({line.marker, *place});
        }
    }
    return flags;
}

std::vector<MarkerFlag> drawMarkers(QPainter& painter, const QwtScaleMap& xMap, const QRectF& canvas,
                                    const std::vector<PlotMarker>& markers, const MarkerLook& look) {
    const QFontMetricsF metrics(painter.font());
    std::vector<MarkerLine> lines;
    for (std::size_t i = 0; i < markers.size(); ++i) {
        const double x = std::round(xMap.transform(markers[i].time_s));
        if (x < canvas.left() || x > canvas.right()) {
            continue;
        }
        const bool isChosen = look.chosen == i;
        painter.setPen(QPen(isChosen ? look.theme.accent : look.theme.muted, 1.0, Qt::DashLine));
        painter.drawLine(QPointF(x, canvas.top()), QPointF(x, canvas.bottom()));
        const QString note = markers[i].text.simplified();
        const double width = metrics.horizontalAdvance(note) + 2.0 * Margin_px;
        lines.push_back({i, x, note.isEmpty() ? 0.0 : std::ceil(width)});
    }
    if (!look.hasNotes) {
        return {};
    }
    const double least_px = LeastCharacters * metrics.averageCharWidth() + 2.0 * Margin_px;
    const std::vector<MarkerFlag> flags =
        placeFlags(std::move(lines), look.chosen, canvas.adjusted(0.0, look.above_px, 0.0, 0.0),
                   std::ceil(metrics.height()) + 1.0, least_px);
    for (const MarkerFlag& flag : flags) {
        drawFlag(painter, flag.place.adjusted(0.0, 0.0, 0.0, -1.0), markers[flag.marker].text,
                 look.chosen == flag.marker, look.theme);
    }
    return flags;
}

std::optional<std::size_t> markerAt(const QPointF& place, const std::vector<MarkerFlag>& flags,
                                    const std::vector<PlotMarker>& markers, const QwtScaleMap& xMap,
                                    double reach_px) {
    for (const MarkerFlag& flag : flags) {
        if (flag.place.contains(place)) {
            return flag.marker;
        }
    }
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < markers.size(); ++i) {
        const double away_px = std::abs(xMap.transform(markers[i].time_s) - place.x());
        if (away_px <= reach_px) {
            reach_px = away_px;
            nearest = i;
        }
    }
    return nearest;
}

} // namespace halbench::widgets
