// Jogging: a motion that ends when the key is let go, and on the board when nobody renews it.
#include "app/workbench/drive_control.h"
#include "app/workbench/drive_orders.h"

#include <QPointer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

namespace {

/// A window that was busy does not catch up in one leap.
constexpr double LongestJogStep_s = 0.05;
/// The board ends a jog current that is not renewed.
constexpr double JogHold_s = 0.3;
constexpr double ShapeStep = 1.0;
constexpr double ShapeRamp = 2.0;
/// Of the board's excursion window: jogging ends before the board would stop it.
constexpr double WindowShare_ratio = 0.9;

} // namespace

void DriveControl::startJog(double rate) {
    if (!canMove() || m_jog.isActive()) {
        return;
    }
    leaveWay();
    m_jogRate = rate;
    m_jogRoom_rad = jogRoom_rad();
    m_sinceJogStep.invalidate();
    m_jogged.start();
    m_jog.start();
    jogStep();
    Q_EMIT changed();
}

void DriveControl::jogStep() {
    if (m_isJogPending) {
        return;
    }
    const bool isPosition = m_mode == devices::BoardMode::Position;
    if (isPosition && !rampsOnBoard()) {
        moveJogSetpoint();
        return;
    }
    if (m_sinceJogStep.isValid() && m_sinceJogStep.elapsed() < static_cast<qint64>(JogHold_s * 500.0)) {
        return; // the hold is still fresh
    }
    m_sinceJogStep.start();
    if (!isPosition) {
        sendJog({{generator("shape"), ShapeStep},
                 {generator("amplitude"), m_jogRate},
                 {generator("base"), 0.0},
                 {generator("duration"), JogHold_s},
                 {"reference.start", 1.0}},
                m_setpoint);
    } else if (const auto ramp = jogRamp()) {
        m_reference.begin();
        m_startedShape = ShapeRamp;
        sendJog(*ramp, m_setpoint);
    }
}

/// Twenty steps a second shake what a ramp of the board moves evenly, but a board that begins each reference
/// where it was armed would leap back.
bool DriveControl::rampsOnBoard() const {
    return continuesReference(m_bench.session().info().firmware) &&
           m_bench.session().catalogue().findParameter(generator("rate")) != nullptr;
}

void DriveControl::moveJogSetpoint() {
    const double step_s =
        m_sinceJogStep.isValid()
            ? std::min(static_cast<double>(m_sinceJogStep.nsecsElapsed()) * 1e-9, LongestJogStep_s)
            : 0.0;
    m_sinceJogStep.start();
    const double next = nextJogSetpoint(step_s);
    sendJog({{setpointName(), m_sent + next - m_setpoint}}, next);
}

/// From where the ramp before runs, so that a renewed hold changes neither angle nor speed. Nothing where
/// jogging ends: the ramp before goes there by itself.
std::optional<std::vector<ParameterValue>> DriveControl::jogRamp() const {
    const double pace_ratio = m_bench.session().pace().speed_ratio;
    const double board_s_per_s = m_bench.session().info().isSimulated && pace_ratio > 0.0 ? pace_ratio : 1.0;
    double end_rad = 0.0; // none
    if (m_jogRoom_rad) {
        const double jogged_s = static_cast<double>(m_jogged.nsecsElapsed()) * 1e-9 * board_s_per_s;
        end_rad =
            std::min(*m_jogRoom_rad - std::abs(m_jogRate) * jogged_s, jogRoom_rad().value_or(*m_jogRoom_rad));
        if (end_rad < m_axis.referenceTolerance) { // an end of 0 would be none
            return std::nullopt;
        }
    }
    return withOthersHeld({{generator("shape"), ShapeRamp},
                           {generator("rate"), m_jogRate},
                           {generator("amplitude"), end_rad},
                           {generator("base"), 0.0},
                           {generator("duration"), JogHold_s * board_s_per_s},
                           {"reference.start", 1.0}});
}

void DriveControl::sendJog(std::vector<ParameterValue> values, double setpoint) {
    m_isJogPending = true;
    m_bench.session().request([values = inMode(m_mode, std::move(values))](
                                  devices::Device& device) { return device.writeParameters(values); },
                              [self = QPointer(this), setpoint](const Result<void>& written) {
                                  if (self) {
                                      self->m_isJogPending = false;
                                      self->finish(written, [&] {
                                          self->m_sent += setpoint - self->m_setpoint;
                                          self->m_setpoint = setpoint;
                                      });
                                  }
                              });
}

/// How far jogging may still move this way.
std::optional<double> DriveControl::jogRoom_rad() const {
    const auto range_rad = setpointRange_rad(WindowShare_ratio);
    if (!range_rad) {
        return std::nullopt;
    }
    return std::max(0.0, m_jogRate > 0.0 ? range_rad->second - m_setpoint : m_setpoint - range_rad->first);
}

/// Jogging ends before the window does; what is beyond that end already stays, or comes back.
double DriveControl::nextJogSetpoint(double step_s) const {
    const double next = m_setpoint + m_jogRate * step_s;
    const auto range_rad = setpointRange_rad(WindowShare_ratio);
    if (!range_rad) {
        return next;
    }
    return m_jogRate > 0.0 ? std::min(next, std::max(range_rad->second, m_setpoint))
                           : std::max(next, std::min(range_rad->first, m_setpoint));
}

void DriveControl::stopJog() {
    if (!m_jog.isActive()) {
        return;
    }
    m_jog.stop();
    if (m_mode != devices::BoardMode::Position || rampsOnBoard()) {
        stopReference();
    }
    Q_EMIT changed();
}

} // namespace halbench::app
