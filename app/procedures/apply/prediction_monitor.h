#pragma once

#include "app/procedures/base/procedure.h"
#include "app/procedures/move/motion_envelope.h"
#include "devices/axis_spec.h"

#include <atomic>
#include <memory>
#include <optional>
#include <utility>

namespace halbench::app {

/// When a motion left its band, and how far it was outside by then.
struct BandDeparture {
    double at_s = 0.0;
    double beyond_rad = 0.0;
};

/// Follows a motion through its band, angle by angle: it has left once it was outside for longer than a
/// glitch.
class BandCheck {
public:
    explicit BandCheck(MotionEnvelope band) : m_band(std::move(band)) {}

    /// Both from the start of the reference; times rise. A value that is no number is never inside.
    void add(double time_s, double angle_rad);
    const std::optional<BandDeparture>& departure() const { return m_departure; }

private:
    MotionEnvelope m_band;
    std::optional<double> m_outsideSince_s;
    std::optional<BandDeparture> m_departure; ///< the first one
};

/// The departure in words.
Error departureError(const BandDeparture& departure);
/// The same of an axis, in its unit.
Error departureError(const BandDeparture& departure, const devices::AxisSpec& axis);

/// Compares a move with its predicted band while it is made. Give observer() to the procedure that moves: its
/// next question whether to go on is answered with an error once the measured angle was outside for longer
/// than a glitch. Thread: the procedure's, and the one that delivers blocks.
class PredictionMonitor {
public:
    /// The band's angles are from where the rotor was, its time from the start of the reference. Must outlive
    /// the move.
    PredictionMonitor(const ProcedureObserver& observer, MotionEnvelope band);

    ProcedureObserver observer();
    bool hasLeft() const { return m_hasLeft; }
    /// When and how far, in words. Only after hasLeft().
    Error departure() const;

private:
    void take(const SampleBlock& block);

    const ProcedureObserver& m_observer;
    BandCheck m_check;                            ///< of the thread that delivers blocks, until m_hasLeft
    std::shared_ptr<const StreamLayout> m_layout; ///< of the columns below
    int m_position = -1;
    int m_running = -1;
    std::optional<double> m_rest_rad; ///< before the reference began
    std::optional<double> m_start_s;  ///< of the reference
    std::atomic<bool> m_hasLeft = false;
};

} // namespace halbench::app
