#include "control/design/board_gains.h"
#include "control/design/held_rotor.h"
#include "control/design/load_step.h"
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

struct Motion {
    std::vector<double> time_s, angle_rad, current_A;
};

/// From rest at zero, with a current beside that of the law.
Result<Motion> moved(const PositionPlant& plant, LinearLaw law, const LoopTiming& timing,
                     double reference_rad, double load_A, std::size_t points, int pointsPerSample) {
    const double interval_s = timing.period_s / pointsPerSample;
    Motion motion;
    RotorState state;
    double current_A = 0.0;
    for (std::size_t i = 0; i < points; ++i) {
        if (i % static_cast<std::size_t>(pointsPerSample) == 0) {
            current_A = law.step(reference_rad, state.angle_rad);
        }
        motion.time_s.push_back(static_cast<double>(i) * interval_s);
        motion.angle_rad.push_back(state.angle_rad);
        motion.current_A.push_back(current_A);
        state = advance(plant, state, current_A + load_A, interval_s);
        if (!std::isfinite(state.angle_rad)) {
            return failure(ErrorCode::Refused,
                           "the step response of this unstable loop grows beyond all numbers");
        }
    }
    return motion;
}

/// What sets the loop in motion: one of the two.
struct Cause {
    double reference_rad = 0.0;
    double load_A = 0.0;
};

Result<Motion> checkedMotion(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing,
                             const Cause& cause, double duration_s, int pointsPerSample) {
    const double height = cause.reference_rad != 0.0 ? cause.reference_rad : cause.load_A;
    for (const auto& valid : {checkPlant(plant), checkTiming(timing),
                              checkExtent(height, duration_s, timing.period_s, pointsPerSample)}) {
        if (!valid) {
            return failure(valid.error());
        }
    }
    const auto board = boardGains(gains);
    if (!board) {
        return failure(board.error());
    }
    const double interval_s = timing.period_s / pointsPerSample;
    const auto points = static_cast<std::size_t>(std::floor(duration_s / interval_s + 1e-6)) + 1;
    return moved(plant, LinearLaw(*board, timing), timing, cause.reference_rad, cause.load_A, points,
                 pointsPerSample);
}

} // namespace

void measureLoad(LoadStep& step) {
    constexpr double Recovered_ratio = 0.1;
    for (std::size_t i = 0; i < step.time_s.size(); ++i) {
        if (std::abs(step.angle_rad[i]) > std::abs(step.peak_rad)) {
            step.peak_rad = step.angle_rad[i];
            step.peakTime_s = step.time_s[i];
        }
    }
    if (std::abs(step.final_rad) > std::abs(step.peak_rad) && !step.time_s.empty()) {
        step.peak_rad = step.final_rad; // approached from below, and so not within any time that is looked at
        step.peakTime_s = step.time_s.back();
    }
    const double band_rad = Recovered_ratio * std::abs(step.peak_rad);
    std::size_t within = step.time_s.size();
    while (within > 0 && std::abs(step.angle_rad[within - 1] - step.final_rad) <= band_rad) {
        --within;
    }
    if (within < step.time_s.size()) {
        step.recoveryTime_s = step.time_s[within];
    }
}

Result<LoopStep> linearStep(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing,
                            double amplitude_rad, double duration_s, int pointsPerSample) {
    const auto motion =
        checkedMotion(plant, gains, timing, {amplitude_rad, 0.0}, duration_s, pointsPerSample);
    if (!motion) {
        return failure(motion.error());
    }
    const auto metrics = measureStep(motion->time_s, motion->angle_rad, 0.0, amplitude_rad);
    if (!metrics) {
        return failure(metrics.error());
    }
    return LoopStep{motion->time_s, motion->angle_rad, motion->current_A, *metrics};
}

Result<LoadStep> loadStep(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing,
                          double load_A, double duration_s, int pointsPerSample) {
    const auto motion = checkedMotion(plant, gains, timing, {0.0, load_A}, duration_s, pointsPerSample);
    if (!motion) {
        return failure(motion.error());
    }
    LoadStep step;
    step.time_s = motion->time_s;
    step.angle_rad = motion->angle_rad;
    step.current_A = motion->current_A;
    step.final_rad = gains.integral > 0.0 ? 0.0 : load_A / gains.proportional;
    measureLoad(step);
    return step;
}

} // namespace halbench::control
