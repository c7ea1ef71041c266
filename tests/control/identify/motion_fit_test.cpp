#include "control/identify/distributions.h"
#include "control/identify/motion_fit.h"
#include "tests/control/identify/motion_records.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

void sweep(RecordMaker& maker) {
    for (const double sign : {1.0, -1.0}) {
        for (const double current : {4.0, 2.6, 3.4, 2.2, 3.0, 3.8, 2.4, 0.0}) {
            maker.run(sign * current, current == 0.0 ? 0.7 : 3.0);
        }
        for (int i = 0; i < 5; ++i) {
            maker.run(sign * 4.0, 1.0);
            maker.run(0.0, 0.7);
        }
        maker.reverse();
    }
}

std::vector<MotionSegment> segmentsOf(const RecordMaker& maker) {
    const auto plateaus = findPlateaus(maker.time_s, maker.current_column_A, {}, {});
    EXPECT_TRUE(plateaus);
    return findMotion(maker.time_s, maker.angle_rad, *plateaus, {});
}

TEST(MotionFit, returnsTheTruthOnNoiseFreeData) {
    const MotorRatios truth;
    RecordMaker maker(truth, {}, 1);
    sweep(maker);
    const auto segments = segmentsOf(maker);
    // eight and ten stretches in each direction; the coast-down from 2.4 A is over too soon
    EXPECT_EQ(segments.size(), 34u);
    const auto motion = fitMotion(segments);
    ASSERT_TRUE(motion);
    const auto balance = fitBalance(*motion);
    ASSERT_TRUE(balance && balance->torque_rad_s2_A);
    // property 10 of resources/help/htm-theory.md section 10
    EXPECT_NEAR(motion->damping_per_s / truth.damping_per_s, 1.0, 1e-9);
    EXPECT_NEAR(*balance->torque_rad_s2_A / truth.torque_rad_s2_A, 1.0, 1e-9);
    EXPECT_NEAR(*balance->friction_rad_s2 / truth.friction_rad_s2, 1.0, 1e-9);
    EXPECT_NEAR(*balance->asymmetry, 0.0, 1e-9);
}

TEST(MotionFit, sensorErrorsOfTwoDegreesDoNotBiasTheDamping) {
    const MotorRatios truth;
    RecordMaker maker(truth, {0.0, 0.0, 0.03, 0.02}, 1);
    sweep(maker);
    const auto motion = fitMotion(segmentsOf(maker));
    ASSERT_TRUE(motion);
    EXPECT_EQ(motion->angleOrders, 6);
    // what six orders leave of two nested errors of 0.03 rad is of order 0.03^4 = 1e-6
    EXPECT_NEAR(motion->damping_per_s / truth.damping_per_s, 1.0, 1e-4);
}

TEST(MotionFit, intervalsCoverTheTruthUnderRandomFriction) {
    const MotorRatios truth;
    int damping = 0;
    int friction = 0;
    int torque = 0;
    constexpr int Runs = 120;
    for (int seed = 1; seed <= Runs; ++seed) {
        RecordMaker maker(truth, {0.033, 1e-3, 0.02, 0.015}, static_cast<std::uint64_t>(seed));
        sweep(maker);
        const auto motion = fitMotion(segmentsOf(maker));
        ASSERT_TRUE(motion);
        const auto balance = fitBalance(*motion);
        ASSERT_TRUE(balance && balance->torque_rad_s2_A);
        const Eigen::Matrix3d covariance = balance->scatterCovariance + balance->dampingCovariance;
        const double t = studentQuantile(0.975, balance->freedom);
        const double tDamping = studentQuantile(0.975, motion->dampingFreedom);
        damping +=
            std::fabs(motion->damping_per_s - truth.damping_per_s) <= tDamping * motion->dampingError_per_s;
        friction +=
            std::fabs(*balance->friction_rad_s2 - truth.friction_rad_s2) <= t * std::sqrt(covariance(1, 1));
        torque +=
            std::fabs(*balance->torque_rad_s2_A - truth.torque_rad_s2_A) <= t * std::sqrt(covariance(2, 2));
    }
    // binomial 120 x 0.95: mean 114, sigma 2.4; three sigma below, all is possible above (p = 0.002)
    for (const int covered : {damping, friction, torque}) {
        EXPECT_GE(covered, 107);
    }
}

TEST(MotionFit, runUpsAtOneCurrentGiveTheDampingOnly) {
    const MotorRatios truth;
    RecordMaker maker(truth, {}, 1);
    maker.run(3.0, 4.0);
    const auto motion = fitMotion(segmentsOf(maker));
    ASSERT_TRUE(motion);
    EXPECT_NEAR(motion->damping_per_s / truth.damping_per_s, 1.0, 1e-9);
    const auto balance = fitBalance(*motion);
    ASSERT_FALSE(balance);
    EXPECT_EQ(balance.error().code, ErrorCode::Refused);
}

TEST(MotionFit, coastDownsAloneGiveFrictionButNoTorqueConstant) {
    const MotorRatios truth;
    RecordMaker maker(truth, {}, 1);
    for (int i = 0; i < 3; ++i) {
        maker.run(4.0, 2.0);
        maker.run(0.0, 0.7);
    }
    auto segments = segmentsOf(maker);
    std::erase_if(segments, [](const MotionSegment& segment) { return segment.current_A != 0.0; });
    ASSERT_EQ(segments.size(), 3u);
    const auto motion = fitMotion(segments);
    ASSERT_TRUE(motion);
    const auto balance = fitBalance(*motion);
    ASSERT_TRUE(balance);
    EXPECT_FALSE(balance->torque_rad_s2_A);
    EXPECT_NEAR(*balance->friction_rad_s2 / truth.friction_rad_s2, 1.0, 1e-8);
}

TEST(MotionFit, refusesARecordThatNeverMoves) {
    std::vector<double> time;
    for (int i = 0; i < 500; ++i) {
        time.push_back(i * 0.01);
    }
    const std::vector<double> zero(time.size(), 0.0);
    const auto plateaus = findPlateaus(time, zero, {}, {});
    ASSERT_TRUE(plateaus);
    EXPECT_FALSE(fitMotion(findMotion(time, zero, *plateaus, {})));
}

TEST(MotionSegments, refuseColumnsThatDoNotFit) {
    const std::vector<double> time{0.0, 0.01, 0.01};
    const std::vector<double> current{1.0, 1.0, 1.0};
    EXPECT_FALSE(findPlateaus(time, current, {}, {}));
    EXPECT_FALSE(findPlateaus(std::vector<double>{0.0, 0.01}, current, {}, {}));
    EXPECT_FALSE(findPlateaus(std::vector<double>{0.0, 0.01, NAN}, current, {}, {}));
}

} // namespace
} // namespace halbench::control
