#include "app/workbench/drive_jog.h"

#include "app/workbench/drive_orders.h"

#include <QPointer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

namespace {

constexpr int Period_ms = 20;
/// A window that was busy does not catch up in one leap.
constexpr double LongestStep_s = 0.05;
/// The board ends a jog current that is not renewed.
constexpr double Hold_s = 0.3;
constexpr double ShapeStep = 1.0;
/// Of the board's excursion window: jogging ends before the board would stop it.
constexpr double WindowShare_ratio = 0.9;

} // namespace

DriveJog::DriveJog(Workbench& bench, DriveCommands& commands, DriveAxes& axes, ReferenceRun& reference,
                   QObject* parent)
    : QObject(parent), m_bench(bench), m_commands(commands), m_axes(axes), m_reference(reference) {
    m_timer.setInterval(Period_ms);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &DriveJog::step);
    connect(&m_commands, &DriveCommands::jogEnds, this, &DriveJog::stop);
}

bool DriveJog::usesReference() const {
    return !m_axes.isPositionMode() || m_reference.rampsOnBoard();
}

void DriveJog::start(double rate) {
    m_rate = rate;
    m_room = room();
    m_sinceStep.invalidate();
    m_jogged.start();
    m_timer.start();
    step();
}

void DriveJog::step() {
    if (m_isPending) {
        return;
    }
    if (!usesReference()) {
        moveSetpoint();
        return;
    }
    if (m_sinceStep.isValid() && m_sinceStep.elapsed() < static_cast<qint64>(Hold_s * 500.0)) {
        return; // the hold is still fresh
    }
    m_sinceStep.start();
    if (!m_axes.isPositionMode()) {
        send({{m_axes.generator("shape"), ShapeStep},
              {m_axes.generator("amplitude"), m_rate},
              {m_axes.generator("base"), 0.0},
              {m_axes.generator("duration"), Hold_s},
              {"reference.start", 1.0}},
             m_axes.motion().setpoint);
    } else if (const auto values = ramp()) {
        send(*values, m_axes.motion().setpoint);
    }
}

void DriveJog::moveSetpoint() {
    const double step_s =
        m_sinceStep.isValid()
            ? std::min(static_cast<double>(m_sinceStep.nsecsElapsed()) * 1e-9, LongestStep_s)
            : 0.0;
    m_sinceStep.start();
    const double next = nextSetpoint(step_s);
    const AxisMotion& motion = m_axes.motion();
    send({{m_axes.setpointName(), motion.sent + next - motion.setpoint}}, next);
}

/// From where the ramp before runs, so that a renewed hold changes neither angle nor speed. Nothing where
/// jogging ends: the ramp before goes there by itself.
std::optional<std::vector<ParameterValue>> DriveJog::ramp() const {
    const double pace_ratio = m_bench.session().pace().speed_ratio;
    const double board_s_per_s = m_bench.session().info().isSimulated && pace_ratio > 0.0 ? pace_ratio : 1.0;
    double end = 0.0; // none
    if (m_room) {
        const double jogged_s = static_cast<double>(m_jogged.nsecsElapsed()) * 1e-9 * board_s_per_s;
        end = std::min(*m_room - std::abs(m_rate) * jogged_s, room().value_or(*m_room));
        if (end < m_axes.chosen().referenceTolerance) { // an end of 0 would be none
            return std::nullopt;
        }
    }
    return m_reference.beginRamp(m_rate, end, Hold_s * board_s_per_s);
}

void DriveJog::send(std::vector<ParameterValue> values, double setpoint) {
    m_isPending = true;
    m_bench.session().request([values = inMode(m_axes.mode(), std::move(values))](
                                  devices::Device& device) { return device.writeParameters(values); },
                              [self = QPointer(this), setpoint](const Result<void>& written) {
                                  if (self) {
                                      self->m_isPending = false;
                                      self->m_commands.finish(written, [&] {
                                          AxisMotion& motion = self->m_axes.motion();
                                          motion.sent += setpoint - motion.setpoint;
                                          motion.setpoint = setpoint;
                                      });
                                  }
                              });
}

/// How far jogging may still move this way.
std::optional<double> DriveJog::room() const {
    const auto range = m_axes.setpointRange(WindowShare_ratio);
    if (!range) {
        return std::nullopt;
    }
    const double setpoint = m_axes.motion().setpoint;
    return std::max(0.0, m_rate > 0.0 ? range->second - setpoint : setpoint - range->first);
}

/// Jogging ends before the window does; what is beyond that end already stays, or comes back.
double DriveJog::nextSetpoint(double step_s) const {
    const double setpoint = m_axes.motion().setpoint;
    const double next = setpoint + m_rate * step_s;
    const auto range = m_axes.setpointRange(WindowShare_ratio);
    if (!range) {
        return next;
    }
    return m_rate > 0.0 ? std::min(next, std::max(range->second, setpoint))
                        : std::max(next, std::min(range->first, setpoint));
}

} // namespace halbench::app
