#include "widgets/stop_button.h"

#include "widgets/theme_style.h"

#include <QEvent>
#include <QKeyEvent>
#include <QStyle>

namespace halbench::widgets {

StopButton::StopButton(Variant variant, QWidget* parent) : QPushButton(parent), m_variant(variant) {
    setAutoDefault(false);
    setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    setRole(*this, Role::Stop);
    connect(this, &QPushButton::pressed, this, &StopButton::onPressed);
    connect(this, &QPushButton::clicked, this, &StopButton::onClicked);
    refresh();
}

void StopButton::setLatched(bool isLatched, bool isLocked, const QString& reason) {
    m_reason = reason;
    m_isLatched = isLatched;
    m_isLocked = isLocked;
    refresh();
}

QSize StopButton::sizeHint() const {
    // The latched words are the longer ones: the button keeps its size when it is pressed.
    QFont bold = font();
    bold.setBold(true);
    const QFontMetrics metrics(bold);
    const bool isFull = m_variant == Variant::Full;
    const QSize words = metrics.size(0, isFull ? tr("STOPPED\nre-arm") : tr("STOPPED"));
    const int width = words.width() + 6 * GridStep_px;
    return isFull ? QSize(qMax(88, width), qMax(40, words.height() + 2 * GridStep_px))
                  : QSize(qMax(64, width), qMax(28, metrics.height() + 12));
}

void StopButton::onPressed() {
    m_wasReadyToRearm = m_isLatched && !m_isLocked;
    Q_EMIT stopRequested();
}

void StopButton::onClicked() {
    if (m_isLatched && m_wasReadyToRearm) {
        m_wasReadyToRearm = false;
        Q_EMIT rearmRequested();
    }
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
    if (!m_isLatched) {
        setText(tr("STOP"));
        setToolTip(tr("Software stop: current to zero at once, latched until re-armed (Esc)"));
    } else {
        setText(m_variant == Variant::Full && !m_isLocked ? tr("STOPPED\nre-arm") : tr("STOPPED"));
        const QString why = m_reason.isEmpty() ? tr("Stopped.") : tr("Stopped: %1.").arg(m_reason);
        setToolTip(m_isLocked
                       ? tr("%1 Re-arming is locked for a few seconds; Esc still stops.").arg(why)
                       : tr("%1 Click to re-arm; set-points start at zero. Esc still stops.").arg(why));
    }
    setAccessibleName(m_isLatched ? tr("Stopped, re-arm") : tr("Stop"));
    setAccessibleDescription(toolTip());
    setProperty("latched", m_isLatched);
    style()->unpolish(this);
    style()->polish(this);
    updateGeometry();
    update();
}

} // namespace halbench::widgets
