#include "app/workbench/drive_arming.h"

#include "app/workbench/drive_ability.h"
#include "app/workbench/drive_orders.h"
#include "devices/profile.h"

#include <QPointer>

#include <utility>

namespace halbench::app {

namespace {

/// Certain that there is nothing to arm: in a recording, and on a board whose profile knows no axis and that
/// has no order to arm. What a board without a profile moves is not known.
bool hasNothingToArm(const devices::DeviceInfo& info, const devices::Catalogue& catalogue) {
    if (info.transport == "replay") {
        return true;
    }
    if (canBeArmed(catalogue) || !catalogue.axes.empty()) {
        return false;
    }
    const Result<std::optional<devices::Profile>> profile = devices::findProfile(info.model);
    return profile && *profile;
}

} // namespace

bool DriveArming::isAvailable() const {
    return m_bench.session().state() == SessionState::Connected && m_bench.session().procedure().isEmpty() &&
           canDrive();
}

bool DriveArming::canDrive() const {
    return canBeDriven(m_bench.session().catalogue());
}

bool DriveArming::isArmed() const {
    return m_bench.session().state() == SessionState::Connected && m_bench.session().report().board.isArmed;
}

bool DriveArming::isStopped() const {
    return m_bench.stopLatch().isLatched();
}

bool DriveArming::canRelease() const {
    return isStopped() && !m_bench.stopLatch().isLocked();
}

bool DriveArming::canArm() const {
    return isAvailable() && !isStopped() && !m_bench.stopLatch().isJustReleased() &&
           !m_commands.isPending() && !isArmed();
}

bool DriveArming::canDisarm() const {
    return isAvailable() && isArmed() && !isStopped() && !m_commands.isPending();
}

bool DriveArming::isNothingToStop() const {
    const DeviceSession& session = m_bench.session();
    if (!session.heldDevice().isEmpty()) {
        return false; // nothing new is known of it while a recording is open in its place
    }
    if (session.state() == SessionState::Disconnected) {
        return true;
    }
    const bool isOpen = session.state() == SessionState::Connected || session.isPlayedToTheEnd();
    if (!isOpen || !session.procedure().isEmpty() || m_commands.isPending()) {
        return false;
    }
    return hasNothingToArm(session.info(), session.catalogue()) || isKnownIdle();
}

/// By what the board says of itself, and not by what is known of it from before. The time of a simulation
/// that runs as fast as possible stands still until somebody waits for it: nothing new can have happened.
bool DriveArming::isKnownIdle() const {
    const DeviceSession& session = m_bench.session();
    const bool isTimeStill = session.info().isSimulated && session.pace().speed_ratio <= 0.0;
    return canBeArmed(session.catalogue()) && session.report().board.isConnected && !isArmed() &&
           (isTimeStill || m_bench.freshness().isFresh());
}

bool DriveArming::needsConsent() const {
    return !m_bench.session().info().isSimulated && !m_hasConsent;
}

void DriveArming::giveConsent() {
    m_hasConsent = true;
    settleConsent();
}

void DriveArming::settleConsent() {
    if (std::exchange(m_isAsking, false)) {
        Q_EMIT consentSettled();
    }
}

void DriveArming::forgetConsent() {
    m_hasConsent = false;
    settleConsent();
}

void DriveArming::arm(devices::BoardMode mode, std::function<void()> then) {
    if (!canArm() || needsConsent()) {
        return; // also to arm what is armed would set the set-point to zero: a leap
    }
    m_commands.change(
        [mode](devices::Device& device) {
            const ParameterValue chosenMode{"hb.mode", codeOf(mode)};
            const Result<void> chosen = device.writeParameters({&chosenMode, 1});
            return chosen ? device.arm() : chosen;
        },
        std::move(then));
}

void DriveArming::disarm() {
    m_commands.run([](devices::Device& device) { return device.disarm(); }, {});
}

void DriveArming::releaseStop() {
    m_bench.stopLatch().release([self = QPointer(this)](const Result<void>& done) {
        if (self) {
            self->m_commands.finish(done, {});
        }
    });
}

bool DriveArming::look() {
    const bool isArmedNow = isArmed() && isAvailable();
    if (!isAvailable() || isArmedNow || isStopped()) {
        settleConsent(); // there is nothing to arm
    }
    return std::exchange(m_wasArmed, isArmedNow) != isArmedNow;
}

} // namespace halbench::app
