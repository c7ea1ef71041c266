#pragma once

#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/excite/move_reference.h"

#include <functional>
#include <limits>
#include <string>

namespace halbench::app {

/// Speed limits of a steady rotation that carries an excitation.
struct TurnLimits {
    double turn_rad_s = 1.0;    ///< of the base motion, signed
    double highest_rad_s = 0.0; ///< foreseen magnitude; 0: nothing is
    std::string slowRemedy;     ///< when it comes near standstill
};

/// Ends a run when the speed leaves that: near standstill friction changes its sign, and what swings more
/// than one and a half times as far as foreseen is not the loop of the plan.
class TurnWatch {
public:
    static constexpr double Least_ratio = 0.1;    ///< of the base speed
    static constexpr double Surprise_ratio = 1.5; ///< of the speed that was foreseen

    explicit TurnWatch(TurnLimits limits) : m_limits(std::move(limits)) {}

    void take(const SampleBlock& block);
    void begin() { m_isOn = true; } ///< before that it runs up
    /// Errors: Refused.
    Result<void> check() const;
    bool isNearStandstill() const;

private:
    TurnLimits m_limits;
    double m_lowest_rad_s = std::numeric_limits<double>::infinity(); ///< along the turn
    double m_highest_rad_s = 0.0;
    bool m_isOn = false;
};

/// Records a motor while it is moved, under a TurnWatch and the host's guard.
class GuardedRotation {
public:
    GuardedRotation(devices::Device& device, const ProcedureObserver& observer, TurnLimits limits);

    /// `move` arms, moves and disarms; it waits with observer(). Errors: of it, of the watch, of the guard.
    Result<Recording> record(double speedLimit_rad_s, double period_s,
                             const std::function<Result<void>()>& move);

    const ProcedureObserver& observer() const { return m_observer; }
    void beginWatch() { m_watch.begin(); }
    bool isNearStandstill() const { return m_watch.isNearStandstill(); }
    std::size_t rows() const { return m_recorder.rows(); }

private:
    devices::Device& m_device;
    const ProcedureObserver& m_outer;
    ProcedureObserver m_observer; ///< the outer one, listened in
    TurnWatch m_watch;
    StreamRecorder m_recorder;
};

/// The board's generator runs this from now on; what a board has no parameter for is left out.
Result<void> startGenerator(devices::Device& device, const MoveReference& reference, double duration_s);

} // namespace halbench::app
