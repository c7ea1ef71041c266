// Set-points: a short way is a step of the loop, a long one an even ramp of the board, no leap.
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

std::vector<ParameterValue> rampBy(double way_rad, double rate_rad_s) {
    return {{"reference.shape", ShapeRamp},
            {"reference.rate", std::copysign(rate_rad_s, way_rad)},
            {"reference.amplitude", std::abs(way_rad)},
            {"reference.base", 0.0},
            {"reference.duration", std::abs(way_rad) / rate_rad_s + RampReserve_s},
            {"reference.start", 1.0}};
}

} // namespace

bool DriveControl::isLeap(double value) const {
    return m_mode == devices::BoardMode::Position &&
           std::abs(value - m_setpoint) > degreesToRadians(LargestStep_deg);
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
        run([values = inMode(m_mode, {{"hb.setpoint", sent}})](
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
    const QString most = QString::number(LargestStep_deg);
    Q_EMIT failed(
        isRunning() ? tr("Not sent: a reference runs, and more than %1° at once is a leap.").arg(most)
                    : tr("Not sent: more than %1° at once is a leap, and the firmware of this board "
                         "makes no ramp of it.")
                          .arg(most),
        isRunning() ? tr("End the reference first; then the board goes there as an even ramp.")
                    : tr("Go there in smaller steps, or jog. Firmware from 0.2.0 on makes a ramp."));
}

void DriveControl::sendRamp(double value, double ramp_rad_s) {
    m_way = Way{m_setpoint, value};
    m_reference.begin();
    m_startedShape = ShapeRamp;
    m_bench.session().request([values = inMode(m_mode, rampBy(value - m_setpoint, ramp_rad_s))](
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
    const auto reference = m_bench.history().latest("reference");
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
}

} // namespace halbench::app
