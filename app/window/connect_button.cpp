#include "app/window/connect_button.h"

#include "widgets/theme/icons.h"

#include <QKeyEvent>
#include <QMenu>

#include <algorithm>

namespace halbench::app {

ConnectButton::ConnectButton(Workbench& bench, QWidget* parent) : QToolButton(parent), m_bench(bench) {
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setPopupMode(QToolButton::MenuButtonPopup);
    setMenu(new QMenu(this));
    setFocusPolicy(Qt::StrongFocus);
    connect(menu(), &QMenu::aboutToShow, this, &ConnectButton::fillMenu);
    connect(this, &QToolButton::clicked, this, &ConnectButton::act);
    connect(&m_bench.session(), &DeviceSession::stateChanged, this, &ConnectButton::refresh);
    refresh();
}

/// A device in use is left by Disconnect only.
void ConnectButton::fillMenu() {
    menu()->clear();
    const bool isFree = m_bench.session().state() == SessionState::Disconnected;
    for (const auto& [title, uri] : m_devices()) {
        QAction* action = menu()->addAction(title, this, [this, uri = uri] { deviceChosen(uri); });
        action->setEnabled(isFree);
    }
}

bool ConnectButton::isRecordingOpen() const {
    const DeviceSession& session = m_bench.session();
    return session.state() == SessionState::Connected && session.info().transport == "replay";
}

/// Also while the recording is being read, and when its end was played.
bool ConnectButton::isDeviceHeld() const {
    return !m_bench.session().heldDevice().isEmpty();
}

void ConnectButton::act() {
    if (isDeviceHeld()) {
        m_bench.session().closeRecording();
    } else {
        Q_EMIT toggleRequested();
    }
}

QString ConnectButton::wordsNow() const {
    if (isDeviceHeld()) {
        return tr("Back");
    }
    if (isRecordingOpen()) {
        return tr("Close");
    }
    return m_bench.session().state() == SessionState::Disconnected ? tr("Connect") : tr("Disconnect");
}

QString ConnectButton::tipNow() const {
    if (isDeviceHeld()) {
        return tr("Close the recording, back to %1 (Ctrl+Shift+C)").arg(m_bench.session().heldDevice());
    }
    if (isRecordingOpen()) {
        return tr("Close the recording (Ctrl+Shift+C)");
    }
    switch (m_bench.session().state()) {
    case SessionState::Disconnected:
        return tr("Connect the selected device (Ctrl+Shift+C; list: Alt+Down)");
    case SessionState::Reconnecting:
        return tr("Stop searching for the device (Ctrl+Shift+C)");
    default:
        return tr("Stop, disarm and disconnect (Ctrl+Shift+C)");
    }
}

void ConnectButton::refresh() {
    const SessionState state = m_bench.session().state();
    setEnabled(state != SessionState::Leaving);
    setText(wordsNow());
    setAccessibleName(text());
    setIcon(widgets::themedIcon(state == SessionState::Disconnected ? "connect" : "disconnect"));
    setToolTip(tipNow());
    setAccessibleDescription(toolTip());
    setShortcut(QKeySequence(QStringLiteral("Ctrl+Shift+C"))); // a new text forgets it
}

int ConnectButton::words_px() const {
    int widest_px = 0;
    for (const QString& words : {tr("Connect"), tr("Disconnect"), tr("Back"), tr("Close")}) {
        widest_px = std::max(widest_px, fontMetrics().horizontalAdvance(words));
    }
    return widest_px;
}

int ConnectButton::saved_px() const {
    constexpr int IconGap_px = 4; // of a tool button, which also puts a space on either side of its words
    return words_px() + IconGap_px + fontMetrics().horizontalAdvance(QStringLiteral("  "));
}

QSize ConnectButton::sizeHint() const {
    const QSize now = QToolButton::sizeHint();
    const bool isIcon = toolButtonStyle() == Qt::ToolButtonIconOnly;
    return {now.width() + (isIcon ? 0 : words_px() - fontMetrics().horizontalAdvance(text())), now.height()};
}

void ConnectButton::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Down && event->modifiers() == Qt::AltModifier) {
        showMenu();
    } else {
        QToolButton::keyPressEvent(event);
    }
}

void ConnectButton::changeEvent(QEvent* event) {
    QToolButton::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refresh();
    }
}

} // namespace halbench::app
