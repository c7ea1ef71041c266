#include "widgets/figure/figure_painter.h"

#include "widgets/figure/curve_layers.h"
#include "widgets/figure/figure_axis.h"
#include "widgets/figure/figure_scales.h"
#include "widgets/figure/label_places.h"
#include "widgets/figure/panel_layers.h"
#include "widgets/raster/decimation.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPalette>
#include <QRegularExpression>
#include <QVector>
#include <qwt_painter.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_symbol.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <vector>

namespace halbench::widgets {
namespace {

constexpr double CurveWidth_px = 1.5;
constexpr double SymbolSize_px = 6.0;
constexpr std::size_t ColumnsPerPixel = 1;
constexpr double TitleBaseline_px = 18.0; ///< of a vertical axis' title, from the left edge
constexpr double RightTitle_px = 10.0;    ///< from the right one

QPen curvePen(CurveStyle style, const QColor& colour) {
    QPen pen(colour, isMarkers(style) ? 1.2 : CurveWidth_px);
    pen.setCapStyle(Qt::FlatCap); // square ends would fill the gaps, and hide the curve below
    pen.setStyle(style == CurveStyle::DashedLine    ? Qt::DashLine
                 : style == CurveStyle::DottedLine  ? Qt::DotLine
                 : style == CurveStyle::DashDotLine ? Qt::DashDotLine
                                                    : Qt::SolidLine);
    if (style == CurveStyle::DashedLine) {
        pen.setDashPattern({4.0, 4.0}); // as much of the curve below is seen where both agree
    }
    pen.setJoinStyle(Qt::RoundJoin);
    return pen;
}

QColor bandColour(QColor colour) {
    constexpr double Faint = 0.22; // the curve within and the grid behind are both seen
    colour.setAlphaF(Faint);
    return colour;
}

QColor faint(QColor colour) {
    constexpr double Share = 0.6;
    colour.setAlphaF(Share);
    return colour;
}

void drawMarker(QPainter& painter, CurveStyle style, const QColor& colour, const QPointF& centre) {
    const QwtSymbol symbol(style == CurveStyle::Crosses ? QwtSymbol::XCross : QwtSymbol::Ellipse,
                           style == CurveStyle::Points ? QBrush(colour) : QBrush(Qt::NoBrush),
                           curvePen(style, colour), QSize(int(SymbolSize_px), int(SymbolSize_px)));
    symbol.drawSymbol(&painter, centre);
}

/// The numbers of a label in the user's notation; names with digits and points stay.
QString withPoint(const std::string& label, QChar decimalPoint) {
    static const QRegularExpression number(QStringLiteral("(?<![\\w.])([0-9]+)\\.([0-9]+)(?![\\w.])"));
    const QString words = QString::fromStdString(label);
    return decimalPoint == QLatin1Char('.')
               ? words
               : QString(words).replace(number, QStringLiteral("\\1%1\\2").arg(decimalPoint));
}

/// Everything that belongs to one panel.
class PanelPainter {
public:
    PanelPainter(QPainter& painter, const Theme& theme, const QRectF& canvas, const FigureScale& x,
                 const FigureScale& y, QChar decimalPoint)
        : m_painter(painter), m_theme(theme), m_canvas(canvas), m_x(x), m_y(y), m_decimalPoint(decimalPoint),
          m_xMap(x.map(canvas.left(), canvas.right())), m_yMap(y.map(canvas.bottom(), canvas.top())) {}

    void drawBackground() {
        m_painter.fillRect(m_canvas, m_theme.plotBackground);
        QwtPlotGrid grid;
        grid.setPen(m_theme.plotGrid, 1.0);
        grid.setXDiv(m_x.division);
        grid.setYDiv(m_y.division);
        grid.draw(&m_painter, m_xMap, m_yMap, m_canvas);
        m_painter.setPen(QPen(m_theme.line, 1.0));
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawRect(m_canvas);
    }

    void drawReferenceLine(const ReferenceLine& line) {
        const std::optional<double> at_px = placeOf(line);
        if (at_px) {
            m_painter.setPen(QPen(line.isFaint ? faint(m_theme.muted) : m_theme.muted, 1.0,
                                  line.isFaint ? Qt::DotLine : Qt::DashLine));
            m_painter.drawLine(isHorizontal(line)
                                   ? QLineF(m_canvas.left(), *at_px, m_canvas.right(), *at_px)
                                   : QLineF(*at_px, m_canvas.top(), *at_px, m_canvas.bottom()));
        }
    }

