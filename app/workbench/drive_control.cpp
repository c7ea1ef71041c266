#include "app/workbench/drive_control.h"

#include "app/workbench/drive_ability.h"
#include "app/workbench/drive_orders.h"
#include "widgets/language/phrasebook.h"

#include <QPointer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

namespace {

constexpr int JogPeriod_ms = 20;

Result<void> write(devices::Device& device, const std::vector<ParameterValue>& values) {
    return device.writeParameters(values);
}

} // namespace

DriveControl::DriveControl(Workbench& bench, QObject* parent) : QObject(parent), m_bench(bench) {
    m_jog.setInterval(JogPeriod_ms);
    m_jog.setTimerType(Qt::PreciseTimer);
    connect(&m_jog, &QTimer::timeout, this, &DriveControl::jogStep);
    DeviceSession& session = m_bench.session();
    connect(&m_bench.stopLatch(), &StopLatch::changed, this, &DriveControl::changed);
    connect(&session, &DeviceSession::reportChanged, this, &DriveControl::onReport);
    connect(&session, &DeviceSession::stateChanged, this, &DriveControl::onDevice);
    connect(&session, &DeviceSession::procedureChanged, this, &DriveControl::onReport);
    connect(&m_bench, &Workbench::samplesArrived, this, &DriveControl::onSamples);
}

bool DriveControl::isAvailable() const {
    return m_bench.session().state() == SessionState::Connected && m_bench.session().procedure().isEmpty() &&
           canDrive();
}

bool DriveControl::canDrive() const {
    return canBeDriven(m_bench.session().catalogue());
}

bool DriveControl::hasSeveralAxes() const {
    return m_bench.session().catalogue().axes.size() > 1;
}

bool DriveControl::isArmed() const {
    return m_bench.session().state() == SessionState::Connected && m_bench.session().report().board.isArmed;
}

bool DriveControl::isStopped() const {
    return m_bench.stopLatch().isLatched();
}

bool DriveControl::canRelease() const {
    return isStopped() && !m_bench.stopLatch().isLocked();
}

bool DriveControl::canArm() const {
    return isAvailable() && !isStopped() && !m_bench.stopLatch().isJustReleased() && !isPending() &&
           !isArmed();
}

bool DriveControl::canDisarm() const {
    return isAvailable() && isArmed() && !isStopped() && !isPending();
}

bool DriveControl::isNothingToStop() const {
    const DeviceSession& session = m_bench.session();
    if (session.state() == SessionState::Disconnected) {
        return true;
    }
    return isAvailable() && !isArmed() && !isPending() && !m_bench.freshness().isStale();
}

bool DriveControl::needsConsent() const {
    return !m_bench.session().info().isSimulated && !m_hasConsent;
}

bool DriveControl::canMove() const {
    return isArmed() && isAvailable() && !isPending() && !m_awaitsOrigin &&
           m_mode != devices::BoardMode::Idle;
}

void DriveControl::onDevice() {
    useFirstAxis();
    m_hasConsent = false;
    settleConsent();
    m_origin_rad.reset();
    m_awaitsOrigin = false;
    clearMotion();
    m_isJogPending = false;
    m_pending = 0;
    onReport();
}

void DriveControl::onReport() {
    const bool isArmedNow = isArmed() && isAvailable();
    if (m_wasArmed != isArmedNow) {
        m_wasArmed = isArmedNow;
        clearMotion(); // the board's rule: arming and every end of it zero the set-point
    }
    if (!isAvailable() || isArmedNow || isStopped()) {
        settleConsent(); // there is nothing to arm
    }
    if (!isArmedNow) {
        m_jog.stop();
    }
    Q_EMIT changed();
}

void DriveControl::onSamples() {
    seekOtherOrigins();
    seekOrigin();
    const bool wasRunning = isRunning();
    const bool isPosition = m_mode == devices::BoardMode::Position;
    // A ramp to a set-point is none of the angle that is held beside it.
    m_reference.look(m_bench.history(), isArmed() && isAvailable(),
                     isPosition && !m_way ? m_origin_rad : std::nullopt, m_setpoint,
                     signal(m_axis.roles.reference));
    followWay();
    if (isRunning() != wasRunning) {
        Q_EMIT changed();
    }
}

void DriveControl::giveConsent() {
    m_hasConsent = true;
    settleConsent();
}

void DriveControl::dismissConsent() {
    settleConsent();
}

void DriveControl::settleConsent() {
    if (std::exchange(m_isAsking, false)) {
        Q_EMIT consentSettled();
    }
}

void DriveControl::run(Action action, std::function<void()> then) {
    m_bench.session().request(std::move(action),
                              [self = QPointer(this), then = std::move(then)](const Result<void>& done) {
                                  if (self) {
                                      self->finish(done, then);
                                  }
                              });
}

void DriveControl::change(Action action, std::function<void()> then) {
    const std::uint64_t number = ++m_changes;
    m_pending = number;
    m_jog.stop();
    m_bench.session().requestUnlessStopped(
        std::move(action), [self = QPointer(this), number, then = std::move(then)](const Result<void>& done) {
            if (self) {
                self->m_pending = self->m_pending == number ? 0 : self->m_pending;
                self->finish(done, then);
            }
        });
    Q_EMIT changed();
}

