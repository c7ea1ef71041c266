// Set-points: a short way is a step of the loop, a long one an even ramp of the board, no leap.
#include "app/workbench/display_quantity.h"
#include "app/workbench/drive_control.h"
#include "app/workbench/drive_orders.h"
#include "control/base/units.h"
#include "widgets/language/phrasebook.h"

#include <QPointer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

namespace {

constexpr double ShapeRamp = 2.0;
/// Longer than the ramp takes, so that it ends where it shall.
constexpr double RampReserve_s = 0.1;

} // namespace

bool DriveControl::isLeap(double value) const {
    return m_mode == devices::BoardMode::Position && std::abs(value - m_setpoint) > largestStep();
}

double DriveControl::largestStep() const {
    return m_axis.turnsForever ? degreesToRadians(LargestStep_deg) : m_axis.windowMargin;
}

double DriveControl::goal() const {
    return m_next ? m_next->first : m_way ? m_way->to_rad : m_setpoint;
}

void DriveControl::setSetpoint(double value, double ramp_rad_s) {
    if (!canMove() || (m_way && value == goal())) {
        return;
    }
    if (m_way) { // it ends where it is, and the other way begins there
        m_next = std::pair(value, ramp_rad_s);
        endReference();
    } else if (!isLeap(value)) {
        // What ramps have moved is held by the board's generator, beside its set-point.
        const double sent = m_sent + value - m_setpoint;
        run([values = inMode(m_mode, {{setpointName(), sent}})](
                devices::Device& device) { return device.writeParameters(values); },
            [this, value, sent] {
                m_setpoint = value;
                m_sent = sent;
            });
    } else if (isRunning() || !rampsOnBoard()) {
        refuseLeap();
    } else {
        sendRamp(value, ramp_rad_s);
    }
}

void DriveControl::refuseLeap() {
    const DisplayQuantity shown = displayQuantity(m_axis.positionUnit, m_bench.displayUnits());
    const QString most = m_axis.turnsForever
                             ? QString::number(LargestStep_deg) + QChar(0xB0)
                             : QString::number(largestStep() * shown.factor) + QLatin1Char(' ') + shown.unit;
    Q_EMIT failed(
        isRunning() ? tr("Not sent: a reference is running, and a step above %1 is too large.").arg(most)
                    : tr("Not sent: a step above %1 is too large, and this firmware has no ramp.").arg(most),
        isRunning() ? tr("End the reference first. The device then moves there in a ramp.")
                    : tr("Use smaller steps or jog. Firmware 0.2.0 and later moves in a ramp."));
}

void DriveControl::sendRamp(double value, double ramp_rad_s) {
    m_way = Way{m_setpoint, value};
    m_reference.begin();
    m_startedShape = ShapeRamp;
    const double way = value - m_setpoint;
    std::vector<ParameterValue> ramp =
        withOthersHeld({{generator("shape"), ShapeRamp},
                        {generator("rate"), std::copysign(ramp_rad_s, way)},
                        {generator("amplitude"), std::abs(way)},
                        {generator("base"), 0.0},
                        {generator("duration"), std::abs(way) / ramp_rad_s + RampReserve_s},
                        {"reference.start", 1.0}});
    m_bench.session().request([values = inMode(m_mode, std::move(ramp))](
                                  devices::Device& device) { return device.writeParameters(values); },
                              [self = QPointer(this)](const Result<void>& written) {
                                  if (!self) {
                                      return;
                                  }
                                  if (self->m_way) {
                                      self->m_way->isAnswered = true;
                                  }
                                  if (!written) {
                                      self->m_way.reset();
                                      self->m_next.reset();
                                  }
                                  self->finish(written, {});
                              });
    Q_EMIT changed();
}

/// Where the ramp is by the newest sample of the reference.
double DriveControl::reached_rad() const {
    const auto reference = m_bench.history().latest(signal(m_axis.roles.reference));
    if (!m_way || !m_origin_rad || !reference || !std::isfinite(reference->value)) {
        return m_setpoint;
    }
    const auto [least, most] = std::minmax(m_way->from_rad, m_way->to_rad);
    return std::clamp(reference->value - *m_origin_rad - held_rad(), least, most);
}

void DriveControl::followWay() {
    if (!m_way) {
        return;
    }
    m_setpoint = reached_rad();
    if (isRunning() || !m_way->isAnswered) {
        return;
    }
    if (!m_way->isBroken) {
        m_setpoint = m_way->to_rad; // the samples know the origin less well
    }
    m_way.reset();
    Q_EMIT changed();
    if (const auto next = std::exchange(m_next, std::nullopt)) {
        setSetpoint(next->first, next->second);
    }
}

/// Another motion takes over where the ramp is.
void DriveControl::leaveWay() {
    m_setpoint = reached_rad();
    m_way.reset();
    m_next.reset();
}

void DriveControl::endReference() {
    if (m_way) {
        m_way->isBroken = true;
    }
    run(
        [](devices::Device& device) {
            return device.writeParameters(std::vector<ParameterValue>{{"reference.start", 0.0}});
        },
        {});
}

/// Arming, a mode, and each end of it begin at zero.
void DriveControl::clearMotion() {
    m_setpoint = 0.0;
    m_sent = 0.0;
    m_way.reset();
    m_next.reset();
    m_reference.clear();
    m_others.clear();
}

} // namespace halbench::app
