#pragma once

#include <QAbstractButton>
#include <QStringList>

namespace halbench::app {

/// Words of the buttons that are in sight and narrower or lower than these words need.
inline QStringList clippedButtons(const QWidget& window) {
    QStringList found;
    for (const QAbstractButton* button : window.findChildren<QAbstractButton*>()) {
        const QSize need = button->minimumSizeHint();
        const bool isInSight = button->isVisible() && !button->visibleRegion().isEmpty();
        if (isInSight && !button->text().isEmpty() &&
            (button->width() < need.width() || button->height() < need.height())) {
            found << button->text();
        }
    }
    return found;
}

} // namespace halbench::app
