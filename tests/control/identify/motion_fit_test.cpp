#include "control/base/distributions.h"
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
    const RecordRatios truth;
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
    const RecordRatios truth;
    RecordMaker maker(truth, {0.0, 0.0, 0.03, 0.02}, 1);
    sweep(maker);
    const auto motion = fitMotion(segmentsOf(maker));
    ASSERT_TRUE(motion);
    EXPECT_EQ(motion->angleOrders, 6);
    // what six orders leave of two nested errors of 0.03 rad is of order 0.03^4 = 1e-6
    EXPECT_NEAR(motion->damping_per_s / truth.damping_per_s, 1.0, 1e-4);
}

TEST(MotionFit, intervalsCoverTheTruthUnderRandomFriction) {
    const RecordRatios truth;
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
    const RecordRatios truth;
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
    const RecordRatios truth;
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

// Segments of a rotor whose torque falls as 1 - loss omega^2, by Runge-Kutta steps of 1 ms.
std::vector<MotionSegment> segmentsWithLoss(double loss_s2, int pairs, std::uint64_t seed) {
    const RecordRatios truth;
    Random random(seed);
    std::vector<MotionSegment> segments;
    double angle = 0.3;
    for (int i = 0; i < 2 * pairs; ++i) {
        const double current = i % 2 == 0 ? 4.0 : 0.0;
        const double friction = truth.friction_rad_s2 * (1.0 + 0.033 * random.gaussian());
        const auto acceleration = [&](double w) {
            return truth.torque_rad_s2_A * current * (1.0 - loss_s2 * w * w) - truth.damping_per_s * w -
                   friction;
        };
        double speed = i % 2 == 0 ? 4.0 : 26.0;
        MotionSegment segment{{}, {}, current, 1};
        for (int tick = 0; speed > 3.0 && tick < 1000; ++tick) {
            if (tick % 10 == 0) {
                segment.time_s.push_back(1e-3 * tick);
                segment.angle_rad.push_back(angle + 7e-4 * random.gaussian());
            }
            const double k1 = acceleration(speed);
            const double k2 = acceleration(speed + 0.5e-3 * k1);
            angle += 1e-3 * (speed + 0.5e-3 * k1);
            speed += 1e-3 * k2;
        }
        segments.push_back(segment);
    }
    return segments;
}

TEST(MotionFit, findsTheLossOfTorqueAtSpeedWhateverWasAssumed) {
    MotionFitConfig config;
    config.torqueLoss_s2 = 3.9e-7;
    config.torqueLossError_s2 = 1e-5; // hardly anything is assumed
    for (const double loss_s2 : {0.0, 3.9e-7, 1.2e-6}) {
        const auto motion = fitMotion(segmentsWithLoss(loss_s2, 24, 5), config);
        ASSERT_TRUE(motion);
        EXPECT_TRUE(motion->isTorqueLossFitted);
        // four standard errors of one draw
        EXPECT_NEAR(motion->torqueLoss_s2, loss_s2, 4.0 * motion->torqueLossError_s2);
        EXPECT_NEAR(motion->damping_per_s, 1.23e-3 / 5.5e-4, 4.0 * motion->dampingError_per_s);
        EXPECT_LT(motion->dampingError_per_s, 2e-3 * motion->damping_per_s);
    }
}

TEST(MotionFit, takesTheErrorOfTheAssumedLossIntoTheDampingWhenItCannotFindIt) {
    MotionFitConfig config;
    config.torqueLoss_s2 = 3.9e-7;
    config.torqueLossError_s2 = 0.0;
    const auto segments = segmentsWithLoss(3.9e-7, 3, 6);
    const auto sure = fitMotion(segments, config);
    config.torqueLossError_s2 = 3.9e-7;
    const auto unsure = fitMotion(segments, config);
    config.torqueLoss_s2 = 0.0;
    const auto without = fitMotion(segments, config);
    ASSERT_TRUE(sure && unsure && without);
    EXPECT_FALSE(unsure->isTorqueLossFitted);
    EXPECT_EQ(unsure->torqueLoss_s2, 3.9e-7);
    // an error of all of the loss is worth all of its correction
    EXPECT_EQ(unsure->dampingError_per_s, sure->dampingError_per_s);
    ASSERT_EQ(unsure->sharedErrors.size(), 1u);
    EXPECT_NEAR(unsure->sharedErrors.front().damping_per_s, sure->damping_per_s - without->damping_per_s,
                1e-9);
    for (std::size_t i = 0; i < sure->balances.size(); ++i) {
        EXPECT_NEAR(unsure->sharedErrors.front().balances_rad_s2[i],
                    sure->balances[i].balance_rad_s2 - without->balances[i].balance_rad_s2, 1e-7);
    }
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
