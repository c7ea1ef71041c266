// What the Drive panel says of the motion: where it counts from, where it is, how far the next one goes.
#include "app/workbench/drive_ability.h"
#include "app/workspaces/drive/drive_panel.h"
#include "app/workspaces/drive/path_run.h"
#include "app/workspaces/drive/reference_form.h"
#include "app/workspaces/parts/panel_parts.h"
#include "widgets/controls/quantity_edit.h"

#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

using devices::BoardMode;

/// Beside the field, not only in its tooltip: a set-point means nothing without it.
void DrivePanel::showOrigin() {
    const auto origin_rad = m_control.origin_rad();
    const QString at = origin_rad ? tr(" (%1)").arg(valueText(*origin_rad)) : QString();
    m_from->setText(m_control.mode() != BoardMode::Position ? tr("Current")
                    : !m_control.isArmed()                  ? tr("Position relative to the arming position")
                    : m_control.isOriginOfMode()            ? tr("Position relative to the mode's start") + at
                                                 : tr("Position relative to the arming position") + at);
}

void DrivePanel::showSetpoint() {
    const double held_rad = m_control.held_rad();
    QString words = m_control.canMove()        ? tr("Set-point %1").arg(valueText(m_control.setpoint()))
                    : m_control.awaitsOrigin() ? tr("Waiting for the first angle sample.")
                                               : tr("Arm to move. Set-points start at 0.");
    if (m_control.canMove() && m_control.mode() == BoardMode::Position && held_rad != 0.0) {
        words = tr("Set-point %1 + jog or reference %2")
                    .arg(valueText(m_control.setpoint()), valueText(held_rad));
    }
    m_setpointNow->setText(words);
    const double back = m_control.goal();
    const QString zero = back == 0.0 ? tr("Send set-point zero")
                         : m_control.isLeap(0.0)
                             ? tr("Send set-point zero: move back by %1 at jog speed").arg(valueText(back))
                             : tr("Send set-point zero: step back by %1").arg(valueText(back));
    if (m_zero->toolTip() != zero) {
        m_zero->setToolTip(zero);
        m_zero->setAccessibleDescription(zero);
    }
    if (std::exchange(m_shownSetpoint, back) != back && !m_setpoint->hasFocus()) {
        m_setpoint->setValue(back * factor()); // a Go that follows moves nothing
    }
}

void DrivePanel::takePeak() {
    m_peak = m_reference->peak();
    describeMotion();
}

double DrivePanel::commanded_rad() const {
    const bool isHeld = m_control.isArmed() && m_control.mode() == BoardMode::Position;
    return isHeld ? m_control.setpoint() + m_control.held_rad() : 0.0;
}

/// What starting would do, before it is done: each start adds its way to where the one before has ended.
void DrivePanel::describeMotion() {
    if (m_reference->isPath()) {
        const PathRun::Outlook outlook = m_path->outlook();
        sayMotion(outlook.text, outlook.isWrong);
        return;
    }
    const bool isAngle = m_control.mode() == BoardMode::Position;
    const double before = std::max(m_control.excursion_rad(), std::abs(commanded_rad()));
    QString words = isAngle ? tr("Travel: up to %1 from here.").arg(valueText(m_peak))
                            : tr("Range: up to %1.").arg(valueText(m_peak));
    if (isAngle && commanded_rad() != 0.0) {
        words = tr("Travel: up to %1 from here, up to %2 from the arming position.")
                    .arg(valueText(m_peak), valueText(std::abs(commanded_rad()) + m_peak));
    }
    const double window_rad = m_bench
                                  .deviceValue(parameterOfRole(m_bench.session().catalogue(),
                                                               m_control.axis().roles.positionWindow))
                                  .value_or(0.0);
    const bool isWatched = m_bench.deviceValue("window.position_enabled").value_or(0.0) > 0.5;
    const std::optional<double> limit_A = m_bench.deviceValue("limit.current");
    const bool isTooFar = isAngle && isWatched && before + m_peak > window_rad;
    const bool isTooMuch = !isAngle && limit_A && m_peak > *limit_A;
    if (isTooFar || isTooMuch) {
        words += QLatin1Char(' ') + tr("Above the limit: the device may stop.");
    }
    sayMotion(words, isTooFar || isTooMuch);
}

void DrivePanel::sayMotion(const QString& words, bool isWarning) {
    const bool isBusy = m_control.canMove() && m_control.isRunning();
    const QString shown = isBusy ? tr("A motion is running. End it to start another.") : words;
    m_motion->setText(shown);
    m_start->setToolTip(isBusy ? shown : startHelp());
    m_start->setAccessibleDescription(m_start->toolTip());
    showRole(*m_motion, !isBusy && isWarning ? widgets::Role::Warn : widgets::Role::Muted);
}

} // namespace halbench::app
