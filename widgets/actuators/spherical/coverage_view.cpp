#include "widgets/actuators/spherical/coverage_view.h"

#include "widgets/language/display_units.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QImage>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr int KeySteps = 10; ///< of Page Up and Page Down
constexpr double Tick_deg = 15.0;
constexpr double LeastTick_px = 34.0; ///< between two labels
constexpr double BarWidth_px = 14.0;
constexpr double Gap_px = 8.0;
constexpr double Cross_px = 7.0;
constexpr int ColourSteps = 64;

QColor between(const QColor& low, const QColor& high, double share) {
    const auto part = [share](int a, int b) { return static_cast<int>(std::lround(a + share * (b - a))); };
    return {part(low.red(), high.red()), part(low.green(), high.green()), part(low.blue(), high.blue())};
}

/// From the ground of the picture to its first curve.
QColor colourOf(const Theme& theme, double share) {
    return between(theme.plotBackground, theme.curves[0], std::clamp(share, 0.0, 1.0));
}

void drawCross(QPainter& painter, const QPointF& at) {
    painter.drawLine(at - QPointF(Cross_px, 0.0), at + QPointF(Cross_px, 0.0));
    painter.drawLine(at - QPointF(0.0, Cross_px), at + QPointF(0.0, Cross_px));
}

/// Degrees between two labels, so that they do not touch.
double tickStep(const SliceAxis& axis, double length_px) {
    const double span_deg = std::max(axis.last_deg() - axis.first_deg, Tick_deg);
    double step_deg = Tick_deg;
    while (step_deg / span_deg * length_px < LeastTick_px) {
        step_deg *= 2.0;
    }
    return step_deg;
}

} // namespace

CoverageView::CoverageView(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setFocusPolicy(Qt::StrongFocus);
    describe();
}

void CoverageView::setSlice(CoverageSlice slice) {
    m_slice = std::move(slice);
    m_column = std::min(m_column, m_slice.x.count - 1);
    m_row = std::min(m_row, m_slice.y.count - 1);
    describe();
    update();
}

QString CoverageView::cursorText() const {
    if (m_slice.values.empty() || m_column < 0 || m_row < 0) {
        return {};
    }
    const std::size_t index = m_slice.indexOf(m_column, m_row);
    const QString words = QStringLiteral("%1 %2°, %3 %4°: %5 %6")
                              .arg(m_slice.x.name, numberText(m_slice.x.at(m_column), 4), m_slice.y.name,
                                   numberText(m_slice.y.at(m_row), 4),
                                   fixedText(m_slice.values[index], m_slice.decimals), m_slice.unit);
    return m_slice.isUncovered[index] ? tr("%1, not covered").arg(words) : words;
}

std::optional<QPointF> CoverageView::cursor() const {
    if (m_slice.values.empty() || m_column < 0 || m_row < 0) {
        return {};
    }
    return QPointF(m_slice.x.at(m_column), m_slice.y.at(m_row));
}

QRectF CoverageView::mapOf(const QSizeF& size, const QFontMetricsF& metrics) const {
    const double left = metrics.horizontalAdvance(QStringLiteral("−90")) + 2.0 * Gap_px + metrics.height();
    const double right = BarWidth_px + 3.0 * Gap_px + metrics.horizontalAdvance(QStringLiteral("000.000"));
    const double below = 2.0 * metrics.height() + Gap_px;
    return {left, metrics.height() + Gap_px, std::max(1.0, size.width() - left - right),
            std::max(1.0, size.height() - metrics.height() - Gap_px - below)};
}

/// Poses are cells; their middles lie half a cell inside the border.
QPointF CoverageView::placeOf(const QRectF& map, double x_deg, double y_deg) const {
    const auto share = [](const SliceAxis& axis, double at_deg) {
        return ((at_deg - axis.first_deg) / axis.step_deg + 0.5) / axis.count;
    };
    return {map.left() + share(m_slice.x, x_deg) * map.width(),
            map.bottom() - share(m_slice.y, y_deg) * map.height()};
}

void CoverageView::drawMap(QPainter& painter, const Theme& theme, const QRectF& map) const {
    QImage image(m_slice.x.count, m_slice.y.count, QImage::Format_RGB32);
    for (int row = 0; row < m_slice.y.count; ++row) {
        for (int column = 0; column < m_slice.x.count; ++column) {
            const std::size_t index = m_slice.indexOf(column, row);
            const double value = m_slice.values[index];
            const double share = (value - m_slice.low) / (m_slice.high - m_slice.low);
            const QColor colour = m_slice.isUncovered[index] ? theme.bad
                                  : std::isfinite(value)     ? colourOf(theme, share)
                                                             : theme.panel;
            image.setPixel(column, m_slice.y.count - 1 - row, colour.rgb());
        }
    }
    painter.drawImage(map, image);
}

