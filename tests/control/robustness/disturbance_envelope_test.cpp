#include "control/assess/load_step.h"
#include "control/robustness/batch_simulation.h"
#include "control/robustness/disturbance_envelope.h"
#include "control/robustness/percentiles.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

constexpr LoopTiming OneLate{0.01, 1};

std::vector<PositionPlant> motors(double deviation_ratio, int count = 1000) {
    UncertainPlant uncertain;
    uncertain.mean = Eigen::Vector3d(1.23e-3 / 5.5e-4, 26.0, 1.434);
    uncertain.covariance = Eigen::Vector3d(0.01, std::pow(26.0 * deviation_ratio, 2), 0.0).asDiagonal();
    uncertain.toPlant = [](const Eigen::VectorXd& p) { return PositionPlant{p(0), p(1), p(2)}; };
    return *drawPlants(uncertain, count, Random(1));
}

MiddleNineTenths middle(const std::vector<double>& values) {
    Eigen::ArrayXd sorted =
        Eigen::Map<const Eigen::ArrayXd>(values.data(), static_cast<Eigen::Index>(values.size()));
    return middleNineTenths(sorted);
}

// Second route: every motor under load on its own. Both are exact, so that only rounding is left.
TEST(DisturbanceEnvelope, holdsNineTenthsOfTheMotorsAndOfTheirPeaksAndRecoveries) {
    constexpr double Load_A = 0.5;
    constexpr double Rounding = 1e-9;
    for (const LoopTiming timing : {LoopTiming{0.01, 0}, OneLate}) {
        const auto drawn = motors(0.1);
        const auto band = disturbanceEnvelope(drawn, recommended(), timing, Load_A, 4.0, 5);
        ASSERT_TRUE(band) << band.error().message;
        ASSERT_EQ(band->time_s.size(), 2001U);
        std::vector<double> peaks, recoveries;
        std::vector<std::vector<double>> angles(2001);
        for (const PositionPlant& plant : drawn) {
            const auto step = loadStep(plant, recommended(), timing, Load_A, 4.0, 5);
            ASSERT_TRUE(step);
            peaks.push_back(step->peak_rad);
            recoveries.push_back(step->recoveryTime_s.value_or(std::numeric_limits<double>::infinity()));
            for (std::size_t i = 0; i < angles.size(); ++i) {
                angles[i].push_back(step->angle_rad[i]);
            }
        }
        for (const std::size_t i : {0U, 7U, 50U, 133U, 2000U}) {
            EXPECT_NEAR(band->angle_rad.p5[i], middle(angles[i]).p5, Rounding);
            EXPECT_NEAR(band->angle_rad.p95[i], middle(angles[i]).p95, Rounding);
        }
        EXPECT_NEAR(band->peak_rad.p5, middle(peaks).p5, Rounding);
        EXPECT_NEAR(band->peak_rad.p95, middle(peaks).p95, Rounding);
        ASSERT_TRUE(band->recoveryTime_s);
        EXPECT_NEAR(band->recoveryTime_s->p95, middle(recoveries).p95, Rounding);
        EXPECT_LT(band->peak_rad.p5, band->peak_rad.p95);
    }
}

// Without integral action the load stays: load/K_P, whatever the motor.
TEST(DisturbanceEnvelope, aStiffnessAloneHoldsEveryMotorAtTheSameAngleInTheEnd) {
    PidGains gains = recommended();
    gains.integral = 0.0;
    const auto band = disturbanceEnvelope(motors(0.1), gains, OneLate, 0.5, 5.0, 1);
    ASSERT_TRUE(band);
    EXPECT_NEAR(band->angle_rad.p5.back(), 0.5 / 40.0, 1e-9);
    EXPECT_NEAR(band->angle_rad.p95.back(), 0.5 / 40.0, 1e-9);
}

TEST(DisturbanceEnvelope, aRecoveryThatIsNotSeenIsNotKnown) {
    const auto band = disturbanceEnvelope(motors(0.1), recommended(), OneLate, 0.5, 0.05, 1);
    ASSERT_TRUE(band);
    EXPECT_FALSE(band->recoveryTime_s);
}

