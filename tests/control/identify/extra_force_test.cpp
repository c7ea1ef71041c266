#include "control/base/random.h"
#include "control/identify/extra_force_problem.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

constexpr double Damping_per_s = 1.23e-3 / 5.5e-4;
constexpr double Friction_rad_s2 = 2.05e-2 / 5.5e-4;
constexpr double Torque_rad_s2_A = 1.43e-2 / 5.5e-4;

// Run-ups and coast-downs in both directions, friction of 3 % scatter, angle noise of 0.04 degrees; the rotor
// is integrated by Heun's rule in steps of 0.2 ms, whose error is far below the noise.
std::vector<MotionSegment> motionWith(const ExtraForceTerm& term, std::uint64_t seed) {
    Random random(seed);
    std::vector<double> time_s;
    std::vector<double> angle_rad;
    std::vector<double> current_A;
    double angle = 0.3;
    double speed = 0.0;
    const auto run = [&](double current, int rows) {
        const double friction = Friction_rad_s2 * (1.0 + 0.03 * random.gaussian());
        for (int row = 0; row < rows; ++row) {
            time_s.push_back(0.01 * static_cast<double>(time_s.size()));
            angle_rad.push_back(angle + 7e-4 * random.gaussian());
            current_A.push_back(current);
            constexpr int Steps = 50;
            for (int i = 0; i < Steps; ++i) {
                const double direction =
                    speed != 0.0 ? std::copysign(1.0, speed) : std::copysign(1.0, current);
                if (speed == 0.0 && std::fabs(Torque_rad_s2_A * current) <= friction) {
                    continue;
                }
                const auto accelerationAt = [&](double w) {
                    return Torque_rad_s2_A * current - direction * friction - Damping_per_s * w +
                           term.value * extraForce_rad_s2(term, w, current, 0.0);
                };
                const double step_s = 0.01 / Steps;
                const double first = accelerationAt(speed);
                const double next = speed + 0.5 * step_s * (first + accelerationAt(speed + step_s * first));
                angle += 0.5 * step_s * (speed + next);
                speed = direction * next > 0.0 ? next : 0.0;
            }
        }
    };
    for (int i = 0; i < 10; ++i) {
        const double sign = i % 2 == 0 ? 1.0 : -1.0;
        run(sign * 4.0, 150);
        run(sign * (2.4 + 0.1 * i), 200);
        run(sign * 4.0, 100);
        run(0.0, 100);
    }
    const auto plateaus = findPlateaus(time_s, current_A, {}, {});
    EXPECT_TRUE(plateaus);
    return findMotion(time_s, angle_rad, *plateaus, {});
}

Result<ExtraForceFit> fitted(const ExtraForceTerm& term, std::uint64_t seed) {
    const auto segments = motionWith(term, seed);
    const auto motion = fitMotion(segments);
    EXPECT_TRUE(motion);
    return fitExtraForces(segments, *motion, {});
}

TEST(ExtraForce, opposesTheMotion) {
    EXPECT_EQ(extraForce_rad_s2({ExtraForce::QuadraticDrag}, -3.0, 0.0, 0.0), 9.0);
    EXPECT_EQ(extraForce_rad_s2({ExtraForce::DampingByDirection}, -3.0, 0.0, 0.0), -3.0);
    EXPECT_EQ(extraForce_rad_s2({ExtraForce::DampingByCurrent}, 3.0, -2.0, 0.0), -12.0);
    EXPECT_EQ(extraForce_rad_s2({ExtraForce::DampingDrift}, 3.0, 0.0, -0.5), 1.5);
    ExtraForceTerm stribeck{ExtraForce::Stribeck};
    stribeck.stribeckSpeed_rad_s = 2.0;
    EXPECT_DOUBLE_EQ(extraForceAtSpeed_rad_s2(stribeck, -2.0, 0.0), std::exp(-1.0));
}

// The terms are taken at one chance in a thousand: twelve motors without any give none.
TEST(ExtraForce, takesNoTermThatIsNotThere) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const auto fit = fitted({}, seed);
        ASSERT_TRUE(fit);
        EXPECT_TRUE(fit->terms.empty()) << seed;
        EXPECT_TRUE(fit->isAdequate) << seed;
        EXPECT_NEAR(fit->motion.damping_per_s, Damping_per_s, 5.0 * fit->motion.dampingError_per_s) << seed;
    }
}

// Besides the scatter: trapezoids of 10 ms and the course of the speed leave half a per cent of a term.
TEST(ExtraForce, findsTheTermThatIsThereAndItsSize) {
    for (const ExtraForceTerm& term : {ExtraForceTerm{ExtraForce::QuadraticDrag, 0.0, 0.02},
                                       ExtraForceTerm{ExtraForce::DampingByDirection, 0.0, 0.1},
                                       ExtraForceTerm{ExtraForce::Stribeck, 5.0, 8.0}}) {
        const auto fit = fitted(term, 3);
        ASSERT_TRUE(fit);
        ASSERT_EQ(fit->terms.size(), 1u) << static_cast<int>(term.force);
        const ExtraForceTerm& found = fit->terms.front();
        EXPECT_EQ(found.force, term.force);
        EXPECT_TRUE(fit->isAdequate);
        const double scale = term.force == ExtraForce::Stribeck ? 3.0 : 10.0;
        EXPECT_NEAR(found.value * extraForceAtSpeed_rad_s2(found, scale, 0.0),
                    term.value * extraForceAtSpeed_rad_s2(term, scale, 0.0),
                    std::fabs(extraForceAtSpeed_rad_s2(found, scale, 0.0)) *
                        (4.0 * found.error + 0.005 * std::fabs(term.value)));
        EXPECT_NEAR(fit->motion.damping_per_s, Damping_per_s, 0.01 * Damping_per_s);
        const auto balance = fitBalance(fit->motion);
        ASSERT_TRUE(balance);
        const auto sigma = [&](int i) {
            return std::sqrt(balance->scatterCovariance(i, i) + balance->dampingCovariance(i, i));
        };
        EXPECT_NEAR(*balance->friction_rad_s2, Friction_rad_s2, 4.0 * sigma(1));
        EXPECT_NEAR(*balance->torque_rad_s2_A, Torque_rad_s2_A, 4.0 * sigma(2));
    }
}

} // namespace
} // namespace halbench::control
