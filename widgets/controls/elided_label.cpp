#include "widgets/controls/elided_label.h"

#include <QEvent>

#include <algorithm>

namespace halbench::widgets {

ElidedLabel::ElidedLabel(int leastCharacters, QWidget* parent)
    : QLabel(parent), m_leastCharacters(leastCharacters) {
    setTextFormat(Qt::PlainText);
}

void ElidedLabel::setWords(const QString& words) {
    if (words != m_words) {
        m_words = words;
        setToolTip(words);
        updateGeometry();
        fit();
    }
}

/// Frame and padding are what the label asks for beyond the text that it shows now.
QSize ElidedLabel::sizeFor(const QString& text) const {
    const QSize shown = QLabel::sizeHint();
    const int around_px = shown.width() - fontMetrics().size(0, QLabel::text()).width();
    return {fontMetrics().size(0, text).width() + around_px, shown.height()};
}

QSize ElidedLabel::sizeHint() const {
    return sizeFor(m_words);
}

void ElidedLabel::setLeastCharacters(int characters) {
    if (characters != m_leastCharacters) {
        m_leastCharacters = characters;
        updateGeometry();
    }
}

int ElidedLabel::leastWidth_px(int characters) const {
    return sizeFor(QString(characters, QLatin1Char('n'))).width();
}

QSize ElidedLabel::minimumSizeHint() const {
    const QSize all = sizeHint();
    return {std::min(leastWidth_px(m_leastCharacters), all.width()), all.height()};
}

void ElidedLabel::fit() {
    const int around_px = QLabel::sizeHint().width() - fontMetrics().size(0, QLabel::text()).width();
    const int room_px = std::max(width() - around_px, 0);
    // Qt leaves a letter out for part of a pixel; what the size was asked for fits.
    const bool isWhole = !isVisible() || fontMetrics().size(0, m_words).width() <= room_px; // or no width yet
    const QString shown = isWhole ? m_words : fontMetrics().elidedText(m_words, Qt::ElideRight, room_px);
    if (shown != QLabel::text()) {
        QLabel::setText(shown);
    }
}

void ElidedLabel::showEvent(QShowEvent* event) {
    QLabel::showEvent(event);
    fit();
}

void ElidedLabel::resizeEvent(QResizeEvent* event) {
    QLabel::resizeEvent(event);
    fit();
}

void ElidedLabel::changeEvent(QEvent* event) {
    QLabel::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        updateGeometry();
        fit();
    }
}

} // namespace halbench::widgets