TEST(DisturbanceEnvelope, someOfThePointsAreTheSamePoints) {
    const auto all = disturbanceEnvelope(motors(0.1), recommended(), OneLate, 0.5, 1.0, 5);
    const auto some = disturbanceEnvelope(motors(0.1), recommended(), OneLate, 0.5, 1.0, 5, 90);
    ASSERT_TRUE(all && some);
    EXPECT_LE(some->time_s.size(), 90U);
    EXPECT_EQ(some->time_s.back(), all->time_s.back());
    for (std::size_t i = 0; i < some->time_s.size(); ++i) {
        const auto at = std::find(all->time_s.begin(), all->time_s.end(), some->time_s[i]);
        ASSERT_NE(at, all->time_s.end());
        EXPECT_EQ(some->angle_rad.p5[i],
                  all->angle_rad.p5[static_cast<std::size_t>(at - all->time_s.begin())]);
    }
    EXPECT_EQ(some->peak_rad.p95, all->peak_rad.p95);
}

struct SingleLoads {
    MiddleNineTenths peak_rad;
    MiddleNineTenths recovery_s;
};

/// Second route: 0.5 A on every motor alone for 60 s, seen at every sample.
SingleLoads aloneFor60s(const std::vector<PositionPlant>& drawn, const PidGains& gains,
                        const LoopTiming& timing) {
    std::vector<double> peaks, recoveries;
    for (const PositionPlant& plant : drawn) {
        const auto step = loadStep(plant, gains, timing, 0.5, 60.0, 1);
        EXPECT_TRUE(step && step->recoveryTime_s);
        peaks.push_back(step->peak_rad);
        recoveries.push_back(step->recoveryTime_s.value_or(0.0));
    }
    EXPECT_GT(middle(recoveries).p5, 11.0) << "beyond the points that are all measured";
    return {middle(peaks), middle(recoveries)};
}

// A loop of 60 000 samples is measured at points 0.5 % apart: a recovery is so exact, a smooth peak more.
TEST(DisturbanceEnvelope, aSlowLoopsPeaksAndRecoveriesAreThoseOfItsMotors) {
    PidGains slow = recommended();
    slow.proportional *= 0.02;
    slow.integral *= 1.6e-3;
    slow.derivative *= 0.1;
    const LoopTiming timing{0.001, 0};
    auto drawn = motors(0.1);
    drawn.resize(20);
    const auto band = disturbanceEnvelope(drawn, slow, timing, 0.5, 60.0, 1, 90);
    ASSERT_TRUE(band) << band.error().message;
    const SingleLoads alone = aloneFor60s(drawn, slow, timing);
    EXPECT_NEAR(band->peak_rad.p5, alone.peak_rad.p5, 1e-5 * alone.peak_rad.p5);
    EXPECT_NEAR(band->peak_rad.p95, alone.peak_rad.p95, 1e-5 * alone.peak_rad.p95);
    ASSERT_TRUE(band->recoveryTime_s);
    EXPECT_NEAR(band->recoveryTime_s->p5, alone.recovery_s.p5, 0.005 * alone.recovery_s.p5);
    EXPECT_NEAR(band->recoveryTime_s->p95, alone.recovery_s.p95, 0.005 * alone.recovery_s.p95);
}

// A loop that rings for longer than points are looked at one by one, faster than those that follow are apart:
// every point counts then. Its peak is at the beginning, its recovery far behind.
TEST(DisturbanceEnvelope, aLoopThatRingsForLongIsMeasuredAtEveryPoint) {
    auto drawn = motors(0.02);
    drawn.resize(20);
    const LoopTiming timing{0.001, 0};
    PidGains gains;
    gains.proportional = 40.0;
    gains.derivative = 0.5 * timing.period_s * gains.proportional; // makes up for the held half of a sample
    for (PositionPlant& plant : drawn) {
        plant.dampingRate_1_s = 0.2; // the swing falls by exp(-0.1 t): to a fifth in 16 s
    }
    const auto band = disturbanceEnvelope(drawn, gains, timing, 0.5, 60.0, 1, 90);
    ASSERT_TRUE(band) << band.error().message;
    const SingleLoads alone = aloneFor60s(drawn, gains, timing);
    EXPECT_NEAR(band->peak_rad.p95, alone.peak_rad.p95, 1e-12);
    ASSERT_TRUE(band->recoveryTime_s);
    EXPECT_NEAR(band->recoveryTime_s->p5, alone.recovery_s.p5, 1e-9);
    EXPECT_NEAR(band->recoveryTime_s->p95, alone.recovery_s.p95, 1e-9);
}