void DriveControl::finish(const Result<void>& done, const std::function<void()>& then) {
    if (!done) {
        m_jog.stop();
        Q_EMIT failed(widgets::inWords(done.error().message), widgets::inWords(done.error().hint));
    } else if (then) {
        then();
    }
    Q_EMIT changed();
}

void DriveControl::arm() {
    if (!canArm() || needsConsent()) {
        return; // also to arm what is armed would set the set-point to zero: a leap
    }
    change(
        [mode = m_mode](devices::Device& device) {
            const Result<void> chosen = write(device, {{"hb.mode", codeOf(mode)}});
            return chosen ? device.arm() : chosen;
        },
        [this] { takeOrigin(OriginBy::Arming); });
}

void DriveControl::disarm() {
    m_jog.stop();
    run([](devices::Device& device) { return device.disarm(); }, {});
}

void DriveControl::releaseStop() {
    m_bench.stopLatch().release([self = QPointer(this)](const Result<void>& done) {
        if (self) {
            self->finish(done, {});
        }
    });
}

void DriveControl::takeOrigin(OriginBy by) {
    clearMotion();
    m_isOriginOfMode = by == OriginBy::Mode;
    m_startedShape.reset();
    m_origin_rad.reset();
    const auto latest = m_bench.history().latest(signal(m_axis.roles.position));
    m_staleSample_s = latest ? std::optional(latest->time_s) : std::nullopt;
    const std::vector<std::string>& streamed = m_bench.liveSignals().streamed();
    m_awaitsOrigin =
        std::find(streamed.begin(), streamed.end(), signal(m_axis.roles.position)) != streamed.end();
}

/// Where a motion begins is known before it may begin: what is held and the window's ends count from there. A
/// sample from before does not tell: a hand, or what came while the link was lost, may have turned the rotor.
void DriveControl::seekOrigin() {
    const auto latest = m_bench.history().latest(signal(m_axis.roles.position));
    if (m_awaitsOrigin && latest && latest->time_s != m_staleSample_s && std::isfinite(latest->value)) {
        m_origin_rad = latest->value;
        m_awaitsOrigin = false;
        Q_EMIT changed();
    }
}

double DriveControl::excursion_rad() const {
    const auto latest = m_bench.history().latest(signal(m_axis.roles.position));
    return isArmed() && m_origin_rad && latest ? std::abs(latest->value - *m_origin_rad) : 0.0;
}

std::optional<std::pair<double, double>> DriveControl::setpointRange_rad(double share_ratio) const {
    if (m_mode != devices::BoardMode::Position ||
        m_bench.deviceValue("window.position_enabled").value_or(0.0) < 0.5) {
        return std::nullopt;
    }
    const double end_rad =
        share_ratio * m_bench.deviceValue(parameter(m_axis.roles.positionWindow)).value_or(0.0);
    return std::pair(-end_rad - held_rad(), end_rad - held_rad());
}

void DriveControl::setMode(devices::BoardMode mode) {
    if (hasSeveralAxes() && mode != devices::BoardMode::Idle && mode != devices::BoardMode::Position) {
        Q_EMIT changed(); // its other modes have no axis
        return;
    }
    if (!isAvailable()) {
        m_mode = mode;
        Q_EMIT changed();
    } else if (mode != m_mode || isPending()) {
        // Also while disarmed: an arm that is on its way may come first.
        change(
            [mode](devices::Device& device) {
                return write(device, {{"hb.mode", codeOf(mode)}});
            },
            [this, mode] {
                m_mode = mode;
                takeOrigin(isArmed() ? OriginBy::Mode : OriginBy::Arming);
            });
    }
}

void DriveControl::startReference(std::vector<ParameterValue> values) {
    if (!canMove() || isRunning()) {
        return; // it would begin where the one that runs is by then, and add its way
    }
    const std::string& firmware = m_bench.session().info().firmware;
    if (m_mode == devices::BoardMode::Position && m_reference.hasRun() && !continuesReference(firmware)) {
        Q_EMIT failed(
            tr("Not started: with this firmware (%1) the motion would begin at the arming position and the "
               "rotor would jump.")
                .arg(QString::fromStdString(firmware)),
            tr("Disarm and arm, then start. Firmware 0.2.0 and later starts at the present position."));
        return;
    }
    leaveWay();
    m_reference.begin();
    m_startedShape.reset();
    for (const ParameterValue& value : values) {
        m_startedShape = value.name == generator("shape") ? std::optional(value.value) : m_startedShape;
    }
    values.push_back({"reference.start", 1.0});
    run([motion = inMode(m_mode, withOthersHeld(std::move(values)))](
            devices::Device& device) { return write(device, motion); },
        [this] { m_bench.refreshValues(); });
    Q_EMIT changed();
}

std::size_t DriveControl::runningShape() const {
    const double code =
        m_startedShape ? *m_startedShape : m_bench.deviceValue(generator("shape")).value_or(0.0);
    return static_cast<std::size_t>(std::max(code, 0.0));
}

void DriveControl::stopReference() {
    m_next.reset();
    endReference();
}

} // namespace halbench::app