    /// Drawn after the curves, where nothing else is; else on a patch of background that keeps it readable.
    void drawReferenceLabel(const ReferenceLine& line, const Panel& panel) {
        const std::optional<double> at_px = placeOf(line);
        if (!at_px || line.label.empty()) {
            return;
        }
        const QString label = withPoint(line.label, m_decimalPoint);
        const QSizeF size(QFontMetricsF(figureFont()).horizontalAdvance(label) + 4.0, 14.0);
        const std::vector<QRectF> places =
            isHorizontal(line) ? placesAtRow(m_canvas, *at_px, size) : placesAtColumn(m_canvas, *at_px, size);
        const QRectF region = std::accumulate(places.begin(), places.end(), QRectF(), std::bit_or<>());
        const std::vector<QRectF> boxes = boxesWithin(region, panel.curves, m_xMap, m_yMap);
        const auto isInside = [&](const QRectF& place) { return m_canvas.contains(place); };
        const auto isApart = [&](const QRectF& place) { return isInside(place) && !isTaken(place); };
        const auto isOffCurves = [&](const QRectF& place) {
            return isApart(place) && !isOnCurve(place, boxes);
        };
        auto found = std::find_if(places.begin(), places.end(), [&](const QRectF& place) {
            return isOffCurves(place) && !isCrossed(place, panel.lines);
        });
        const bool needsPatch = found == places.end();
        found = needsPatch ? std::find_if(places.begin(), places.end(), isOffCurves) : found;
        found = found == places.end() ? std::find_if(places.begin(), places.end(), isApart) : found;
        if (found == places.end() && line.isFaint) {
            return; // one label upon another is none
        }
        found = found == places.end() ? std::find_if(places.begin(), places.end(), isInside) : found;
        const QRectF place = found != places.end() ? *found : places.front();
        if (needsPatch) {
            m_painter.fillRect(place, m_theme.plotBackground);
        }
        m_labels.push_back(place);
        m_painter.setFont(figureFont());
        m_painter.setPen(m_theme.muted);
        m_painter.drawText(QPointF(place.left() + 2.0, place.bottom() - 3.0), label);
    }

    void drawCurve(const Curve& curve, const QColor& colour) {
        if (curve.style == CurveStyle::Band) {
            return; // lies behind all of them
        }
        const auto columns = static_cast<std::size_t>(m_canvas.width()) * ColumnsPerPixel;
        const auto stretches =
            decimated(curve.x, curve.y, m_x.division.lowerBound(), m_x.division.upperBound(), columns);
        for (const Polyline& stretch : stretches) {
            if (isMarkers(curve.style)) {
                drawMarkers(stretch, curve.style, colour);
            } else {
                drawLine(stretch, curvePen(curve.style, colour));
            }
        }
    }

    void drawBand(const Curve& curve, const QColor& colour) {
        if (curve.style != CurveStyle::Band) {
            return;
        }
        const double far_px = 2.0 * m_canvas.height(); // what lies further off fills no other pixel
        QPolygonF outline;
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            const QPointF place(m_xMap.transform(curve.x[i]), m_yMap.transform(curve.y[i]));
            if (std::isfinite(place.x()) && !std::isnan(place.y())) {
                outline << QPointF(
                    place.x(), std::clamp(place.y(), m_canvas.top() - far_px, m_canvas.bottom() + far_px));
            }
        }
        m_painter.save();
        m_painter.setClipRect(m_canvas, Qt::IntersectClip);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(bandColour(colour));
        m_painter.drawPolygon(outline);
        m_painter.restore();
    }

    void drawScale(QwtScaleDraw::Alignment alignment, bool hasLabels) {
        const bool isBottom = alignment == QwtScaleDraw::BottomScale;
        FigureAxis scale(isBottom ? m_x : m_y, alignment, m_canvas);
        scale.setDecimalPoint(m_decimalPoint);
        scale.enableComponent(QwtAbstractScaleDraw::Labels, hasLabels);
        QPalette palette;
        palette.setColor(QPalette::WindowText, m_theme.plotAxis);
        palette.setColor(QPalette::Text, m_theme.muted);
        m_painter.setFont(figureFont());
        scale.draw(&m_painter, palette);
    }

    void drawLayer(const PanelLayer& layer) {
        if (layer) {
            m_painter.save();
            m_painter.setFont(figureFont());
            m_painter.setClipRect(m_canvas, Qt::IntersectClip);
            layer(m_painter, m_xMap, m_yMap, m_canvas, m_theme);
            m_painter.restore();
        }
    }

private:
    static bool isHorizontal(const ReferenceLine& line) {
        return line.direction == ReferenceLine::Direction::Horizontal;
    }

