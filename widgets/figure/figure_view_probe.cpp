// What is read off a figure on the screen: a sample, or everything at one place along its curves.
#include "widgets/figure/figure_cursor.h"
#include "widgets/figure/figure_view.h"
#include "widgets/theme/theme_style.h"

#include <QAccessible>
#include <QFontMetricsF>
#include <QKeyEvent>
#include <QPainter>

#include <algorithm>

namespace halbench::widgets {
namespace {

std::optional<double> abscissaOf(const Figure& figure, const FigurePoint& point) {
    if (point.panel >= figure.panels.size() || point.curve >= figure.panels[point.panel].curves.size()) {
        return std::nullopt;
    }
    const Curve& curve = figure.panels[point.panel].curves[point.curve];
    return point.index < curve.x.size() ? std::optional(curve.x[point.index]) : std::nullopt;
}

bool isSameAxis(const Axis* one, const Axis* other) {
    return one != nullptr && other != nullptr && one->quantity == other->quantity && one->unit == other->unit;
}

/// Without the curves of a plane that do not run along its parameter: they would hide one that does.
Figure withParameter(Figure figure) {
    for (Panel& panel : figure.panels) {
        for (Curve& curve : panel.curves) {
            if (!figure.isLinked && figure.parameter && curve.parameter.empty()) {
                curve.x.clear();
                curve.y.clear();
            }
        }
    }
    return figure;
}

/// Beside a sample, within the picture.
QRectF wordsPlace(const QPointF& at, const QSizeF& words, double width_px) {
    const double right_px = width_px - words.width() - 4.0;
    const double left_px = std::clamp(at.x() + 10.0, 4.0, std::max(4.0, right_px));
    const double above_px = at.y() - words.height() - 10.0;
    return {QPointF(left_px, above_px < 4.0 ? at.y() + 10.0 : above_px), words};
}

} // namespace

/// Where curves run along something, a mark stays there; else while its sample keeps its place.
void FigureView::keepProbe(const Figure& before) {
    if (!m_probe) {
        return;
    }
    const auto along = alongOf(before, *m_probe);
    if (along && isSameAxis(alongAxis(before), alongAxis(m_figure))) {
        m_probe = pointAlong(m_figure, *along, *m_probe);
    } else if (abscissaOf(m_figure, *m_probe) != abscissaOf(before, *m_probe)) {
        m_probe.reset();
    }
    m_isPinned = m_isPinned && m_probe;
}

void FigureView::drawProbe(QPainter& painter, const Figure& figure, const FigureLayout& layout) const {
    if (!m_probe) {
        return;
    }
    const Theme theme = currentTheme();
    if (const auto along = alongOf(figure, *m_probe)) {
        drawCursor(painter, figure, layout, *along, theme);
        return;
    }
    const auto place = placeOf(figure, layout, *m_probe);
    if (!place) {
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme.text, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(*place, 6.0, 6.0);
    const QFont font = figureFont();
    const QSizeF words(QFontMetricsF(font).horizontalAdvance(probeText()) + 12.0, 20.0);
    const QRectF box = wordsPlace(*place, words, width() / scale());
    painter.setPen(QPen(theme.line, 1.0));
    painter.setBrush(theme.raised);
    painter.drawRoundedRect(box, 3.0, 3.0);
    painter.setFont(font);
    painter.setPen(theme.text);
    painter.drawText(box, Qt::AlignCenter, probeText());
}

QString FigureView::probeText() const {
    if (!m_probe) {
        return {};
    }
    const auto along = alongOf(m_figure, *m_probe);
    return along ? cursorText(m_figure, layOut(m_figure, static_cast<int>(width() / scale())), *along)
                 : pointText(m_figure, *m_probe);
}

std::optional<double> FigureView::probedAlong() const {
    return m_probe ? alongOf(m_figure, *m_probe) : std::nullopt;
}

void FigureView::probeAlong(double value) {
    probe(pointAlong(m_figure, value, m_probe.value_or(FigurePoint{})));
    m_isPinned = m_probe.has_value();
}

void FigureView::probe(std::optional<FigurePoint> point) {
    if (point == m_probe) {
        return;
    }
    m_probe = point;
    refreshWords();
    update();
    QAccessibleEvent said(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&said);
}

/// The nearest sample; in linked panels anywhere in one of them, what is there.
std::optional<FigurePoint> FigureView::pointUnder(const QPoint& at) const {
    constexpr double Reach_px = 14.0;
    if (isEmpty()) {
        return std::nullopt;
    }
    const auto shown = arranged();
    const Figure& figure = shown->figure;
    const FigureLayout& layout = shown->layout;
    const QPointF place = QPointF(at) / scale();
    if (const auto near = nearestPoint(withParameter(figure), layout, place, Reach_px)) {
        return near;
    }
    for (std::size_t panel = 0; figure.isLinked && panel < layout.panels.size(); ++panel) {
        if (layout.panels[panel].canvas.contains(place)) {
            return pointAlong(figure, valuesAt(figure, layout, panel, place).x(), {panel, 0, 0});
        }
    }
    return std::nullopt;
}

void FigureView::probeAt(const QPoint& at) {
    if (!m_isPinned) {
        probe(pointUnder(at));
    }
}

/// A click keeps what is read there while the pointer goes elsewhere; one beside the panels lets it go.
void FigureView::pinAt(const QPoint& at) {
    if (alongAxis(m_figure) != nullptr) {
        probe(pointUnder(at));
        m_isPinned = m_probe.has_value();
    }
}

void FigureView::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    showUnder(std::nullopt);
    if (!hasFocus() && !m_isPinned) {
        probe(std::nullopt);
    }
}

void FigureView::keyPressEvent(QKeyEvent* event) {
    const bool isForward = event->key() == Qt::Key_Right;
    if (step(*event)) {
        return;
    }
    if (isEmpty() || (!isForward && event->key() != Qt::Key_Left)) {
        QWidget::keyPressEvent(event); // Esc stops the motor, it belongs to the window
        return;
    }
    const auto shown = arranged();
    const Figure& figure = shown->figure;
    const FigureLayout& layout = shown->layout;
    if (!m_probe) {
        // The walk begins at the first sample that can be seen.
        probe(nearestPoint(withParameter(figure), layout, layout.panels.front().canvas.bottomLeft(), 1e6));
    } else {
        probe(neighbour(figure, layout, *m_probe, isForward ? 1 : -1));
    }
}

} // namespace halbench::widgets
