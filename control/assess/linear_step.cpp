#include "control/assess/loop_motion.h"
#include "control/law/board_gains.h"

#include <utility>

namespace halbench::control {

namespace {

/// The law without its limits and extras.
class LinearLaw {
public:
    LinearLaw(const PidGains& gains, double period_s) : m_gains(gains), m_period_s(period_s) {}

    double operator()(double reference_rad, double angle_rad) {
        const double error_rad = reference_rad - angle_rad;
        const double speed_rad_s = (angle_rad - m_lastAngle_rad) / m_period_s;
        const double current_A =
            m_gains.proportional * error_rad + m_integral_A - m_gains.derivative * speed_rad_s;
        m_integral_A += m_period_s * m_gains.integral * error_rad;
        m_lastAngle_rad = angle_rad;
        return current_A;
    }

private:
    PidGains m_gains;
    double m_period_s;
    double m_integral_A = 0.0;
    double m_lastAngle_rad = 0.0;
};

Result<LoopMotion> boardMotion(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing,
                               const MotionCause& cause, double duration_s, int pointsPerSample) {
    const auto board = boardGains(gains);
    return board ? loopMotion(plant, LinearLaw(*board, timing.period_s), timing, cause, duration_s,
                              pointsPerSample)
                 : Result<LoopMotion>(failure(board.error()));
}

} // namespace

Result<LoopStep> linearStep(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing,
                            double amplitude_rad, double duration_s, int pointsPerSample) {
    auto motion = boardMotion(plant, gains, timing, {amplitude_rad, 0.0}, duration_s, pointsPerSample);
    return motion ? stepOf(*std::move(motion), amplitude_rad) : failure(motion.error());
}

Result<LoadStep> loadStep(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing,
                          double load_A, double duration_s, int pointsPerSample) {
    auto motion = boardMotion(plant, gains, timing, {0.0, load_A}, duration_s, pointsPerSample);
    const double final_rad = gains.integral > 0.0 ? 0.0 : load_A / gains.proportional;
    return motion ? Result<LoadStep>(loadOf(*std::move(motion), final_rad)) : failure(motion.error());
}

} // namespace halbench::control
