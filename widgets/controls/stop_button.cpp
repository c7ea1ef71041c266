#include "widgets/controls/stop_button.h"

#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QKeyEvent>

namespace halbench::widgets {

StopButton::StopButton(Variant variant, QWidget* parent) : QPushButton(parent), m_variant(variant) {
    setAutoDefault(false);
    setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    setRole(*this, Role::Stop);
    connect(this, &QPushButton::pressed, this, &StopButton::stopRequested);
    refresh();
}

void StopButton::setLatched(bool isLatched, const QString& reason) {
    if (isLatched == m_isLatched && reason == m_reason) {
        return;
    }
    m_reason = reason;
    m_isLatched = isLatched;
    refresh();
}

QSize StopButton::sizeHint() const {
    QFont bold = font();
    bold.setBold(true);
    const QFontMetrics metrics(bold);
    const bool isFull = m_variant == Variant::Full;
    const int width = metrics.horizontalAdvance(tr("STOP")) + 6 * GridStep_px;
    return isFull ? QSize(qMax(88, width), qMax(40, metrics.height() + 2 * GridStep_px))
                  : QSize(qMax(64, width), qMax(28, metrics.height() + 12));
}

void StopButton::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        click();
        return;
    }
    QPushButton::keyPressEvent(event);
}

void StopButton::changeEvent(QEvent* event) {
    QPushButton::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refresh();
    }
}

void StopButton::refresh() {
    setText(tr("STOP"));
    if (!m_isLatched) {
        setToolTip(tr("Software stop: current off, latched until released (Esc)"));
    } else {
        const QString why = m_reason.isEmpty() ? tr("Stopped.") : tr("Stopped: %1.").arg(m_reason);
        setToolTip(tr("%1 STOP and Esc still work. To continue: Release, next to the state.").arg(why));
    }
    setAccessibleName(m_isLatched ? tr("Stopped; press again to repeat the stop") : tr("Stop"));
    setAccessibleDescription(toolTip());
    updateGeometry();
}

} // namespace halbench::widgets
