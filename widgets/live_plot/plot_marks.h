#pragma once

#include "widgets/live_plot/cursor_pairs.h"
#include "widgets/live_plot/hover_readout.h"
#include "widgets/live_plot/live_plot_spec.h"
#include "widgets/live_plot/marker_flags.h"
#include "widgets/live_plot/plot_marker.h"
#include "widgets/theme/theme.h"

#include <QColor>
#include <QCoreApplication>
#include <QList>
#include <QRectF>
#include <qwt_plot_item.h>

#include <optional>
#include <vector>

namespace halbench::widgets {

/// Lines at the labelled ticks. Filled as rectangles: drawn as lines they would cost more than all curves.
class GridItem : public QwtPlotItem {
public:
    GridItem();
    void setColour(const QColor& colour) { m_colour = colour; }
    void updateScaleDiv(const QwtScaleDiv& xDivision, const QwtScaleDiv& yDivision) override;
    void draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
              const QRectF& canvas) const override;

private:
    QColor m_colour;
    QList<double> m_xTicks;
    QList<double> m_yTicks;
};

/// Limit bands behind the curves, with their meaning in a word: colour alone says nothing to some.
class BandItem : public QwtPlotItem {
    Q_DECLARE_TR_FUNCTIONS(halbench::widgets::BandItem)
public:
    BandItem();
    void set(std::vector<LimitBand> bands, const Theme& theme);
    void draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
              const QRectF& canvas) const override;

private:
    std::vector<LimitBand> m_bands;
    Theme m_theme;
};

/// What lies over the curves: markers, cursors A and B, the box that is being drawn, the text of an empty
/// plot.
class OverlayItem : public QwtPlotItem {
public:
    OverlayItem();
    void setTheme(const Theme& theme) { m_theme = theme; }
    /// The pair that measures is in full strength, the others are faint and have their names.
    void setCursors(const CursorPairs& cursors) { m_cursors = cursors; }
    void setMarkers(std::vector<PlotMarker> markers, std::optional<std::size_t> chosen) {
        m_markers = std::move(markers);
        m_chosenMarker = chosen;
    }
    /// As it was drawn last: the note there, or the line at most so far away.
    std::optional<std::size_t> markerAt(const QPointF& place, const QwtScaleMap& xMap,
                                        double reach_px) const {
        return widgets::markerAt(place, m_flags, m_markers, xMap, reach_px);
    }
    void setFocused(bool isFocused) { m_isFocused = isFocused; }
    void setBox(std::optional<QRectF> box) { m_box = box; }
    /// The moment of a trigger's event.
    void setEvent(std::optional<double> event_s) { m_event_s = event_s; }
    /// A trigger's level and the one that hysteresis asks for, in the unit shown.
    void setLevel(std::optional<double> level, double hysteresis);
    void setMessage(const QString& message) { m_message = message; }
    void setHover(std::optional<HoverReadout> hover) { m_hover = std::move(hover); }
    const std::optional<HoverReadout>& hover() const { return m_hover; }
    /// Names of cursors and markers are written in the topmost plot only.
    void setNamesShown(bool areShown) { m_areNamesShown = areShown; }
    void draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
              const QRectF& canvas) const override;

private:
    /// `side`: which part of its width lies at the left of the line.
    void drawFlag(QPainter* painter, double x, const QRectF& canvas, const QString& text,
                  const QColor& colour, const QColor& textColour, double side = 0.5) const;
    double flagSide(const NamedPair& pair, int index) const;
    void drawCursors(QPainter* painter, const QwtScaleMap& xMap, const QRectF& canvas) const;
    void drawOtherCursors(QPainter* painter, const QwtScaleMap& xMap, const QRectF& canvas) const;
    QString cursorFlag(const NamedPair& pair, int index) const;
    void drawTrigger(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                     const QRectF& canvas) const;
    QString levelText(const QwtScaleMap& yMap) const;

    Theme m_theme;
    CursorPairs m_cursors;
    std::vector<PlotMarker> m_markers;
    std::optional<std::size_t> m_chosenMarker;
    mutable std::vector<MarkerFlag> m_flags; ///< where their notes were drawn
    std::optional<QRectF> m_box;
    std::optional<double> m_event_s;
    std::optional<double> m_level;
    double m_hysteresis = 0.0;
    QString m_message;
    std::optional<HoverReadout> m_hover;
    bool m_areNamesShown = true;
    bool m_isFocused = false;
};

} // namespace halbench::widgets