// Second route: each motor on its own, whose load moves it as far as its end when it comes from below.
TEST(DisturbanceEnvelope, ofAnOverdampedLoopThePeakIsItsEnd) {
    PidGains gains;
    gains.proportional = 2.0;
    gains.derivative = 2.0;
    const auto drawn = motors(0.05);
    const auto band = disturbanceEnvelope(drawn, gains, {0.01, 0}, 0.5, 5.0, 1);
    ASSERT_TRUE(band) << band.error().message;
    std::vector<double> peaks;
    for (const PositionPlant& plant : drawn) {
        peaks.push_back(loadStep(plant, gains, {0.01, 0}, 0.5, 5.0, 1)->peak_rad);
    }
    EXPECT_NEAR(middle(peaks).p5, 0.25, 1e-12) << "load/K_P";
    EXPECT_NEAR(band->peak_rad.p5, middle(peaks).p5, 1e-12);
    EXPECT_NEAR(band->peak_rad.p95, middle(peaks).p95, 1e-12);
}

TEST(DisturbanceEnvelope, whatIsImpossibleIsRefused) {
    EXPECT_EQ(disturbanceEnvelope(motors(0.1), recommended(), OneLate, 0.0, 1.0).error().code,
              ErrorCode::OutOfRange);
    EXPECT_EQ(disturbanceEnvelope(motors(0.1), recommended(), OneLate, 0.5, -1.0).error().code,
              ErrorCode::OutOfRange);
    EXPECT_EQ(disturbanceEnvelope({}, recommended(), OneLate, 0.5, 1.0).error().code, ErrorCode::Refused);
}

TEST(LaneMotion, ofMorePointsSoManyAreKeptAndTheFirstAndLastAmongThem) {
    EXPECT_EQ(keptPoints(4, 90), (std::vector<std::size_t>{0, 1, 2, 3}));
    const auto kept = keptPoints(1000, 10);
    EXPECT_LE(kept.size(), 10U);
    EXPECT_EQ(kept.front(), 0U);
    EXPECT_EQ(kept.back(), 999U);
}

// However few values may be held at once: the same steps, the same motors, the same numbers. Every third
// motor is so strong that its loop leaves all numbers on the way; none of its angles counts, from the first
// on.
TEST(LaneMotion, computedInPartsABandIsTheSameToItsLastBit) {
    const auto limit = proportionalLimit_A_per_rad(published(), OneLate, 0.0);
    PidGains gains;
    gains.proportional = 0.4 * limit;
    std::vector<PositionPlant> plants = motors(0.1);
    for (std::size_t i = 0; i < plants.size(); i += 3) {
        plants[i].accelerationGain_rad_s2_A *= 60.0;
    }
    const auto batch = LoopBatch::make(plants, gains, OneLate);
    ASSERT_TRUE(batch);
    const BatchRun run{1.0, 0.3, 2, keptPoints(12001, 12001)};
    const auto whole = middleOfLanes(*batch, run, 12001 * batch->size());
    ASSERT_TRUE(whole);
    BatchCurves end(static_cast<Eigen::Index>(batch->size()), 1);
    for (std::size_t first = 0; first < batch->size(); first += LaneWidth) {
        runBatch(*batch, first, {1.0, 0.3, 2, {12000}}, end, first);
    }
    EXPECT_EQ(finiteLanes(end).size(), 666U);
    for (const std::size_t mostValues : {std::size_t(3000000), std::size_t(700001), std::size_t(1)}) {
        const auto parts = middleOfLanes(*batch, run, mostValues);
        ASSERT_TRUE(parts);
        EXPECT_EQ(parts->p5, whole->p5) << mostValues;
        EXPECT_EQ(parts->p95, whole->p95) << mostValues;
    }
}

// More points than are held at once.
TEST(DisturbanceEnvelope, ofManyPointsIsThatOfTheSamePointsAlone) {
    const auto many = disturbanceEnvelope(motors(0.1), recommended(), OneLate, 0.5, 60.0, 1);
    const auto few = disturbanceEnvelope(motors(0.1), recommended(), OneLate, 0.5, 60.0, 1, 300);
    ASSERT_TRUE(many && few);
    EXPECT_GT(many->time_s.size() * 1000, MostLaneValues);
    for (std::size_t i = 0; i < few->time_s.size(); ++i) {
        const auto at = static_cast<std::size_t>(std::lround(few->time_s[i] / OneLate.period_s));
        EXPECT_EQ(few->angle_rad.p5[i], many->angle_rad.p5[at]);
        EXPECT_EQ(few->angle_rad.p95[i], many->angle_rad.p95[at]);
    }
    EXPECT_EQ(few->peak_rad.p5, many->peak_rad.p5);
}

} // namespace
} // namespace halbench::control
