#pragma once

#include "control/base/random.h"
#include "control/identify/motion_segments.h"

#include <cmath>
#include <vector>

namespace halbench::control {

/// The published motor over its inertia, resources/help/htm-theory.md section 2: c/J, K_f/J, phi/J.
struct RecordRatios {
    double damping_per_s = 1.23e-3 / 5.5e-4;
    double friction_rad_s2 = 2.05e-2 / 5.5e-4;
    double torque_rad_s2_A = 1.43e-2 / 5.5e-4;
};

/// What spoils a record: random friction per segment, angle noise, errors of the Hall sensors.
struct RecordErrors {
    double friction_ratio = 0.0;
    double noise_rad = 0.0;
    double firstOrder_rad = 0.0;
    double secondOrder_rad = 0.0;
};

/// A rotor that follows the closed form of resources/help/htm-theory.md section 3.1 through plateaus of
/// current, one friction for each; positive direction.
class RecordMaker {
public:
    RecordMaker(const RecordRatios& ratios, const RecordErrors& errors, std::uint64_t seed)
        : m_ratios(ratios), m_errors(errors), m_random(seed) {}

    void run(double current_A, double duration_s) {
        const double f =
            m_ratios.friction_rad_s2 * (1.0 + m_errors.friction_ratio * m_random.gaussian()) * m_direction;
        const double a = m_ratios.damping_per_s;
        const double end = (m_ratios.torque_rad_s2_A * current_A - f) / a;
        const double start = m_speed;
        const double stop = m_direction * end < 0.0 ? std::log((start - end) / -end) / a : 1e9;
        const auto samples = static_cast<int>(std::lround(duration_s * 100.0));
        const auto angleAt = [&](double t) {
            return m_angle + end * t + (start - end) * -std::expm1(-a * t) / a;
        };
        for (int i = 1; i <= samples; ++i) {
            time_s.push_back(m_time + i / 100.0);
            angle_rad.push_back(measured(angleAt(std::fmin(i / 100.0, stop))));
            current_column_A.push_back(current_A);
        }
        m_angle = angleAt(std::fmin(duration_s, stop));
        m_speed = duration_s >= stop ? 0.0 : end + (start - end) * std::exp(-a * duration_s);
        m_time += duration_s;
    }
    /// Turns the other way from now on; only at rest.
    void reverse() { m_direction = -m_direction; }

    std::vector<double> time_s;
    std::vector<double> angle_rad;
    std::vector<double> current_column_A;

private:
    double measured(double angle) {
        return angle + m_errors.firstOrder_rad * std::sin(angle + 0.4) +
               m_errors.secondOrder_rad * std::cos(2.0 * angle - 0.7) +
               m_errors.noise_rad * m_random.gaussian();
    }

    RecordRatios m_ratios;
    RecordErrors m_errors;
    Random m_random;
    double m_time = 0.0;
    double m_angle = 0.3;
    double m_speed = 0.0;
    double m_direction = 1.0;
};

} // namespace halbench::control
