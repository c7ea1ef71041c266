#include "app/workspaces/drive/mode_box.h"

#include <QEvent>
#include <QListView>
#include <QSignalBlocker>
#include <QWheelEvent>

namespace halbench::app {

ModeBox::ModeBox(DriveControl& control, const QString& key, QWidget* parent)
    : QComboBox(parent), m_control(control), m_key(key) {
    setSizeAdjustPolicy(QComboBox::AdjustToContents);
    sayWords();
    connect(this, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
            [this](int index) { m_control.setMode(static_cast<devices::BoardMode>(index)); });
    connect(&m_control, &DriveControl::changed, this, &ModeBox::refresh);
    refresh();
}

void ModeBox::sayWords() {
    const QSignalBlocker quiet(this);
    const int shown = currentIndex();
    clear();
    addItems({tr("Idle"), tr("Current"), tr("Position"), tr("D-axis")});
    setCurrentIndex(shown);
    setAccessibleName(tr("Mode"));
    setToolTip(tr("Idle: no current. Current: manual torque. Position: holds and follows.\nD-axis: current "
                  "that holds the rotor without torque (%1)")
                   .arg(m_key));
}

/// While an answer is awaited the box keeps what was chosen, and stays enabled: who goes through the modes
/// with the arrow keys keeps the focus.
void ModeBox::refresh() {
    setEnabled(m_control.isAvailable());
    // Current modes are not of one axis among several.
    auto* rows = qobject_cast<QListView*>(view());
    for (const devices::BoardMode mode : {devices::BoardMode::Current, devices::BoardMode::DAxis}) {
        rows->setRowHidden(static_cast<int>(mode), m_control.hasSeveralAxes());
    }
    if (!m_control.isPending()) {
        const QSignalBlocker quiet(this);
        setCurrentIndex(static_cast<int>(m_control.mode()));
    }
}

void ModeBox::wheelEvent(QWheelEvent* event) {
    event->ignore();
}

void ModeBox::changeEvent(QEvent* event) {
    QComboBox::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        sayWords();
    }
}

} // namespace halbench::app
