#include "control/assess/loop_replay.h"
#include "models/htm/htm_ideal_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

constexpr double Period_s = 0.01;
constexpr double Torque_Nm_per_A = 1.43e-2;

std::vector<double> sampled(const control::LoopReference& reference, double duration_s) {
    std::vector<double> values;
    for (int i = 0; i <= std::lround(duration_s / Period_s); ++i) {
        values.push_back(control::evaluateReference(reference, i * Period_s).value_rad);
    }
    return values;
}

// The second route: the same loop behind the formula of its reference.
TEST(RotorAtRest, isTheIdealLoopBehindARecordedReference) {
    const RotorConfig rotor;
    IdealLoopConfig ideal;
    ideal.law = recommendedLaw(rotor, Torque_Nm_per_A);
    ideal.reference = {control::LoopReference::Shape::Step, 1.0, 0, 0, 1, 1};
    ideal.duration_s = 2.0;
    const IdealTrace expected = runIdealLoop(ideal);
    const auto reference = control::referencePoints(sampled(ideal.reference, 2.0), Period_s);
    control::LoopReplayConfig config;
    config.law = ideal.law;
    config.reference = reference;
    config.rows = expected.time_s.size();
    const control::LoopReplay replay = replayLoop(config, rotorAtRest(rotor, Torque_Nm_per_A));
    EXPECT_EQ(replay.angle_rad, expected.angle_rad); // bit for bit: a step has no speed either way
    EXPECT_EQ(replay.current_A, expected.current_A);
}

// Periods between the rows: the same instants of the loop, seen at the rows that both have.
TEST(RotorAtRest, computesAtTheLoopsOwnInstantsBetweenTheRows) {
    for (const double period_s : {1e-4, 4e-4, 5e-4, 1.5e-3, 2.5e-3}) {
        IdealLoopConfig ideal;
        ideal.law = recommendedLaw(ideal.rotor, Torque_Nm_per_A);
        ideal.law.period_s = period_s;
        ideal.reference.amplitude_rad = 1.0;
        ideal.duration_s = 1.0;
        const IdealTrace expected = runIdealLoop(ideal);
        const std::vector<control::ReferencePoint> reference(1, {1.0, 0.0, 0.0});
        control::LoopReplayConfig config;
        config.law = ideal.law;
        config.reference = reference;
        config.rows = 1001;
        const control::LoopReplay replay =
            control::replayLoop(config, rotorAtRest(ideal.rotor, Torque_Nm_per_A));
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
TEST(RotorAtRest, theLoopAnswersADisturbance) {
    const std::vector<control::ReferencePoint> reference(2);
    const std::vector<double> disturbance_A(4000, 0.5);
    RotorConfig rotor;
    rotor.coulombFriction_Nm = 0.0;
    control::LoopReplayConfig config;
    config.law = recommendedLaw(rotor, Torque_Nm_per_A);
    config.reference = reference;
    config.rows = disturbance_A.size();
    EXPECT_EQ(replayLoop(config, rotorAtRest(rotor, Torque_Nm_per_A)).angle_rad.back(), 0.0);
    config.disturbance_A = disturbance_A;
    const control::LoopReplay pushed = replayLoop(config, rotorAtRest(rotor, Torque_Nm_per_A));
    EXPECT_NEAR(pushed.current_A.back(), -0.5, 1e-3);
    // At first it yields: half of k d t^2 = 0.5 26 0.5 1e-4 after one period.
    EXPECT_NEAR(pushed.angle_rad[10], 0.5 * 26.0 * 0.5 * 1e-4, 1e-5);
}

TEST(RotorAtRest, moreFrictionStopsTheRotorEarlier) {
    const std::vector<control::ReferencePoint> reference(1, {1.0, 0.0, 0.0});
    control::LoopReplayConfig config;
    config.reference = reference;
    config.rows = 3000;
    double largest_rad[2] = {};
    for (const int i : {0, 1}) {
        const auto rotor = rotorAtRest(RotorConfig{}, Torque_Nm_per_A, 1.0 + 0.2 * i);
        for (const double angle_rad : replayLoop(config, rotor).angle_rad) {
            largest_rad[i] = std::max(largest_rad[i], angle_rad);
        }
    }
    EXPECT_GT(largest_rad[0], largest_rad[1]);
}

} // namespace
} // namespace halbench::models
