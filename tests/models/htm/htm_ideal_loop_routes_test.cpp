#include "models/htm/htm_ideal_loop.h"
#include "tests/models/htm/ideal_loop_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// The same motion by another route: a plain integrator, a law from outside.

namespace halbench::models {
namespace {

/// Angles of the published motor at whole milliseconds, by the plainest integrator there is: small steps of
/// constant acceleration, Coulomb friction that stops the rotor where its speed would change sign.
std::vector<double> integrated_rad(const IdealLoopConfig& config, double amplitude_rad, int stepsPerPeriod) {
    const control::SampledPositionLaw& law = config.law;
    const double h = law.period_s / stepsPerPeriod;
    const double gain = config.torqueConstant_Nm_per_A / config.rotor.inertia_kg_m2;
    const double friction = config.rotor.coulombFriction_Nm / config.rotor.inertia_kg_m2;
    const double damping = config.rotor.viscousDamping_Nm_s / config.rotor.inertia_kg_m2;
    double angle = 0.0, speed = 0.0, integral = 0.0, previous = 0.0, current = 0.0;
    std::vector<double> rows;
    for (long i = 0; static_cast<double>(i) * h < config.duration_s + 0.5 * h; ++i) {
        if (i % stepsPerPeriod == 0) {
            const double error = amplitude_rad - angle;
            const double u =
                law.kp_A_per_rad * error + integral - law.kd_As_per_rad * (angle - previous) / law.period_s;
            previous = angle;
            current = std::clamp(u, -law.limit_A, law.limit_A);
            integral += u == current || error * u < 0.0 ? law.period_s * law.ki_A_per_rad_s * error : 0.0;
        }
        if (std::floor(1e3 * static_cast<double>(i) * h + 1e-6) >= static_cast<double>(rows.size())) {
            rows.push_back(angle);
        }
        const double torque = gain * current;
        const double direction = speed != 0.0 ? std::copysign(1.0, speed) : std::copysign(1.0, torque);
        const bool isHeld = speed == 0.0 && std::fabs(torque) <= friction;
        const double acceleration = isHeld ? 0.0 : torque - friction * direction - damping * speed;
        const double next = speed + h * acceleration;
        const double reached = speed * next < 0.0 ? 0.0 : next;
        angle += 0.5 * h * (speed + reached);
        speed = reached;
    }
    return rows;
}

// The loop steps by its own period where that is no whole number of milliseconds; it used to be called at the
// nearest ones, and not at all below half of one.
TEST(HtmIdealLoop, periodsThatAreNoWholeMillisecondsAreKept) {
    const double amplitude_rad = degreesToRadians(100.0);
    for (const double period_s : {1e-4, 4e-4, 5e-4, 1.5e-3, 2.5e-3, 1.05e-2}) {
        IdealLoopConfig config = loop(step(100.0), 5.0);
        config.law.kd_As_per_rad = 0.4;
        config.law.period_s = period_s;
        const IdealTrace trace = runIdealLoop(config);
        const auto other =
            integrated_rad(config, amplitude_rad, static_cast<int>(std::lround(period_s / 1e-5)));
        double largest_rad = 0.0;
        for (std::size_t i = 0; i < trace.time_s.size(); ++i) {
            const double row = 1e3 * trace.time_s[i];
            const auto at = static_cast<std::size_t>(std::lround(row));
            if (std::fabs(row - std::round(row)) < 1e-6 && at < other.size()) {
                largest_rad = std::max(largest_rad, std::fabs(trace.angle_rad[i] - other[at]));
            }
        }
        // Steps of 10 us at up to 12 rad/s: an instant is known to 1e-4 rad; the wrong period moved 0.2 rad.
        EXPECT_LT(largest_rad, 3e-4) << period_s;
        EXPECT_NEAR(trace.time_s.back(), config.duration_s, 0.5e-3) << period_s;
    }
}

// The same law from outside, called once a period with what the law would have seen.
TEST(HtmIdealLoop, aControllerInThePlaceOfTheLawMovesTheSameMotor) {
    IdealLoopConfig config = loop(step(20.0), 2.0);
    config.initialAngle_rad = 0.7;
    config.law.ki_A_per_rad_s = 0.0;
    const IdealTrace own = runIdealLoop(config);
    int calls = 0;
    config.controller = [&](const control::ReferencePoint& reference, double angle_rad) {
        ++calls;
        return std::clamp(config.law.kp_A_per_rad * (reference.value_rad - angle_rad), -config.law.limit_A,
                          config.law.limit_A);
    };
    const IdealTrace other = runIdealLoop(config);
    EXPECT_EQ(other.angle_rad, own.angle_rad);
    EXPECT_EQ(other.current_A, own.current_A);
    EXPECT_EQ(calls, 201); // 2 s at 100 Hz, both ends
}

} // namespace
} // namespace halbench::models
