#pragma once

#include "app/procedures/motion_band.h"
#include "app/procedures/procedure.h"

#include <atomic>
#include <memory>
#include <optional>

namespace halbench::app {

/// Compares a move with its predicted band while it is made. Give observer() to the procedure that moves: its
/// next question whether to go on is answered with an error once the measured angle was outside for longer
/// than a glitch. Thread: the procedure's, and the one that delivers blocks.
class BandWatch {
public:
    /// The band's angles are from where the rotor was, its time from the start of the reference. Must outlive
    /// the move.
    BandWatch(const ProcedureObserver& observer, MotionBand band);

    ProcedureObserver observer();
    bool hasLeft() const { return m_hasLeft; }
    /// When and how far, in words. Only after hasLeft().
    Error departure() const;

private:
    void take(const SampleBlock& block);
    void compare(double time_s, double angle_rad);

    const ProcedureObserver& m_observer;
    MotionBand m_band;
    std::shared_ptr<const StreamLayout> m_layout; ///< of the columns below
    int m_position = -1;
    int m_running = -1;
    std::optional<double> m_rest_rad; ///< before the reference began
    std::optional<double> m_start_s;  ///< of the reference
    std::optional<double> m_outsideSince_s;
    double m_leftAt_s = 0.0; ///< written before m_hasLeft
    double m_beyond_rad = 0.0;
    std::atomic<bool> m_hasLeft = false;
};

} // namespace halbench::app
