#include "app/workbench/drive_control.h"

#include "app/workbench/drive_orders.h"

#include <utility>

namespace halbench::app {

DriveControl::DriveControl(Workbench& bench, QObject* parent)
    : QObject(parent), m_bench(bench), m_axes(bench), m_commands(bench), m_arming(bench, m_commands),
      m_reference(bench, m_commands, m_axes), m_setpoints(bench, m_commands, m_axes, m_reference),
      m_jog(bench, m_commands, m_axes, m_reference) {
    connect(&m_commands, &DriveCommands::changed, this, &DriveControl::changed);
    connect(&m_commands, &DriveCommands::failed, this, &DriveControl::failed);
    connect(&m_arming, &DriveArming::consentSettled, this, &DriveControl::consentSettled);
    DeviceSession& session = m_bench.session();
    connect(&m_bench.stopLatch(), &StopLatch::changed, this, &DriveControl::changed);
    connect(&session, &DeviceSession::reportChanged, this, &DriveControl::onReport);
    connect(&session, &DeviceSession::stateChanged, this, &DriveControl::onDevice);
    connect(&session, &DeviceSession::procedureChanged, this, &DriveControl::onReport);
    connect(&m_bench, &Workbench::samplesArrived, this, &DriveControl::onSamples);
}

bool DriveControl::canMove() const {
    return isArmed() && isAvailable() && !isPending() && !awaitsOrigin() &&
           mode() != devices::BoardMode::Idle;
}

void DriveControl::chooseAxis(const std::string& id) {
    if (canChooseAxis()) {
        m_axes.choose(id);
    }
    Q_EMIT changed();
}

void DriveControl::onDevice() {
    m_axes.useFirst();
    m_arming.forgetConsent();
    m_axes.forgetOrigin();
    clearMotion();
    m_jog.forgetPending();
    m_commands.forgetPending();
    onReport();
}

void DriveControl::onReport() {
    if (m_arming.look()) {
        clearMotion(); // the board's rule: arming and every end of it zero the set-point
    }
    if (!isArmed() || !isAvailable()) {
        m_jog.stop();
    }
    Q_EMIT changed();
}

void DriveControl::onSamples() {
    if (m_axes.seekOrigins()) {
        Q_EMIT changed();
    }
    const bool wasRunning = isRunning();
    m_reference.look(isArmed() && isAvailable(), m_setpoints.isOnWay());
    m_setpoints.follow(canMove());
    if (isRunning() != wasRunning) {
        Q_EMIT changed();
    }
}

void DriveControl::arm() {
    m_arming.arm(mode(), [this] { takeOrigin(OriginBy::Arming); });
}

void DriveControl::disarm() {
    m_jog.stop();
    m_arming.disarm();
}

void DriveControl::takeOrigin(OriginBy by) {
    clearMotion();
    m_isOriginOfMode = by == OriginBy::Mode;
    m_reference.forgetShape();
    m_axes.takeOrigin();
}

/// Arming, a mode, and each end of it begin at zero.
void DriveControl::clearMotion() {
    m_axes.clearMotion();
    m_setpoints.clear();
}

void DriveControl::setMode(devices::BoardMode mode) {
    if (hasSeveralAxes() && mode != devices::BoardMode::Idle && mode != devices::BoardMode::Position) {
        Q_EMIT changed(); // its other modes have no axis
        return;
    }
    if (!isAvailable()) {
        m_axes.setMode(mode);
        Q_EMIT changed();
    } else if (mode != m_axes.mode() || isPending()) {
        // Also while disarmed: an arm that is on its way may come first.
        m_commands.change(
            [mode](devices::Device& device) {
                const ParameterValue chosen{"hb.mode", codeOf(mode)};
                return device.writeParameters({&chosen, 1});
            },
            [this, mode] {
                m_axes.setMode(mode);
                takeOrigin(isArmed() ? OriginBy::Mode : OriginBy::Arming);
            });
    }
}

void DriveControl::setSetpoint(double value, double ramp_rad_s) {
    if (canMove()) {
        m_setpoints.set(value, ramp_rad_s);
    }
}

void DriveControl::startJog(double rate) {
    if (!canMove() || isJogging()) {
        return;
    }
    m_setpoints.leave();
    m_jog.start(rate);
    Q_EMIT changed();
}

void DriveControl::stopJog() {
    if (!isJogging()) {
        return;
    }
    m_jog.stop();
    if (m_jog.usesReference()) {
        stopReference();
    }
    Q_EMIT changed();
}

void DriveControl::startReference(std::vector<ParameterValue> values) {
    // It would begin where the one that runs is by then, and add its way.
    if (!canMove() || isRunning() || !m_reference.admitsStart()) {
        return;
    }
    m_setpoints.leave();
    m_reference.start(std::move(values));
    Q_EMIT changed();
}

void DriveControl::startPath(const MoveReference& reference, const std::vector<std::string>& axes) {
    if (!canMove() || isRunning() || !m_reference.admitsStart()) {
        return;
    }
    m_setpoints.leave();
    m_reference.startPath(reference, axes);
    Q_EMIT changed();
}

void DriveControl::stopReference() {
    m_setpoints.giveUp();
    m_reference.end();
}

} // namespace halbench::app
