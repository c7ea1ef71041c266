#include "control/assess/friction_cycles.h"
#include "control/base/random.h"
#include "control/base/units.h"
#include "control/law/sampled_axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

namespace halbench::control {
namespace {

constexpr LoopTiming NoDelay{0.01, 0};
constexpr double Limit_A = 4.0;

PositionPlant published(double frictionShare = 1.0) {
    return {1.23e-3 / 5.5e-4, 1.43e-2 / 5.5e-4, frictionShare * 2.05e-2 / 1.43e-2};
}

PidGains gains(double kp, double ki, double kd = 0.0) {
    PidGains result;
    result.proportional = kp;
    result.integral = ki;
    result.derivative = kd;
    return result;
}

/// The rotor with friction over an interval of constant current, event by event (help: htm-theory.md 3.1).
RotorState moved(const PositionPlant& plant, RotorState state, double current_A, double time_s) {
    const double a = plant.dampingRate_1_s;
    while (time_s > 0.0) {
        if (state.speed_rad_s == 0.0 && std::abs(current_A) <= plant.breakawayCurrent_A) {
            return state;
        }
        const double sign =
            state.speed_rad_s != 0.0 ? std::copysign(1.0, state.speed_rad_s) : std::copysign(1.0, current_A);
        const double net_A = current_A - sign * plant.breakawayCurrent_A;
        const double limit_rad_s = plant.accelerationGain_rad_s2_A * net_A / a;
        double interval_s = time_s;
        bool stops = false;
        if (state.speed_rad_s != 0.0 && sign * limit_rad_s < 0.0) {
            const double stop_s = std::log((state.speed_rad_s - limit_rad_s) / -limit_rad_s) / a;
            stops = stop_s <= time_s;
            interval_s = std::min(stop_s, time_s);
        }
        state = advance(plant, state, net_A, interval_s);
        state.speed_rad_s = stops ? 0.0 : state.speed_rad_s;
        time_s -= interval_s;
    }
    return state;
}

/// Independent simulation of the loop of help: htm-theory.md 8, ideal: the angle 20 times a sample.
std::vector<double> simulated(const PositionPlant& plant, const PidGains& pid, const LoopTiming& timing,
                              double start_rad, double duration_s) {
    RotorState state{start_rad, 0.0};
    double integral_A = 0.0;
    double last_rad = start_rad;
    std::deque<double> pending_A(static_cast<std::size_t>(timing.delay_samples), 0.0);
    std::vector<double> angle_rad;
    for (int k = 0; k < static_cast<int>(duration_s / timing.period_s); ++k) {
        const double error = -state.angle_rad;
        const double asked_A = pid.proportional * error + integral_A -
                               pid.derivative * (state.angle_rad - last_rad) / timing.period_s;
        last_rad = state.angle_rad;
        const double given_A = std::clamp(asked_A, -Limit_A, Limit_A);
        if (given_A == asked_A || error * asked_A < 0.0) {
            integral_A += timing.period_s * pid.integral * error;
        }
        pending_A.push_back(given_A);
        for (int i = 0; i < 20; ++i) {
            state = moved(plant, state, pending_A.front(), timing.period_s / 20.0);
            angle_rad.push_back(state.angle_rad);
        }
        pending_A.pop_front();
    }
    return angle_rad;
}

struct Swing {
    double peakToPeak_rad = 0.0;
    double frequency_rad_s = 0.0;
};

/// Of the last two seconds.
Swing swingOf(const std::vector<double>& angle_rad, double period_s) {
    const double step_s = period_s / 20.0;
    const std::vector<double> tail(angle_rad.end() - static_cast<std::ptrdiff_t>(2.0 / step_s),
                                   angle_rad.end());
    const auto [low, high] = std::minmax_element(tail.begin(), tail.end());
    const double middle = 0.5 * (*low + *high);
    std::vector<std::size_t> upward;
    for (std::size_t i = 1; i < tail.size(); ++i) {
        if (tail[i - 1] < middle && tail[i] >= middle) {
            upward.push_back(i);
        }
    }
    const double turns = static_cast<double>(upward.size()) - 1.0;
    return {*high - *low,
            turns > 0.0 ? 2.0 * Pi * turns / (static_cast<double>(upward.back() - upward.front()) * step_s)
                        : 0.0};
}

// help: htm-theory.md 6.8: 10 A/deg ends a large step in a cycle of 2.0 deg peak to peak.
TEST(FrictionCycles, ofThePublishedGainPerDegreeAreThoseOfTheTheory) {
    const PidGains perDegree = gains(10.0 * 180.0 / Pi, 0.1);
    const auto cycles = frictionCycles(published(), perDegree, NoDelay, Limit_A);
    ASSERT_TRUE(cycles.has_value());
    ASSERT_EQ(cycles->size(), 2u);
    EXPECT_FALSE((*cycles)[0].isStable);
    EXPECT_TRUE((*cycles)[1].isStable);
    EXPECT_NEAR(radiansToDegrees(2.0 * (*cycles)[1].amplitude), 2.0, 0.2); // 10 %
    const Swing swing = swingOf(simulated(published(), perDegree, NoDelay, -100.0 * Pi / 180.0, 8.0), 0.01);
    EXPECT_NEAR(radiansToDegrees(swing.peakToPeak_rad), 2.0, 0.05);
    EXPECT_NEAR(2.0 * (*cycles)[1].amplitude / swing.peakToPeak_rad, 1.0, 0.1);
    EXPECT_NEAR((*cycles)[1].frequency_rad_s / swing.frequency_rad_s, 1.0, 0.1);
}

// Moderate saturation, with and without delay and derivative action; the rotor with a part of its friction.
TEST(FrictionCycles, areThoseOfAnIndependentSimulation) {
    const struct {
        PidGains pid;
        int delay;
        double frictionShare;
    } cases[] = {{gains(25.0, 0.1), 0, 0.05},
                 {gains(30.0, 0.1), 0, 0.05},
                 {gains(8.0, 0.1), 1, 0.1},
                 {gains(40.0, 60.0, 1.4), 2, 0.2}};
    for (const auto& each : cases) {
        const LoopTiming timing{0.01, each.delay};
        const PositionPlant plant = published(each.frictionShare);
        const auto cycles = frictionCycles(plant, each.pid, timing, Limit_A);
        ASSERT_TRUE(cycles.has_value());
        ASSERT_GE(cycles->size(), 2u) << each.pid.proportional;
        const LimitCycle& cycle = (*cycles)[1];
        const Swing swing = swingOf(simulated(plant, each.pid, timing, -1.7, 20.0), 0.01);
        // 10 %: what the describing function is good for there (friction_cycles.h), and what is asked of it.
        EXPECT_NEAR(2.0 * cycle.amplitude / swing.peakToPeak_rad, 1.0, 0.1) << each.pid.proportional;
        EXPECT_NEAR(cycle.frequency_rad_s / swing.frequency_rad_s, 1.0, 0.1) << each.pid.proportional;
    }
}

// help: htm-theory.md 8.2: the micro-step preset comes to rest from small steps and 8.1 from any; both
// predicted.
// Motors and gains off the published ones. The balance takes a relay that is sampled for a sine: large swings
// come out up to half too small, as 22 recorded ones did by -11 to +46 %; what is said of it has to hold
// that.
TEST(FrictionCyclesSeeds, ofRandomMotorsHoldWithinHalf) {
    Random random(20);
    int seen = 0;
    for (int i = 0; i < 40; ++i) {
        PositionPlant plant;
        plant.dampingRate_1_s = 0.5 * std::pow(20.0, random.uniform());
        plant.accelerationGain_rad_s2_A = 10.0 * std::pow(8.0, random.uniform());
        plant.breakawayCurrent_A = 0.05 * std::pow(20.0, random.uniform());
        const LoopTiming timing{0.01, static_cast<int>(random.below(2))};
        const double limit = (timing.delay_samples == 0 ? 449.0 : 150.0) / plant.accelerationGain_rad_s2_A;
        const PidGains pid = gains(limit * 1.3 * std::pow(15.0, random.uniform()), 0.1);
        const auto cycles = frictionCycles(plant, pid, timing, Limit_A);
        ASSERT_TRUE(cycles.has_value());
        if (cycles->size() < 2u) {
            continue;
        }
        const Swing swing = swingOf(simulated(plant, pid, timing, -1.7, 15.0), 0.01);
        const double ratio = swing.peakToPeak_rad / (2.0 * (*cycles)[1].amplitude);
        EXPECT_NEAR(ratio, 1.0, 0.5) << plant.dampingRate_1_s << ' ' << plant.accelerationGain_rad_s2_A << ' '
                                     << plant.breakawayCurrent_A << ' ' << pid.proportional;
        ++seen;
    }
    EXPECT_GE(seen, 20);
}

TEST(FrictionCycles, aLoopBelowItsLimitHasNone) {
    EXPECT_TRUE(frictionCycles(published(), gains(10.0, 0.1), NoDelay, Limit_A)->empty());
    const Swing swing = swingOf(simulated(published(), gains(10.0, 0.1), NoDelay, -1.7, 8.0), 0.01);
    EXPECT_EQ(swing.peakToPeak_rad, 0.0);
}

// The smaller of the pair is the threshold: from half of it the rotor comes to rest, from twice it grows.
TEST(FrictionCycles, theUnstableOneParts) {
    const PidGains pid = gains(40.0, 0.0);
    const PositionPlant plant = published(0.05);
    const auto cycles = frictionCycles(plant, pid, NoDelay, Limit_A);
    ASSERT_GE(cycles->size(), 2u);
    const double threshold_rad = (*cycles)[0].amplitude;
    const Swing rest = swingOf(simulated(plant, pid, NoDelay, 0.5 * threshold_rad, 8.0), 0.01);
    const Swing cycle = swingOf(simulated(plant, pid, NoDelay, 2.0 * threshold_rad, 20.0), 0.01);
    EXPECT_EQ(rest.peakToPeak_rad, 0.0);
    EXPECT_GT(cycle.peakToPeak_rad, 4.0 * threshold_rad);
}

// Bisected in the simulation: the largest error from which the rotor never moves.
TEST(FrictionBand, isThatOfTheSimulation) {
    for (const double kp : {10.0, 40.0, 286.5}) {
        double stuck_rad = 0.0;
        double free_rad = 1.0;
        for (int i = 0; i < 40; ++i) {
            const double error_rad = 0.5 * (stuck_rad + free_rad);
            const auto angle = simulated(published(), gains(kp, 0.0), NoDelay, -error_rad, 0.05);
            (angle.back() == -error_rad ? stuck_rad : free_rad) = error_rad;
        }
        PositionLaw law;
        law.gains = gains(kp, 0.0);
        EXPECT_NEAR(frictionBand_rad(published(), law), stuck_rad, 1e-9);
    }
}

// The largest resting error at which |K_P e + assist| stays below the breakaway current, found by walking
// outwards: the definition, without the formula.
TEST(FrictionBand, ofALawWithAssistIsTheLargestErrorThatRests) {
    const double breakaway_A = published().breakawayCurrent_A;
    for (const double kp : {5.0, 40.0, 286.5, 800.0}) {
        for (const double share : {0.0, 0.5, 0.9, 1.2}) {
            PositionLaw law;
            law.gains = gains(kp, 60.0, 1.4);
            law.stictionCurrent_A = share * breakaway_A;
            double largest_rad = 0.0;
            constexpr double Step_rad = 1e-6;
            for (double error_rad = 0.0; error_rad < 0.5; error_rad += Step_rad) {
                const bool isAssisted = error_rad > law.stictionThreshold_rad;
                const double asked_A = kp * error_rad + (isAssisted ? law.stictionCurrent_A : 0.0);
                largest_rad = asked_A <= breakaway_A ? error_rad : largest_rad;
            }
            // Two strides of the walk.
            EXPECT_NEAR(frictionBand_rad(published(), law), largest_rad, 2.0 * Step_rad)
                << kp << ' ' << share;
        }
    }
}

// help: htm-theory.md 6.7: with 0.32 deg left the published K_I would need 2567 s (68 s the designed one) to
// build up the breakaway current alone; K_P has 0.0559 A of the 1.4336 A already.
TEST(BreakLoose, takesAsLongAsTheTheorySays) {
    const double error_rad = 0.32 * Pi / 180.0;
    // One unit of the last digit shown.
    EXPECT_NEAR(breakLooseTime_s(published(), gains(0.0, 0.1), error_rad), 2567.0, 1.0);
    EXPECT_NEAR(breakLooseTime_s(published(), gains(0.0, 3.776), error_rad), 68.0, 0.1);
    EXPECT_NEAR(breakLooseTime_s(published(), gains(10.0, 0.1), error_rad), 2567.0 - 100.0, 1.0);
    EXPECT_EQ(breakLooseTime_s(published(), gains(300.0, 0.1), error_rad), 0.0);
    EXPECT_TRUE(std::isinf(breakLooseTime_s(published(), gains(10.0, 0.0), error_rad)));
    // Second route: the sample at which the simulated rotor first moves.
    const auto angle = simulated(published(), gains(10.0, 3.776), NoDelay, -0.1, 3.0);
    const auto first = std::find_if(angle.begin(), angle.end(), [](double x) { return x != -0.1; });
    const double moved_s = 0.01 / 20.0 * static_cast<double>(first - angle.begin());
    EXPECT_NEAR(breakLooseTime_s(published(), gains(10.0, 3.776), 0.1), moved_s, 0.0101); // one sample
}

TEST(FrictionCycles, refusesWhatIsNoLoop) {
    EXPECT_EQ(frictionCycles(published(), gains(1.0, 0.0), NoDelay, 0.0).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(frictionCycles({1.0, 0.0, 0.0}, gains(1.0, 0.0), NoDelay, 1.0).error().code,
              ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control