    bool isCrossed(const QRectF& place, const std::vector<ReferenceLine>& lines) const {
        return std::any_of(lines.begin(), lines.end(), [&](const ReferenceLine& line) {
            const std::optional<double> at_px = placeOf(line);
            return at_px && (isHorizontal(line) ? place.top() <= *at_px && *at_px <= place.bottom()
                                                : place.left() <= *at_px && *at_px <= place.right());
        });
    }

    bool isTaken(const QRectF& place) const {
        return std::any_of(m_labels.begin(), m_labels.end(),
                           [&](const QRectF& label) { return label.intersects(place); });
    }

    /// Pixel row or column of the line; nothing when it lies outside the panel.
    std::optional<double> placeOf(const ReferenceLine& line) const {
        const double at_px = std::round((isHorizontal(line) ? m_yMap : m_xMap).transform(line.at));
        const bool isInside = isHorizontal(line) ? at_px >= m_canvas.top() && at_px <= m_canvas.bottom()
                                                 : at_px >= m_canvas.left() && at_px <= m_canvas.right();
        return isInside ? std::optional<double>(at_px) : std::nullopt;
    }

    void drawMarkers(const Polyline& points, CurveStyle style, const QColor& colour) {
        for (const auto& [x, y] : points) {
            const QPointF centre(m_xMap.transform(x), m_yMap.transform(y));
            if (m_canvas.contains(centre)) {
                drawMarker(m_painter, style, colour, centre);
            }
        }
    }

    void drawLine(const Polyline& points, const QPen& pen) {
        QVector<QPointF> samples;
        samples.reserve(static_cast<int>(points.size()));
        for (const auto& [x, y] : points) {
            samples.push_back({x, y});
        }
        QwtPlotCurve curve;
        constexpr int DenseJoins = 200; // as many round ones cost more than the lines and are not seen
        QPen joined = pen;
        joined.setJoinStyle(samples.size() > DenseJoins ? Qt::BevelJoin : pen.joinStyle());
        curve.setPen(joined);
        curve.setSamples(samples);
        QwtPainter::setRoundingAlignment(false); // else points snap to whole pixels and the line wobbles
        QwtPainter::setPolylineSplitting(pen.style() ==
                                         Qt::SolidLine); // dashes would begin anew in each part
        curve.draw(&m_painter, m_xMap, m_yMap, m_canvas);
        QwtPainter::setPolylineSplitting(true);
        QwtPainter::setRoundingAlignment(true);
    }

    QPainter& m_painter;
    const Theme& m_theme;
    QRectF m_canvas;
    const FigureScale& m_x;
    const FigureScale& m_y;
    QChar m_decimalPoint;
    QwtScaleMap m_xMap;
    QwtScaleMap m_yMap;
    std::vector<QRectF> m_labels; ///< that are drawn already
};

void drawLegend(QPainter& painter, const FigureLayout::PanelPlace& place, const Theme& theme,
                QChar decimalPoint) {
    painter.setFont(figureFont());
    for (const FigureLayout::LegendEntry& entry : place.legend) {
        const QColor colour = theme.curves[static_cast<std::size_t>(entry.colour)];
        const QPointF middle(entry.left + 9.0, entry.baseline - 4.0);
        if (entry.curve->style == CurveStyle::Band) {
            painter.fillRect(QRectF(middle - QPointF(9.0, 5.0), QSizeF(18.0, 10.0)), bandColour(colour));
        } else if (isMarkers(entry.curve->style)) {
            drawMarker(painter, entry.curve->style, colour, middle);
        } else {
            painter.setPen(curvePen(entry.curve->style, colour));
            painter.drawLine(middle - QPointF(9.0, 0.0), middle + QPointF(9.0, 0.0));
        }
        painter.setPen(theme.text);
        painter.drawText(QPointF(entry.left + 24.0, entry.baseline),
                         withPoint(entry.curve->label, decimalPoint));
    }
}

std::vector<double> numbersOf(const std::vector<const FigureScale*>& scales) {
    std::vector<double> numbers;
    for (const FigureScale* scale : scales) {
        numbers.insert(numbers.end(), {scale->division.lowerBound(), scale->division.upperBound(),
                                       scale->isLogarithmic ? 1.0 : 0.0});
    }
    return numbers;
}

/// Above its panels; a long one begins at the edge of the picture before a letter of it is left out.
void drawTitle(QPainter& painter, const Figure& figure, const FigureLayout& layout) {
    constexpr double Edge_px = 8.0;
    const QString title = QString::fromStdString(figure.title);
    const QFontMetricsF metrics(figureFont(true));
    const double end_px = layout.size.width() - Edge_px;
    const double left_px =
        std::clamp(end_px - metrics.horizontalAdvance(title), Edge_px, layout.panels.front().canvas.left());
    painter.drawText(QPointF(left_px, layout.titleBaseline),
                     metrics.elidedText(title, Qt::ElideRight, end_px - left_px));
}

} // namespace

