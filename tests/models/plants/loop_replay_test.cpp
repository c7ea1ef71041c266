#include "control/base/units.h"
#include "models/plants/loop_replay.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

constexpr double Period_s = 0.01;

std::vector<double> sampled(const LoopReference& reference, double duration_s) {
    std::vector<double> values;
    for (int i = 0; i <= std::lround(duration_s / Period_s); ++i) {
        values.push_back(evaluateReference(reference, i * Period_s).value_rad);
    }
    return values;
}

// The second route: the same loop behind the formula of its reference.
TEST(LoopReplay, isTheIdealLoopBehindARecordedReference) {
    const RotorConfig rotor;
    IdealLoopConfig ideal;
    ideal.law = recommendedLaw(rotor, 1.43e-2);
    ideal.reference = {LoopReference::Shape::Step, 1.0, 0, 0, 1, 1};
    ideal.duration_s = 2.0;
    const IdealTrace expected = runIdealLoop(ideal);
    const auto reference = referencePoints(sampled(ideal.reference, 2.0), Period_s);
    LoopReplayConfig config;
    config.law = ideal.law;
    config.reference = reference;
    config.rows = expected.time_s.size();
    const LoopReplay replay = replayLoop(config);
    EXPECT_EQ(replay.angle_rad, expected.angle_rad); // bit for bit: a step has no speed either way
    EXPECT_EQ(replay.current_A, expected.current_A);
}

// Periods between the rows: the same instants of the loop, seen at the rows that both have.
TEST(LoopReplay, computesAtTheLoopsOwnInstantsBetweenTheRows) {
    for (const double period_s : {1e-4, 4e-4, 5e-4, 1.5e-3, 2.5e-3}) {
        IdealLoopConfig ideal;
        ideal.law = recommendedLaw(ideal.rotor, 1.43e-2);
        ideal.law.period_s = period_s;
        ideal.reference.amplitude_rad = 1.0;
        ideal.duration_s = 1.0;
        const IdealTrace expected = runIdealLoop(ideal);
        const std::vector<ReferencePoint> reference(1, {1.0, 0.0, 0.0});
        LoopReplayConfig config;
        config.law = ideal.law;
        config.reference = reference;
        config.rows = 1001;
        const LoopReplay replay = replayLoop(config);
        std::size_t compared = 0;
        for (std::size_t i = 0; i < expected.time_s.size(); ++i) {
            const double row = 1e3 * expected.time_s[i];
            if (std::fabs(row - std::round(row)) < 1e-6 && row < 1000.5) {
                // The same closed forms over other stretches: rounding of a thousand of them.
                ASSERT_NEAR(replay.angle_rad[static_cast<std::size_t>(std::lround(row))],
                            expected.angle_rad[i], 1e-9)
                    << period_s << " s, row " << row;
                ++compared;
            }
        }
        EXPECT_GT(compared, 200U) << period_s;
    }
}

// Steady, the integral takes all of a constant disturbance: u = -d, within what friction hides.
TEST(LoopReplay, theLoopAnswersADisturbance) {
    const std::vector<ReferencePoint> reference(2);
    const std::vector<double> disturbance_A(4000, 0.5);
    LoopReplayConfig config;
    config.rotor.coulombFriction_Nm = 0.0;
    config.law = recommendedLaw(config.rotor, 1.43e-2);
    config.reference = reference;
    config.rows = disturbance_A.size();
    EXPECT_EQ(replayLoop(config).angle_rad.back(), 0.0);
    config.disturbance_A = disturbance_A;
    const LoopReplay pushed = replayLoop(config);
    EXPECT_NEAR(pushed.current_A.back(), -0.5, 1e-3);
    // At first it yields: half of k d t^2 = 0.5 26 0.5 1e-4 after one period.
    EXPECT_NEAR(pushed.angle_rad[10], 0.5 * 26.0 * 0.5 * 1e-4, 1e-5);
}

TEST(LoopReplay, moreFrictionStopsTheRotorEarlier) {
    const std::vector<ReferencePoint> reference(1, {1.0, 0.0, 0.0});
    LoopReplayConfig config;
    config.reference = reference;
    config.rows = 3000;
    double largest_rad[2] = {};
    for (const int i : {0, 1}) {
        config.friction_ratio = 1.0 + 0.2 * i;
        for (const double angle_rad : replayLoop(config).angle_rad) {
            largest_rad[i] = std::max(largest_rad[i], angle_rad);
        }
    }
    EXPECT_GT(largest_rad[0], largest_rad[1]);
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
} // namespace halbench::models