void CoverageView::drawAxes(QPainter& painter, const Theme& theme, const QRectF& map) const {
    const QFontMetricsF metrics(painter.font());
    painter.setPen(theme.plotAxis);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(map);
    painter.setPen(theme.text);
    const auto labels = [](const SliceAxis& axis, double step_deg) {
        std::vector<double> found;
        for (double at = std::ceil(axis.first_deg / step_deg) * step_deg; at <= axis.last_deg() + 1e-9;
             at += step_deg) {
            found.push_back(at);
        }
        return found;
    };
    for (const double at : labels(m_slice.x, tickStep(m_slice.x, map.width()))) {
        const double x = placeOf(map, at, m_slice.y.first_deg).x();
        painter.drawText(QRectF(x - LeastTick_px, map.bottom() + 2.0, 2.0 * LeastTick_px, metrics.height()),
                         Qt::AlignCenter, numberText(at, 3));
    }
    for (const double at : labels(m_slice.y, tickStep(m_slice.y, map.height()))) {
        const double y = placeOf(map, m_slice.x.first_deg, at).y();
        painter.drawText(QRectF(0.0, y - metrics.height() / 2.0, map.left() - Gap_px, metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter, numberText(at, 3));
    }
    painter.drawText(QRectF(map.left(), map.bottom() + metrics.height() + 2.0, map.width(), metrics.height()),
                     Qt::AlignCenter, m_slice.x.name + QStringLiteral(" [°]"));
    painter.drawText(QRectF(2.0, 0.0, map.left() + map.width() / 2.0, metrics.height()), Qt::AlignLeft,
                     m_slice.y.name + QStringLiteral(" [°]"));
}

void CoverageView::drawColours(QPainter& painter, const Theme& theme, const QRectF& map) const {
    const QFontMetricsF metrics(painter.font());
    const QRectF bar(map.right() + Gap_px, map.top(), BarWidth_px, map.height());
    painter.setPen(Qt::NoPen);
    for (int step = 0; step < ColourSteps; ++step) {
        const double height = bar.height() / ColourSteps;
        painter.setBrush(colourOf(theme, (step + 0.5) / ColourSteps));
        painter.drawRect(QRectF(bar.left(), bar.bottom() - (step + 1) * height, bar.width(), height));
    }
    painter.setPen(theme.plotAxis);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(bar);
    painter.setPen(theme.text);
    const auto label = [&](double value, double y) {
        painter.drawText(QRectF(bar.right() + Gap_px, y, 12.0 * metrics.averageCharWidth(), metrics.height()),
                         Qt::AlignLeft, fixedText(value, m_slice.decimals));
    };
    label(m_slice.high, bar.top());
    label(m_slice.low, bar.bottom() - metrics.height());
    painter.drawText(QRectF(map.left() + map.width() / 2.0, 0.0,
                            map.width() / 2.0 + 12.0 * metrics.averageCharWidth(), metrics.height()),
                     Qt::AlignRight, QStringLiteral("%1 [%2]").arg(m_slice.quantity, m_slice.unit));
}

void CoverageView::drawMarks(QPainter& painter, const Theme& theme, const QRectF& map) const {
    if (m_slice.marked) {
        const QPointF at = placeOf(map, m_slice.marked->x(), m_slice.marked->y());
        painter.setPen(QPen(theme.text, 1.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(at, Cross_px, Cross_px);
        drawCross(painter, at);
    }
    if (m_column >= 0 && m_row >= 0) {
        painter.setPen(QPen(theme.accent, 1.5));
        drawCross(painter, placeOf(map, m_slice.x.at(m_column), m_slice.y.at(m_row)));
    }
}

void CoverageView::draw(QPainter& painter, const Theme& theme, const QSizeF& size) const {
    painter.fillRect(QRectF({}, size), theme.plotBackground);
    if (m_slice.values.empty()) {
        return;
    }
    const QRectF map = mapOf(size, QFontMetricsF(painter.font()));
    painter.setRenderHint(QPainter::Antialiasing, false);
    drawMap(painter, theme, map);
    drawColours(painter, theme, map);
    painter.setRenderHint(QPainter::Antialiasing, true);
    drawAxes(painter, theme, map);
    drawMarks(painter, theme, map);
}

void CoverageView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Theme theme = currentTheme();
    draw(painter, theme, size());
    if (hasFocus()) {
        painter.setPen(QPen(theme.accent, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void CoverageView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        describe();
    }
    update();
}

void CoverageView::mousePressEvent(QMouseEvent* event) {
    const QRectF map = mapOf(size(), QFontMetricsF(font()));
    if (m_slice.values.empty() || !map.contains(event->localPos())) {
        return QWidget::mousePressEvent(event);
    }
    const QPointF inside = event->localPos() - map.topLeft();
    moveCursor(static_cast<int>(inside.x() / map.width() * m_slice.x.count),
               m_slice.y.count - 1 - static_cast<int>(inside.y() / map.height() * m_slice.y.count));
}

void CoverageView::keyPressEvent(QKeyEvent* event) {
    const int column = m_column < 0 ? m_slice.x.count / 2 : m_column;
    const int row = m_row < 0 ? m_slice.y.count / 2 : m_row;
    switch (event->key()) {
    case Qt::Key_Left:
        return moveCursor(column - 1, row);
    case Qt::Key_Right:
        return moveCursor(column + 1, row);
    case Qt::Key_Up:
        return moveCursor(column, row + 1);
    case Qt::Key_Down:
        return moveCursor(column, row - 1);
    case Qt::Key_PageUp:
        return moveCursor(column, row + KeySteps);
    case Qt::Key_PageDown:
        return moveCursor(column, row - KeySteps);
    case Qt::Key_Home:
        return moveCursor(m_slice.x.count / 2, m_slice.y.count / 2);
    default:
        QWidget::keyPressEvent(event);
    }
}

void CoverageView::moveCursor(int column, int row) {
    if (m_slice.values.empty()) {
        return;
    }
    m_column = std::clamp(column, 0, m_slice.x.count - 1);
    m_row = std::clamp(row, 0, m_slice.y.count - 1);
    describe();
    update();
    Q_EMIT cursorMoved();
}

void CoverageView::describe() {
    setAccessibleName(tr("Map of the coverage over two angles"));
    const QString words = cursorText();
    if (words != accessibleDescription()) {
        setAccessibleDescription(words);
    }
}

} // namespace halbench::widgets