void paintFigure(QPainter& painter, const Figure& figure, const FigureLayout& layout, const Theme& theme,
                 QChar decimalPoint) {
    paintFigure(painter, figure, layout, theme, decimalPoint, {});
}

void paintFigure(QPainter& painter, const Figure& figure, const FigureLayout& layout, const Theme& theme,
                 QChar decimalPoint, const std::vector<PanelLayers>& layers, CurveLayers* stays) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(0.5, 0.5); // one-pixel lines fill whole pixels
    painter.setFont(figureFont(true));
    painter.setPen(theme.text);
    drawTitle(painter, figure, layout);
    const FigureScale x = horizontalScale(figure, layout.panels.front().canvas.width()); // of all panels
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
        const Panel& panel = figure.panels[i];
        const FigureLayout::PanelPlace& place = layout.panels[i];
        const bool isLast = i + 1 == figure.panels.size();
        const FigureScale y = verticalScale(panel, place.canvas.height());
        PanelPainter panelPainter(painter, theme, place.canvas, x, y, decimalPoint);
        panelPainter.drawBackground();
        const PanelLayers within = i < layers.size() ? layers[i] : PanelLayers{};
        panelPainter.drawLayer(within.below);
        const auto colourOf = [&](std::size_t curve) {
            const int colour = panel.curves[curve].colour.value_or(static_cast<int>(curve)) % 8;
            return theme.curves[static_cast<std::size_t>(colour)];
        };
        for (std::size_t k = 0; k < panel.curves.size(); ++k) {
            panelPainter.drawBand(panel.curves[k], colourOf(k));
        }
        for (const ReferenceLine& line : panel.lines) {
            panelPainter.drawReferenceLine(line);
        }
        const FigureScale right = panel.right ? rightScale(panel, place.canvas.height()) : y;
        PanelPainter rightPainter(painter, theme, place.canvas, x, right, decimalPoint);
        const auto drawCurves = [&](QPainter& on, std::size_t first, std::size_t end) {
            PanelPainter left(on, theme, place.canvas, x, y, decimalPoint);
            PanelPainter atRight(on, theme, place.canvas, x, right, decimalPoint);
            for (std::size_t k = first; k < end; ++k) {
                (panel.curves[k].isRight ? atRight : left).drawCurve(panel.curves[k], colourOf(k));
            }
        };
        for (std::size_t k = 0; k < panel.curves.size();) {
            const CurveLayers::Run run = stays ? stays->runFrom(i, k) : CurveLayers::Run{i, k, k};
            const std::size_t end = std::max(run.end, k + 1);
            if (run.end == k ||
                !stays->lay(painter, run, place.canvas, numbersOf({&x, &y, &right}), drawCurves)) {
                drawCurves(painter, k, end);
            }
            k = end;
        }
        for (const bool isFaint : {false, true}) { // what decides has the first choice of places
            for (const ReferenceLine& line : panel.lines) {
                if (line.isFaint == isFaint) {
                    panelPainter.drawReferenceLabel(line, panel);
                }
            }
        }
        panelPainter.drawLayer(within.above);
        panelPainter.drawScale(QwtScaleDraw::LeftScale, true);
        panelPainter.drawScale(QwtScaleDraw::BottomScale, isLast);
        drawLegend(painter, place, theme, decimalPoint);
        drawVerticalTitle(painter, panel.y, TitleBaseline_px, place.canvas, theme);
        if (panel.right) {
            rightPainter.drawScale(QwtScaleDraw::RightScale, true);
            drawVerticalTitle(painter, *panel.right, layout.size.width() - RightTitle_px, place.canvas,
                              theme);
        }
        if (isLast) {
            drawHorizontalTitle(painter, figure.x, place.canvas, theme);
        }
    }
}

} // namespace halbench::widgets
