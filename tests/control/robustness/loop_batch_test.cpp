#include "control/base/units.h"
#include "control/design/design_methods.h"
#include "control/robustness/loop_batch.h"
#include "control/robustness/percentiles.h"
#include "control/robustness/robustness.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace halbench::control {
namespace {

/// Motors around the published one; with much uncertainty some are no motor or have no damping.
std::vector<PositionPlant> motors(double deviation_ratio) {
    UncertainPlant uncertain;
    uncertain.mean = Eigen::Vector3d(2.2363636, 26.0, 1.4336);
    uncertain.covariance = (deviation_ratio * uncertain.mean).cwiseAbs2().asDiagonal();
    uncertain.toPlant = [](const Eigen::VectorXd& p) { return PositionPlant{p(0), p(1), p(2)}; };
    return *drawPlants(uncertain, 1000, Random(5));
}

PidGains gainsOf(double proportional, double integral, double derivative) {
    PidGains gains;
    gains.proportional = proportional;
    gains.integral = integral;
    gains.derivative = derivative;
    return gains;
}

// The plain route: one loop after the other, by its transfer function.
TEST(LoopBatch, everyLaneIsItsOwnOpenLoop) {
    const auto plants = motors(0.1);
    for (const int delay_samples : {0, 2}) {
        const LoopTiming timing{0.01, delay_samples};
        const PidGains gains = gainsOf(40.0, 60.0, 1.4);
        const auto batch = LoopBatch::make(plants, gains, timing);
        ASSERT_TRUE(batch.has_value());
        Eigen::ArrayXd real;
        Eigen::ArrayXd imaginary;
        for (const double frequency_rad_s : {5.0, 45.0, 300.0}) {
            batch->rest(frequency_rad_s, real, imaginary);
            for (std::size_t lane = 0; lane < batch->size(); lane += 100) {
                const auto expected =
                    sampledOpenLoop(batch->plant(lane), gains, timing)->atFrequency(frequency_rad_s);
                const auto i = static_cast<Eigen::Index>(lane);
                // The multiplied polynomials lose digits near z = 1; the batch does not.
                EXPECT_LT(std::abs(batch->loop(lane, frequency_rad_s) / expected - 1.0), 1e-9);
                EXPECT_LT(std::abs(batch->rest(lane, frequency_rad_s) /
                                       std::complex<double>(real[i], imaginary[i]) -
                                   1.0),
                          1e-13);
            }
        }
    }
}

struct Case {
    const char* name;
    double deviation_ratio;
    PidGains gains;
    int delay_samples;
};

class BatchVerdicts : public testing::TestWithParam<Case> {};

TEST_P(BatchVerdicts, areThoseOfTheLoopsOneByOne) {
    const LoopTiming timing{0.01, GetParam().delay_samples};
    const auto batch = LoopBatch::make(motors(GetParam().deviation_ratio), GetParam().gains, timing);
    ASSERT_TRUE(batch.has_value());
    const auto verdicts = judgeBatch(*batch);
    ASSERT_EQ(verdicts.size(), batch->size());
    for (std::size_t lane = 0; lane < batch->size(); ++lane) {
        const auto loop = sampledOpenLoop(batch->plant(lane), GetParam().gains, timing);
        const StabilityMargins expected = smallestMargins(*loop);
        const StabilityMargins& margins = verdicts[lane].margins;
        ASSERT_EQ(verdicts[lane].isStable, poleRadius(*loop) < 1.0) << lane;
        ASSERT_EQ(margins.gainCrossover_rad_s.has_value(), expected.gainCrossover_rad_s.has_value()) << lane;
        ASSERT_EQ(margins.phaseCrossover_rad_s.has_value(), expected.phaseCrossover_rad_s.has_value())
            << lane;
        // Both narrow a crossing down to rounding of the loop, which keeps some ten digits.
        if (expected.phaseCrossover_rad_s) {
            ASSERT_NEAR(margins.gainMargin_ratio / expected.gainMargin_ratio, 1.0, 1e-8) << lane;
        }
        if (expected.gainCrossover_rad_s) {
            ASSERT_NEAR(*margins.gainCrossover_rad_s / *expected.gainCrossover_rad_s, 1.0, 1e-9) << lane;
            ASSERT_NEAR(margins.phaseMargin_deg, expected.phaseMargin_deg, 1e-7) << lane;
            ASSERT_NEAR(margins.delayMargin_s, expected.delayMargin_s, 1e-9) << lane;
        }
        // Parabola and golden section find the same minimum; where it is nearly zero its root knows less.
        ASSERT_NEAR(margins.modulusMargin, expected.modulusMargin, 1e-6) << lane;
    }
}

INSTANTIATE_TEST_SUITE_P(Motors, BatchVerdicts,
                         testing::Values(Case{"recommended", 0.02, gainsOf(40.0, 60.0, 1.4), 0},
                                         Case{"uncertain", 0.4, gainsOf(40.0, 60.0, 1.4), 0},
                                         Case{"delayed", 0.2, gainsOf(12.03, 9.896, 0.4857), 1},
                                         Case{"delayedTwice", 0.2, gainsOf(5.572, 3.119, 0.3092), 2},
                                         Case{"published", 0.1, gainsOf(10.0, 0.1, 0.0), 0},
                                         Case{"atTheLimit", 0.1, gainsOf(17.27, 0.0, 0.0), 0},
                                         Case{"nearTheLimit", 0.02, gainsOf(16.9, 0.05, 0.0), 0},
                                         Case{"fast", 0.1, gainsOf(45.0, 100.0, 3.5), 0},
                                         Case{"proportional", 0.1, gainsOf(3.0, 0.0, 0.0), 1},
                                         Case{"unstable", 0.1, gainsOf(150.0, 10.0, 1.4), 0},
                                         Case{"integral", 0.1, gainsOf(8.0, 30.0, 0.5), 0}),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(LoopBatch, whatIsNoMotorHasNoLaneAndAMotorWithoutDampingHasOne) {
    const std::vector<PositionPlant> plants = {
        {2.0, -1.0, 0.0}, {2.0, 26.0, 0.0}, {0.0, 26.0, 0.0}, {NAN, 26.0, 0.0}};
    const auto batch = LoopBatch::make(plants, gainsOf(40.0, 60.0, 1.4), NoDelay);
    ASSERT_TRUE(batch.has_value());
    EXPECT_EQ(batch->plantOfLane(), (std::vector<std::size_t>{1, 2}));
    const auto verdicts = judgeBatch(*batch);
    EXPECT_TRUE(verdicts[0].isStable);
    EXPECT_TRUE(verdicts[1].isStable);
    // P alone on a motor without damping is never stable; with the motor of the first lane it is.
    const auto proportional = judgeBatch(*LoopBatch::make(plants, gainsOf(5.0, 0.0, 0.0), NoDelay));
    EXPECT_TRUE(proportional[0].isStable);
    EXPECT_FALSE(proportional[1].isStable);
    EXPECT_EQ(LoopBatch::make({{2.0, -1.0, 0.0}}, {}, NoDelay).error().code, ErrorCode::Refused);
}

TEST(Percentiles, areThoseOfTheNearestRank) {
    Eigen::ArrayXd values = Eigen::ArrayXd::LinSpaced(100, 100.0, 1.0);
    const MiddleNineTenths middle = middleNineTenths(values);
    EXPECT_DOUBLE_EQ(middle.p5, 5.0);
    EXPECT_DOUBLE_EQ(middle.p95, 95.0);
    Eigen::ArrayXd one = Eigen::ArrayXd::Constant(1, 3.0);
    EXPECT_DOUBLE_EQ(middleNineTenths(one).p95, 3.0);
    values = HUGE_VAL; // margins without a crossing
    values[7] = 2.0;
    EXPECT_EQ(middleNineTenths(values).p95, HUGE_VAL);
}

} // namespace
} // namespace halbench::control
