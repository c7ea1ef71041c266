#include "control/design/board_gains.h"
#include "control/design/held_rotor.h"
#include "control/design/position_loop.h"

#include <fmt/format.h>

#include <cmath>
#include <deque>

namespace halbench::control {

namespace {

/// The law without its limits and extras, for a constant reference, with its computing delay.
class LinearLaw {
public:
    LinearLaw(const PidGains& gains, const LoopTiming& timing)
        : m_gains(gains), m_period_s(timing.period_s),
          m_pending_A(static_cast<std::size_t>(timing.delay_samples), 0.0) {}

    double step(double reference_rad, double angle_rad) {
        const double error_rad = reference_rad - angle_rad;
        const double speed_rad_s = (angle_rad - m_lastAngle_rad) / m_period_s;
        m_pending_A.push_back(m_gains.proportional * error_rad + m_integral_A -
                              m_gains.derivative * speed_rad_s);
        m_integral_A += m_period_s * m_gains.integral * error_rad;
        m_lastAngle_rad = angle_rad;
        const double current_A = m_pending_A.front();
        m_pending_A.pop_front();
        return current_A;
    }

private:
    PidGains m_gains;
    double m_period_s;
    std::deque<double> m_pending_A;
    double m_integral_A = 0.0;
    double m_lastAngle_rad = 0.0;
};

Result<void> checkExtent(double amplitude_rad, double duration_s, double period_s, int pointsPerSample) {
    constexpr double MaxPoints = 1e7;
    if (!std::isfinite(amplitude_rad) || amplitude_rad == 0.0) {
        return failure(ErrorCode::OutOfRange, "a step needs a finite height that is not zero");
    }
    if (!(duration_s > 0.0 && pointsPerSample >= 1 && duration_s / period_s * pointsPerSample < MaxPoints)) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a step response of {} s is not possible", duration_s));
    }
    return {};
}

} // namespace

Result<LoopStep> linearStep(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing,
                            double amplitude_rad, double duration_s, int pointsPerSample) {
    for (const auto& valid : {checkPlant(plant), checkTiming(timing),
                              checkExtent(amplitude_rad, duration_s, timing.period_s, pointsPerSample)}) {
        if (!valid) {
            return failure(valid.error());
        }
    }
    const auto board = boardGains(gains);
    if (!board) {
        return failure(board.error());
    }
    LinearLaw law(*board, timing);
    const double interval_s = timing.period_s / pointsPerSample;
    const auto points = static_cast<std::size_t>(std::floor(duration_s / interval_s + 1e-6)) + 1;
    LoopStep result;
    RotorState state;
    double current_A = 0.0;
    for (std::size_t i = 0; i < points; ++i) {
        if (i % static_cast<std::size_t>(pointsPerSample) == 0) {
            current_A = law.step(amplitude_rad, state.angle_rad);
        }
        result.time_s.push_back(static_cast<double>(i) * interval_s);
        result.response_rad.push_back(state.angle_rad);
        result.current_A.push_back(current_A);
        state = advance(plant, state, current_A, interval_s);
        if (!std::isfinite(state.angle_rad)) {
            return failure(ErrorCode::Refused,
                           "the step response of this unstable loop grows beyond all numbers");
        }
    }
    const auto metrics = measureStep(result.time_s, result.response_rad, 0.0, amplitude_rad);
    if (!metrics) {
        return failure(metrics.error());
    }
    result.metrics = *metrics;
    return result;
}

} // namespace halbench::control
