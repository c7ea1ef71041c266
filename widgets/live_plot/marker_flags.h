#pragma once

#include "widgets/live_plot/plot_marker.h"
#include "widgets/theme/theme.h"

#include <QPointF>
#include <QRectF>

class QPainter;
class QwtScaleMap;

namespace halbench::widgets {

/// Where a marker's note is written.
struct MarkerFlag {
    std::size_t marker = 0;
    QRectF place;
};

/// A marker's line in the canvas, and how wide its note would be.
struct MarkerLine {
    std::size_t marker = 0;
    double x = 0.0;
    double wanted_px = 0.0;
};

/// Notes begin at their line and lie in rows from the top of `room` down, so that none covers another; at the
/// right edge they end there. The chosen one is placed first, then from the left. One that finds no row with
/// room for `least_px` is not written: its line is still there, and the list of markers has its note. Lines
/// outside the room have none.
std::vector<MarkerFlag> placeFlags(std::vector<MarkerLine> lines, std::optional<std::size_t> chosen,
                                   const QRectF& room, double height_px, double least_px);

/// Markers over the curves of a plot.
struct MarkerLook {
    const Theme& theme;
    std::optional<std::size_t> chosen;
    bool hasNotes = true;  ///< they are written in one plot of a stack
    double above_px = 0.0; ///< taken at the top, by the names of cursors
};
/// Returns where the notes are, for the mouse.
std::vector<MarkerFlag> drawMarkers(QPainter& painter, const QwtScaleMap& xMap, const QRectF& canvas,
                                    const std::vector<PlotMarker>& markers, const MarkerLook& look);

/// The marker whose note is there, or whose line is at most so far away.
std::optional<std::size_t> markerAt(const QPointF& place, const std::vector<MarkerFlag>& flags,
                                    const std::vector<PlotMarker>& markers, const QwtScaleMap& xMap,
                                    double reach_px);

} // namespace halbench::widgets
