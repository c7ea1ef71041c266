#include "widgets/live_plot/plot_marks.h"

#include <QFontMetricsF>
#include <QPainter>
#include <qwt_scale_div.h>
#include <qwt_scale_map.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::widgets {
namespace {

constexpr int BandAlpha = 30; ///< of 255: curves stay the brightest thing
constexpr int BoxAlpha = 40;
constexpr double WordMargin = 4.0;
constexpr int LongestFlag = 12; ///< characters of a pair's name

QColor withAlpha(QColor colour, int alpha) {
    colour.setAlpha(alpha);
    return colour;
}

} // namespace

GridItem::GridItem() {
    setZ(0.0);
    setItemInterest(QwtPlotItem::ScaleInterest, true);
}

void GridItem::updateScaleDiv(const QwtScaleDiv& xDivision, const QwtScaleDiv& yDivision) {
    m_xTicks = xDivision.ticks(QwtScaleDiv::MajorTick);
    m_yTicks = yDivision.ticks(QwtScaleDiv::MajorTick);
}

void GridItem::draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                    const QRectF& canvas) const {
    for (const double tick : m_xTicks) {
        painter->fillRect(QRectF(std::round(xMap.transform(tick)), canvas.top(), 1.0, canvas.height()),
                          m_colour);
    }
    for (const double tick : m_yTicks) {
        painter->fillRect(QRectF(canvas.left(), std::round(yMap.transform(tick)), canvas.width(), 1.0),
                          m_colour);
    }
}

BandItem::BandItem() {
    setZ(1.0);
}

void BandItem::set(std::vector<LimitBand> bands, const Theme& theme) {
    m_bands = std::move(bands);
    m_theme = theme;
}

void BandItem::draw(QPainter* painter, const QwtScaleMap&, const QwtScaleMap& yMap,
                    const QRectF& canvas) const {
    for (const LimitBand& band : m_bands) {
        const double low = std::min(yMap.s1(), yMap.s2());
        const double high = std::max(yMap.s1(), yMap.s2());
        if (band.to <= low || band.from >= high) {
            continue;
        }
        const QColor colour = band.role == LimitBand::Role::Bad ? m_theme.bad : m_theme.warn;
        const double top = yMap.transform(std::min(band.to, high));
        const double bottom = yMap.transform(std::max(band.from, low));
        painter->fillRect(QRectF(canvas.left(), top, canvas.width(), bottom - top),
                          withAlpha(colour, BandAlpha));
        if (bottom - top >= painter->fontMetrics().height()) {
            const QString word = band.role == LimitBand::Role::Bad ? tr("limit") : tr("warning");
            painter->setPen(colour);
            painter->drawText(QRectF(canvas.left(), top, canvas.width() - WordMargin, bottom - top),
                              Qt::AlignRight | Qt::AlignTop, word);
        }
        painter->setPen(QPen(colour, 1.0));
        for (const double limit : {band.from, band.to}) {
            if (limit > low && limit < high) {
                const double y = std::round(yMap.transform(limit));
                painter->drawLine(QPointF(canvas.left(), y), QPointF(canvas.right(), y));
            }
        }
    }
}

OverlayItem::OverlayItem() {
    setZ(100.0);
}

void OverlayItem::setLevel(std::optional<double> level, double hysteresis) {
    m_level = level;
    m_hysteresis = hysteresis;
}

void OverlayItem::draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                       const QRectF& canvas) const {
    painter->save();
    drawTrigger(painter, xMap, yMap, canvas);
    const bool hasNames = m_areNamesShown && (m_event_s || m_cursors.cursors().isVisible);
    const double above_px = hasNames ? QFontMetricsF(painter->font()).height() + 1.0 : 0.0;
    m_flags =
        drawMarkers(*painter, xMap, canvas, m_markers, {m_theme, m_chosenMarker, m_areNamesShown, above_px});
    drawCursors(painter, xMap, canvas);
    if (m_hover && !m_box) {
        drawHover(*painter, *m_hover, canvas, m_theme);
    }
    if (m_box) {
        painter->setPen(QPen(m_theme.accent, 1.0));
        painter->setBrush(withAlpha(m_theme.accent, BoxAlpha));
        painter->drawRect(*m_box);
    }
    if (m_isFocused) {
        painter->setPen(QPen(m_theme.accent, 1.0));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(canvas.adjusted(0.0, 0.0, -1.0, -1.0));
    }
    if (!m_message.isEmpty()) {
        painter->setPen(m_theme.muted);
        painter->drawText(canvas, Qt::AlignCenter | Qt::TextWordWrap, m_message);
    }
    painter->restore();
}

void OverlayItem::drawFlag(QPainter* painter, double x, const QRectF& canvas, const QString& text,
                           const QColor& colour, const QColor& textColour, double side) const {
    const QFontMetricsF metrics(painter->font());
    const double width = metrics.horizontalAdvance(text) + 8.0;
    const double left =
        std::clamp(x - side * width, canvas.left(), std::max(canvas.left(), canvas.right() - width));
    const QRectF flag(left, canvas.top(), width, metrics.height());
    painter->fillRect(flag, colour);
    painter->setPen(textColour);
    painter->drawText(flag, Qt::AlignCenter, text);
}

