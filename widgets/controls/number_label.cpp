#include "widgets/controls/number_label.h"

#include "widgets/language/display_units.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QPainter>

#include <cmath>

namespace halbench::widgets {

NumberLabel::NumberLabel(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
}

void NumberLabel::setFormat(const NumberFormat& format) {
    m_format = format;
    updateGeometry();
    describe();
}

void NumberLabel::setValue(double value) {
    const QString before = valueText();
    m_value = std::isfinite(value) ? std::optional(value) : std::nullopt;
    if (valueText() != before) {
        describe();
    }
}

void NumberLabel::clear() {
    m_value.reset();
    describe();
}

void NumberLabel::setStale(bool isStale) {
    if (m_isStale != isStale) {
        m_isStale = isStale;
        setToolTip(isStale ? tr("No new value from the device; last value shown") : QString());
        describe();
    }
}

QString NumberLabel::valueText() const {
    return fixedText(m_value, m_format.decimals);
}

QString NumberLabel::text() const {
    return m_format.unit.isEmpty() ? valueText() : valueText() + QChar(QChar::Nbsp) + m_format.unit;
}

void NumberLabel::describe() {
    setAccessibleDescription(m_isStale ? tr("%1, old").arg(text()) : text());
    update();
}

int NumberLabel::numberWidth() const {
    const QFontMetrics metrics(tabularFont(font()));
    return qMax(metrics.horizontalAdvance(fixedText(m_format.min, m_format.decimals)),
                metrics.horizontalAdvance(fixedText(m_format.max, m_format.decimals)));
}

int NumberLabel::unitWidth() const {
    return m_format.unit.isEmpty() ? 0 : fontMetrics().horizontalAdvance(m_format.unit) + GridStep_px;
}

QSize NumberLabel::sizeHint() const {
    return {numberWidth() + unitWidth(), fontMetrics().height()};
}

void NumberLabel::paintEvent(QPaintEvent*) {
    const Theme theme = currentTheme();
    QPainter painter(this);
    const bool isMuted = m_isStale || !m_value || !isEnabled();
    const QRect box = rect().adjusted(0, 0, -unitWidth(), 0);
    painter.setFont(tabularFont(font()));
    painter.setPen(isMuted ? theme.muted : theme.text);
    painter.drawText(box, Qt::AlignRight | Qt::AlignVCenter, valueText());
    if (m_isStale && m_value) {
        const int width = painter.fontMetrics().horizontalAdvance(valueText());
        const int y = box.center().y() + painter.fontMetrics().ascent() / 2 + 2;
        painter.setPen(QPen(theme.muted, 1.0, Qt::DotLine));
        painter.drawLine(box.right() - width, y, box.right(), y);
    }
    painter.setFont(font());
    painter.setPen(theme.muted);
    painter.drawText(rect(), Qt::AlignRight | Qt::AlignVCenter, m_format.unit);
}

void NumberLabel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::LanguageChange) {
        updateGeometry();
    }
    update();
}

} // namespace halbench::widgets
