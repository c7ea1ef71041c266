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
    connect(this, &QToolButton::clicked, this, &ConnectButton::toggleRequested);
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

void ConnectButton::refresh() {
    const SessionState state = m_bench.session().state();
    const bool isFree = state == SessionState::Disconnected;
    setEnabled(state != SessionState::Leaving);
    setText(isFree ? tr("Connect") : tr("Disconnect"));
    setAccessibleName(text());
    setIcon(widgets::themedIcon(isFree ? "connect" : "disconnect"));
    setToolTip(isFree ? tr("Connect the device of the Devices panel; the menu lists what is there "
                           "(Ctrl+Shift+C, Alt+Down)")
               : state == SessionState::Reconnecting
                   ? tr("End the search for the device (Ctrl+Shift+C)")
                   : tr("End what runs, disarm and disconnect (Ctrl+Shift+C)"));
    setAccessibleDescription(toolTip());
    setShortcut(QKeySequence(QStringLiteral("Ctrl+Shift+C"))); // a new text forgets it
}

int ConnectButton::words_px() const {
    return std::max(fontMetrics().horizontalAdvance(tr("Connect")),
                    fontMetrics().horizontalAdvance(tr("Disconnect")));
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