/// Lines of the event and of the level with their letter T; the hysteresis as dots on both sides.
void OverlayItem::drawTrigger(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                              const QRectF& canvas) const {
    if (m_event_s) {
        const double x = std::round(xMap.transform(*m_event_s));
        if (x >= canvas.left() && x <= canvas.right()) {
            painter->setPen(QPen(m_theme.accent, 1.0, Qt::DashLine));
            painter->drawLine(QPointF(x, canvas.top()), QPointF(x, canvas.bottom()));
            if (m_areNamesShown) {
                drawFlag(painter, x, canvas, QStringLiteral("T"), m_theme.accent, m_theme.panel);
            }
        }
    }
    if (!m_level) {
        return;
    }
    const auto line = [&](double value, Qt::PenStyle style) {
        const double y = std::round(yMap.transform(value));
        if (y >= canvas.top() && y <= canvas.bottom()) {
            painter->setPen(QPen(m_theme.accent, 1.0, style));
            painter->drawLine(QPointF(canvas.left(), y), QPointF(canvas.right(), y));
        }
    };
    line(*m_level, Qt::SolidLine);
    if (m_hysteresis > 0.0) {
        line(*m_level - m_hysteresis, Qt::DotLine);
        line(*m_level + m_hysteresis, Qt::DotLine);
    }
    const QFontMetricsF metrics(painter->font());
    const double y = std::clamp(yMap.transform(*m_level) - metrics.height(), canvas.top(),
                                std::max(canvas.top(), canvas.bottom() - metrics.height()));
    painter->setPen(m_theme.accent);
    painter->drawText(QPointF(canvas.left() + WordMargin, y + metrics.ascent()), levelText(yMap));
}

/// With an arrow to where it is when the axis does not reach it.
QString OverlayItem::levelText(const QwtScaleMap& yMap) const {
    if (*m_level > std::max(yMap.s1(), yMap.s2())) {
        return QStringLiteral("T \u2191");
    }
    return *m_level < std::min(yMap.s1(), yMap.s2()) ? QStringLiteral("T \u2193") : QStringLiteral("T");
}

/// "A" of the only pair; of several, with its name.
QString OverlayItem::cursorFlag(const NamedPair& pair, int index) const {
    const QString letter = index == 0 ? QStringLiteral("A") : QStringLiteral("B");
    if (!m_cursors.areKept()) {
        return letter;
    }
    const bool isLong = pair.name.size() > LongestFlag;
    return QStringLiteral("%1 %2").arg(isLong ? pair.name.left(LongestFlag - 1) + QChar(0x2026) : pair.name,
                                       letter);
}

/// Flags with names stand outside their pair, so that one does not cover the other.
double OverlayItem::flagSide(const NamedPair& pair, int index) const {
    if (!m_cursors.areKept()) {
        return 0.5;
    }
    const bool isFirst = pair.at(index) < pair.at(1 - index) || (pair.a_s == pair.b_s && index == 0);
    return isFirst ? 1.0 : 0.0;
}

void OverlayItem::drawOtherCursors(QPainter* painter, const QwtScaleMap& xMap, const QRectF& canvas) const {
    for (std::size_t pair = 0; pair < m_cursors.list().size(); ++pair) {
        for (int i = 0; pair != m_cursors.chosen() && i < 2; ++i) {
            const double x = std::round(xMap.transform(m_cursors.list()[pair].at(i)));
            if (x < canvas.left() - 1.0 || x > canvas.right() + 1.0) {
                continue;
            }
            painter->setPen(QPen(m_theme.muted, 1.0, Qt::DotLine));
            painter->drawLine(QPointF(x, canvas.top()), QPointF(x, canvas.bottom()));
            if (m_areNamesShown) {
                drawFlag(painter, x, canvas, cursorFlag(m_cursors.list()[pair], i), m_theme.raised,
                         m_theme.muted, flagSide(m_cursors.list()[pair], i));
            }
        }
    }
}

/// What measures lies over the rest.
void OverlayItem::drawCursors(QPainter* painter, const QwtScaleMap& xMap, const QRectF& canvas) const {
    const CursorPair cursors = m_cursors.cursors();
    if (cursors.isVisible) {
        drawOtherCursors(painter, xMap, canvas);
    }
    for (int i = 0; cursors.isVisible && i < 2; ++i) {
        const double x = std::round(xMap.transform(cursors.at(i)));
        if (x < canvas.left() - 1.0 || x > canvas.right() + 1.0) {
            continue;
        }
        const bool isActive = i == cursors.active;
        const QColor colour = isActive ? m_theme.accent : m_theme.text;
        painter->setPen(QPen(colour, isActive ? 2.0 : 1.0));
        painter->drawLine(QPointF(x, canvas.top()), QPointF(x, canvas.bottom()));
        if (m_areNamesShown) {
            drawFlag(painter, x, canvas, cursorFlag(m_cursors.list()[m_cursors.chosen()], i), colour,
                     m_theme.panel, flagSide(m_cursors.list()[m_cursors.chosen()], i));
        }
    }
}

} // namespace halbench::widgets
