#include "app/workbench/setpoint_motion.h"

#include "app/workbench/display_quantity.h"
#include "app/workbench/drive_orders.h"
#include "control/base/units.h"

#include <QPointer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

namespace {

/// Longer than the ramp takes, so that it ends where it shall.
constexpr double RampReserve_s = 0.1;

} // namespace

SetpointMotion::SetpointMotion(Workbench& bench, DriveCommands& commands, DriveAxes& axes,
                               ReferenceRun& reference, QObject* parent)
    : QObject(parent), m_bench(bench), m_commands(commands), m_axes(axes), m_reference(reference) {}

bool SetpointMotion::isLeap(double value) const {
    return m_axes.isPositionMode() && std::abs(value - m_axes.motion().setpoint) > largestStep();
}

double SetpointMotion::largestStep() const {
    const devices::AxisSpec& axis = m_axes.chosen();
    return axis.turnsForever ? degreesToRadians(LargestStep_deg) : axis.windowMargin;
}

double SetpointMotion::goal() const {
    return m_next ? m_next->first : m_way ? m_way->to_rad : m_axes.motion().setpoint;
}

void SetpointMotion::set(double value, double ramp_rad_s) {
    if (m_way && value == goal()) {
        return;
    }
    if (m_way) { // it ends where it is, and the other way begins there
        m_next = std::pair(value, ramp_rad_s);
        breakOff();
        m_reference.end();
    } else if (!isLeap(value)) {
        sendStep(value);
    } else if (m_reference.isRunning() || !m_reference.rampsOnBoard()) {
        refuseLeap();
    } else {
        sendRamp(value, ramp_rad_s);
    }
}

/// What ramps have moved is held by the board's generator, beside its set-point.
void SetpointMotion::sendStep(double value) {
    const double sent = m_axes.motion().sent + value - m_axes.motion().setpoint;
    m_commands.write(inMode(m_axes.mode(), {{m_axes.setpointName(), sent}}), [this, value, sent] {
        m_axes.motion().setpoint = value;
        m_axes.motion().sent = sent;
    });
}

void SetpointMotion::refuseLeap() {
    const devices::AxisSpec& axis = m_axes.chosen();
    const bool isRunning = m_reference.isRunning();
    const DisplayQuantity shown = displayQuantity(axis.positionUnit, m_bench.displayUnits());
    const QString most = axis.turnsForever
                             ? QString::number(LargestStep_deg) + QChar(0xB0)
                             : QString::number(largestStep() * shown.factor) + QLatin1Char(' ') + shown.unit;
    Q_EMIT m_commands.failed(
        isRunning ? tr("Not sent: a reference is running, and a step above %1 is too large.").arg(most)
                  : tr("Not sent: a step above %1 is too large, and this firmware has no ramp.").arg(most),
        isRunning ? tr("End the reference first. The device then moves there in a ramp.")
                  : tr("Use smaller steps or jog. Firmware 0.2.0 and later moves in a ramp."));
}

void SetpointMotion::sendRamp(double value, double ramp_rad_s) {
    const double way = value - m_axes.motion().setpoint;
    m_way = Way{m_axes.motion().setpoint, value};
    std::vector<ParameterValue> ramp = m_reference.beginRamp(std::copysign(ramp_rad_s, way), std::abs(way),
                                                             std::abs(way) / ramp_rad_s + RampReserve_s);
    m_bench.session().request([values = inMode(m_axes.mode(), std::move(ramp))](
                                  devices::Device& device) { return device.writeParameters(values); },
                              [self = QPointer(this)](const Result<void>& written) {
                                  if (!self) {
                                      return;
                                  }
                                  if (self->m_way) {
                                      self->m_way->isAnswered = true;
                                  }
                                  if (!written) {
                                      self->clear();
                                  }
                                  self->m_commands.finish(written, {});
                              });
    Q_EMIT m_commands.changed();
}

/// Where the ramp is by the newest sample of the reference.
double SetpointMotion::reached() const {
    const AxisMotion& motion = m_axes.motion();
    const auto reference = m_bench.history().latest(m_axes.signal(m_axes.chosen().roles.reference));
    if (!m_way || !motion.origin || !reference || !std::isfinite(reference->value)) {
        return motion.setpoint;
    }
    const auto [least, most] = std::minmax(m_way->from_rad, m_way->to_rad);
    return std::clamp(reference->value - *motion.origin - motion.reference.angle_rad(), least, most);
}

void SetpointMotion::follow(bool canMove) {
    if (!m_way) {
        return;
    }
    AxisMotion& motion = m_axes.motion();
    motion.setpoint = reached();
    if (m_reference.isRunning() || !m_way->isAnswered) {
        return;
    }
    if (!m_way->isBroken) {
        motion.setpoint = m_way->to_rad; // the samples know the origin less well
    }
    m_way.reset();
    Q_EMIT m_commands.changed();
    const auto next = std::exchange(m_next, std::nullopt);
    if (next && canMove) {
        set(next->first, next->second);
    }
}

void SetpointMotion::leave() {
    m_axes.motion().setpoint = reached();
    clear();
}

void SetpointMotion::breakOff() {
    if (m_way) {
        m_way->isBroken = true;
    }
}

void SetpointMotion::giveUp() {
    m_next.reset();
    breakOff();
}

void SetpointMotion::clear() {
    m_way.reset();
    m_next.reset();
}

} // namespace halbench::app
