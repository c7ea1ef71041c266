#pragma once

#include "app/procedures/identify/identify_plan.h"
#include "control/base/random.h"
#include "control/base/units.h"

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace halbench::app {

/// A motor with more friction than the model of resources/help/htm-theory.md section 3.1 knows. Friction
/// torque against the motion, with d = +-1 its direction:
///
///   c |w| + c2 w^2 + K_f (1 + d asymmetry) (1 + scatter) [1 + sum of A_n sin(n psi + n)]
///       + K_f (stribeck - 1) exp(-(w/w_s)^2),           at rest `static_ratio` K_f.
struct RecordedMotor {
    double inertia_kg_m2 = 5.5e-4;
    double damping_Nm_s = 1.23e-3;
    double friction_Nm = 2.05e-2;
    double torque_Nm_per_A = 1.43e-2;
    double square_Nm_s2 = 0.0; ///< c2
    double stribeck_ratio = 1.0;
    double stribeckSpeed_rad_s = 1.0;
    double static_ratio = 1.15;
    double asymmetry_ratio = 0.0;
    std::vector<double> perTurn_ratio; ///< A_1, A_2, ...
    double scatter_ratio = 0.033;      ///< drawn for each current
    double noise_rad = 7e-4;           ///< 0.04 degrees: the steps of the converter
    double sensorError_rad = 0.01;     ///< once per turn
    /// Current that flows for a commanded one at this speed; empty: the commanded one.
    std::function<double(double current_A, double speed_rad_s)> amplifier;
    double loadFriction_Nm_A2 = 0.0; ///< friction that grows with the square of the current
    std::string text;                ///< of the trace of a test
};

/// Moves it through currents by second-order steps of 0.5 ms, rest being a state.
class MotorRecorder {
public:
    MotorRecorder(const RecordedMotor& motor, std::uint64_t seed) : m_motor(motor), m_random(seed) {
        auto layout = std::make_shared<StreamLayout>();
        layout->columns = {{"position", "rad"}, {"current_command", "A"}};
        recording.layout = layout;
    }

    void run(double current_A, double duration_s) {
        m_scatter = 1.0 + m_motor.scatter_ratio * m_random.gaussian();
        constexpr int StepsPerRow = 20;
        const int rows = static_cast<int>(std::lround(duration_s * 100.0));
        for (int row = 0; row < rows; ++row) {
            recording.time_s.push_back(0.01 * static_cast<double>(recording.time_s.size()));
            recording.values.push_back(m_angle_rad + m_motor.sensorError_rad * std::sin(m_angle_rad + 0.4) +
                                       m_motor.noise_rad * m_random.gaussian());
            recording.values.push_back(current_A);
            for (int i = 0; i < StepsPerRow; ++i) {
                step(current_A, 0.01 / StepsPerRow);
            }
        }
    }

    Recording recording;

private:
    double flowing_A(double current_A) const {
        return m_motor.amplifier ? m_motor.amplifier(current_A, m_speed_rad_s) : current_A;
    }

    double friction_Nm(double speed_rad_s, double angle_rad, double direction) const {
        double turn = 1.0;
        for (std::size_t n = 1; n <= m_motor.perTurn_ratio.size(); ++n) {
            const auto order = static_cast<double>(n);
            turn += m_motor.perTurn_ratio[n - 1] * std::sin(order * (angle_rad + 1.0));
        }
        const double ratio = speed_rad_s / m_motor.stribeckSpeed_rad_s;
        return m_motor.friction_Nm * ((1.0 + direction * m_motor.asymmetry_ratio) * m_scatter * turn +
                                      (m_motor.stribeck_ratio - 1.0) * std::exp(-ratio * ratio)) +
               m_motor.damping_Nm_s * std::fabs(speed_rad_s) +
               m_motor.square_Nm_s2 * speed_rad_s * speed_rad_s + m_load_Nm;
    }

    void step(double current_A, double duration_s) {
        const double torque_Nm = m_motor.torque_Nm_per_A * flowing_A(current_A);
        m_load_Nm = m_motor.loadFriction_Nm_A2 * current_A * current_A;
        double direction = std::copysign(1.0, m_speed_rad_s);
        if (m_speed_rad_s == 0.0) {
            direction = std::copysign(1.0, torque_Nm);
            const double kept = std::max(m_motor.static_ratio * m_motor.friction_Nm * m_scatter,
                                         friction_Nm(0.0, m_angle_rad, direction));
            if (std::fabs(torque_Nm) <= kept) {
                return;
            }
        }
        const auto acceleration = [&](double speed_rad_s, double angle_rad) {
            return (torque_Nm - direction * friction_Nm(speed_rad_s, angle_rad, direction)) /
                   m_motor.inertia_kg_m2;
        };
        const double half_s = 0.5 * duration_s;
        const double middle_rad_s = m_speed_rad_s + half_s * acceleration(m_speed_rad_s, m_angle_rad);
        const double after_rad_s =
            m_speed_rad_s + duration_s * acceleration(middle_rad_s, m_angle_rad + half_s * m_speed_rad_s);
        m_angle_rad += duration_s * 0.5 * (m_speed_rad_s + after_rad_s);
        m_speed_rad_s = direction * after_rad_s > 0.0 ? after_rad_s : 0.0;
    }

    RecordedMotor m_motor;
    Random m_random;
    double m_scatter = 1.0;
    double m_load_Nm = 0.0;
    double m_angle_rad = 0.3;
    double m_speed_rad_s = 0.0;
};

/// What the excitation of `identify` records of it: sweep, run-ups and coast-downs in both directions. The
/// plan knows the slope of the friction at half of the speed limit, as a pilot run would.
inline Recording recordedExcitation(const RecordedMotor& motor, std::uint64_t seed,
                                    const IdentifyConfig& config) {
    const PilotEstimate pilot{
        (motor.damping_Nm_s + config.speedLimit_rad_s * motor.square_Nm_s2) / motor.inertia_kg_m2,
        motor.friction_Nm / motor.inertia_kg_m2, motor.torque_Nm_per_A / motor.inertia_kg_m2, 0.0};
    const auto currents_A = sweepCurrents_A(config.sweep, 4.0);
    MotorRecorder recorder(motor, seed);
    for (const PlateauRun& run : planRuns(config, *currents_A, pilot)) {
        recorder.run(0.0, 1.0);
        for (const double current_A : run.currents_A) {
            recorder.run(current_A, run.dwell_s);
        }
        recorder.run(0.0, 2.0);
    }
    return recorder.recording;
}

} // namespace halbench::app
