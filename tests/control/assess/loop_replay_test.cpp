#include "control/assess/loop_reference.h"
#include "control/assess/loop_replay.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

constexpr double Period_s = 0.01;

std::vector<double> sampled(const LoopReference& reference, double duration_s) {
    std::vector<double> values;
    for (int i = 0; i <= std::lround(duration_s / Period_s); ++i) {
        values.push_back(evaluateReference(reference, i * Period_s).value_rad);
    }
    return values;
}

// A plant that is an integrator, angle' = current, under proportional gain alone: from sample to sample
// e[k+1] = (1 - Kp T) e[k]. Seen at the rows that are samples too, whether or not T is whole milliseconds.
TEST(LoopReplay, computesOnceAPeriodAndHoldsTheCurrent) {
    for (const double period_s : {0.5e-3, 1.5e-3, 10e-3}) {
        const std::vector<ReferencePoint> reference(1, {0.1, 0.0, 0.0});
        LoopReplayConfig config;
        config.law.ki_A_per_rad_s = 0.0;
        config.law.period_s = period_s;
        config.reference = reference;
        config.rows = 61;
        double angle_rad = 0.0;
        const LoopReplay replay = replayLoop(
            config, [&](double current_A, double duration_s) { return angle_rad += duration_s * current_A; });
        ASSERT_EQ(replay.angle_rad.size(), 61U);
        for (std::size_t row = 0; row < 61; row += 30) {
            const double samples = std::round(1e-3 * static_cast<double>(row) / period_s);
            const double error_rad = 0.1 * std::pow(1.0 - config.law.kp_A_per_rad * period_s, samples);
            EXPECT_NEAR(replay.angle_rad[row], 0.1 - error_rad, 1e-12)
                << period_s << " s, row " << row; // rounding
            EXPECT_NEAR(replay.current_A[row], config.law.kp_A_per_rad * error_rad, 1e-11);
        }
    }
}

TEST(LoopReplay, addsTheDisturbanceOfEachRowToTheCurrent) {
    const std::vector<ReferencePoint> reference(1);
    const std::vector<double> disturbance_A{0.1, 0.2, 0.3};
    LoopReplayConfig config;
    config.reference = reference;
    config.disturbance_A = disturbance_A;
    config.rows = disturbance_A.size();
    std::vector<double> held_A;
    const LoopReplay replay = replayLoop(config, [&](double current_A, double duration_s) {
        EXPECT_DOUBLE_EQ(duration_s, 1e-3);
        held_A.push_back(current_A);
        return 0.0; // the plant does not yield: the law asks for nothing
    });
    EXPECT_EQ(held_A, disturbance_A);
    EXPECT_EQ(replay.current_A, std::vector<double>(3, 0.0));
}

TEST(ReferencePoints, areThoseOfTheFormulas) {
    const LoopReference sine{LoopReference::Shape::Sine, 8.0, 0, 0.2, 1, 1};
    const auto points = referencePoints(sampled(sine, 5.0), Period_s);
    for (std::size_t i = 2; i + 2 < points.size(); ++i) {
        const ReferencePoint exact = evaluateReference(sine, static_cast<double>(i) * Period_s);
        // Central differences: h^2/6 of the third derivative, 8 (2 pi 0.2)^3 1e-4/6; of the acceleration the
        // neighbour at its extremes, h^2/2 of its second derivative, 8 (2 pi 0.2)^4 1e-4/2.
        EXPECT_NEAR(points[i].speed_rad_s, exact.speed_rad_s, 3e-4) << i;
        EXPECT_NEAR(points[i].acceleration_rad_s2, exact.acceleration_rad_s2, 2e-3) << i;
    }
    const LoopReference ramp{LoopReference::Shape::Ramp, 0.0, 2.0, 0, 1, 1};
    for (const ReferencePoint& point : referencePoints(sampled(ramp, 1.0), Period_s)) {
        EXPECT_NEAR(point.speed_rad_s, 2.0, 1e-9);
        EXPECT_NEAR(point.acceleration_rad_s2, 0.0, 1e-9);
    }
}

TEST(ReferencePoints, aJumpHasNoSpeed) {
    const LoopReference stairs{LoopReference::Shape::Staircase, 0.3, 0, 0, 0.2, 4};
    for (const ReferencePoint& point : referencePoints(sampled(stairs, 1.0), Period_s)) {
        EXPECT_EQ(point.speed_rad_s, 0.0);
        EXPECT_EQ(point.acceleration_rad_s2, 0.0);
    }
}

} // namespace
} // namespace halbench::control
