#include "app/window/docks/dock_layout.h"
#include "app/window/main_window.h"
#include "app/workbench/drive_control.h"
#include "app/workspaces/device/device_panel.h"

#include <QApplication>
#include <QCloseEvent>

#include <utility>

namespace halbench::app {

namespace {

/// Longest time a window that was closed waits for its device.
constexpr int LeavePatience_ms = 10000;

} // namespace

void MainWindow::closeAnyway() {
    m_isLossAccepted = true;
    close();
}

void MainWindow::closeBySignal() {
    if (!m_bench.drive().isNothingToStop()) {
        m_bench.session().stopActuator();
    }
    for (QWidget* other : QApplication::topLevelWidgets()) {
        if (other != this && other->isModal()) {
            other->close();
        }
    }
    closeAnyway();
}

/// A procedure that restores, a board that is disarmed: STOP must be there until it is done.
void MainWindow::leaveThenClose() {
    if (std::exchange(m_isClosing, true)) {
        return;
    }
    onMessage(widgets::Severity::Information,
              tr("The program closes after the running task is stopped and the actuator disarmed."),
              tr("STOP and Esc remain active until then."));
    DeviceSession& session = m_bench.session();
    const auto closeNow = [this] {
        if (std::exchange(m_isClosing, false)) {
            m_hasLeft = true;
            close();
            m_hasLeft = false;
        }
    };
    connect(
        &session, &DeviceSession::stateChanged, this,
        [&session, closeNow] {
            if (session.state() == SessionState::Disconnected) {
                closeNow();
            }
        },
        Qt::QueuedConnection);
    QTimer::singleShot(LeavePatience_ms, this, [this, &session, closeNow] {
        if (m_isClosing) { // whatever hangs goes on without a window, but nothing moves any more
            session.stopActuator();
        }
        closeNow();
    });
    session.disconnectDevice();
}

/// The device is left before anything is written: a disk that is slow holds up this thread, and with it Esc.
void MainWindow::closeEvent(QCloseEvent* event) {
    if (!m_hasLeft && m_bench.session().state() != SessionState::Disconnected) {
        event->ignore();
        leaveThenClose();
        return;
    }
    furnish(); // what it keeps is in the panels
    collectProject();
    if (const Result<void> kept = m_project->autosaveNow(); !kept && !m_isLossAccepted) {
        event->ignore();
        sayNotKept(kept.error());
        m_refusal->showMessage(
            {widgets::Severity::Warning, tr("The window stays open because of unsaved work."),
             tr("Save the project to another place, or close without saving."), tr("Close anyway")});
        return;
    }
    m_preferences.geometry = saveGeometry();
    m_preferences.lastDevice = m_devices->remembered();
    m_preferences.arrangements = m_docks->arrangements();
    savePreferences(m_preferences);
    QMainWindow::closeEvent(event);
}

} // namespace halbench::app
