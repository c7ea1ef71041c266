#include "models/spherical/additive_inverse.h"
#include "models/spherical/orientation_estimator.h"
#include "models/spherical/rotor_motion.h"
#include "models/spherical/swarm_estimator.h"
#include "tests/models/spherical/orientation_cases.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

OrientationAngles publishedAngles(int trajectory, int sample, double spin_deg) {
    return anglesForShaft(publishedShaft(trajectory, sample), degreesToRadians(spin_deg));
}

TEST(PublishedTrajectories, leaveTheWorkspaceInTheKnownSamples) {
    const std::array<int, 4> known = {10, 10, 0, 9};
    for (int trajectory = 1; trajectory <= 4; ++trajectory) {
        int outside = 0;
        for (int k = 1; k <= PublishedSamples; ++k) {
            outside += !isInWorkspace(publishedAngles(trajectory, k, 0.0));
        }
        EXPECT_EQ(outside, known[static_cast<std::size_t>(trajectory - 1)]) << trajectory;
    }
}

TEST(PublishedTrajectories, linearAndClosedSolversFindEverySample) {
    const SphericalSensing sensing;
    const RotorField field(sensing.field);
    OrientationConfig config;
    config.method = OrientationMethod::Tensor;
    const OrientationEstimator estimator = *OrientationEstimator::make(sensing, config);
    for (int trajectory = 1; trajectory <= 4; ++trajectory) {
        for (int k = 1; k <= PublishedSamples; ++k) {
            for (const double spin_deg : {0.0, 20.0}) {
                const OrientationAngles angles = publishedAngles(trajectory, k, spin_deg);
                const Eigen::Matrix3d truth = rotationOf(angles);
                double strength_T = 0.0;
                const Eigen::Matrix3d found =
                    estimator.solve(field.readings_T(truth, sensing.poses), strength_T);
                EXPECT_LT(radiansToDegrees(symmetricError_rad(found, truth)), 1e-12);
                const OrientationAngles closed = additiveInverse(Q, additiveReadings_T({}, angles));
                EXPECT_LT(radiansToDegrees(symmetricError_rad(rotationOf(closed), truth)), 1e-12);
            }
        }
    }
}

/// Share of the samples inside the workspace whose shaft the swarm finds within 0.1 degrees; readings and
/// model additive.
double swarmShare(int trajectory, double spin_deg) {
    constexpr int Runs = 40;
    const AngleModel model = angleModel(AdditiveModel{});
    Random random(61);
    int right = 0;
    int inside = 0;
    for (int run = 0; run < Runs; ++run) {
        for (int k = 1; k <= PublishedSamples; ++k) {
            const OrientationAngles angles = publishedAngles(trajectory, k, spin_deg);
            if (!isInWorkspace(angles)) {
                continue;
            }
            ++inside;
            const SwarmEstimate found = estimateBySwarm(model, {}, additiveReadings_T({}, angles), random);
            const Eigen::Vector3d shaft = rotationOf(found.angles).col(2);
            right += shaft.cross(rotationOf(angles).col(2)).norm() < degreesToRadians(0.1) && shaft.z() > 0.0;
        }
    }
    return static_cast<double>(right) / inside;
}

TEST(PublishedTrajectories, swarmLosesTheSingularOnes) {
    // Section 9 of resources/help/spherical-theory.md, 5 points.
    const std::array<double, 4> home = {0.90, 0.06, 0.86, 0.80};
    const std::array<double, 4> spun = {1.00, 1.00, 0.96, 0.98};
    for (int trajectory = 1; trajectory <= 4; ++trajectory) {
        const auto i = static_cast<std::size_t>(trajectory - 1);
        EXPECT_NEAR(swarmShare(trajectory, 0.0), home[i], 0.05) << trajectory;
        EXPECT_NEAR(swarmShare(trajectory, 20.0), spun[i], 0.05) << trajectory;
    }
}

TEST(PublishedTrajectories, harmonicsOfThirdOneAreRemovedByPasses) {
    SphericalSensing unaware;
    SphericalSensing aware;
    aware.field.harmonics = harmonicPreset(HarmonicPreset::H1);
    OrientationConfig config;
    config.method = OrientationMethod::Tensor;
    const OrientationEstimator before = *OrientationEstimator::make(unaware, config);
    config.harmonicPasses = 4;
    const OrientationEstimator after = *OrientationEstimator::make(aware, config);
    const RotorField field(aware.field);
    RootMeanSquare error;
    for (int k = 1; k <= PublishedSamples; ++k) {
        const Eigen::Matrix3d truth = rotationOf(publishedAngles(3, k, 0.0));
        const SphericalReadings readings_T = field.readings_T(truth, aware.poses);
        double strength_T = 0.0;
        const double off_deg =
            radiansToDegrees(symmetricError_rad(before.solve(readings_T, strength_T), truth));
        error.add(off_deg);
        EXPECT_LT(off_deg, 1.15); // 1.10 is the worst of the workspace
        EXPECT_LT(radiansToDegrees(symmetricError_rad(after.solve(readings_T, strength_T), truth)), 1e-4);
    }
    EXPECT_GT(error.value(), 0.1);
}

TEST(RotorMotion, setPointIsReachedAtItsRate) {
    RotorMotionConfig config;
    config.rate_rad_s = 0.5;
    RotorMotion motion(config, 1);
    const OrientationAngles target = angles_deg(20, -30, 50);
    motion.turnTo(target, config.rate_rad_s);
    const double way_rad = vectorOfRotation(rotationOf(target)).norm();
    const double needed_s = way_rad / 0.5;
    while (motion.time_s() < needed_s - 2e-3) {
        motion.advance(1e-3);
        EXPECT_NEAR(motion.rate_rad_s().norm(), 0.5, 1e-9);
    }
    EXPECT_GT(symmetricError_rad(motion.rotation(), rotationOf(target)), 1e-5);
    motion.advance(4e-3);
    EXPECT_LT(symmetricError_rad(motion.rotation(), rotationOf(target)), 1e-12);
    motion.advance(1e-3);
    EXPECT_EQ(motion.rate_rad_s().norm(), 0.0);
}

TEST(RotorMotion, aSetPointEndsAnotherMotionWithoutAJump) {
    RotorMotionConfig config;
    config.kind = MotionKind::Tumble;
    RotorMotion motion(config, 1);
    motion.advance(0.7);
    const OrientationAngles target = angles_deg(-15, 25, 70);
    motion.turnTo(target, 0.25);
    for (int i = 0; i < 100; ++i) {
        motion.advance(1e-3);
        EXPECT_NEAR(motion.rate_rad_s().norm(), 0.25, 1e-9);
    }
    motion.advance(4.0 * Pi / 0.25); // more than any way needs
    EXPECT_LT(symmetricError_rad(motion.rotation(), rotationOf(target)), 1e-12);
}

TEST(RotorMotion, publishedOnesPassTheirSamplesWithoutJumps) {
    for (int trajectory = 1; trajectory <= 4; ++trajectory) {
        RotorMotionConfig config;
        config.kind = static_cast<MotionKind>(static_cast<int>(MotionKind::Published1) + trajectory - 1);
        config.sampleTime_s = 0.1;
        config.spin_rad = degreesToRadians(20);
        RotorMotion motion(config, 1);
        for (int k = 1; k <= PublishedSamples; ++k) {
            const Eigen::Matrix3d expected = rotationOf(publishedAngles(trajectory, k, 20.0));
            EXPECT_LT((motion.rotation() - expected).norm(), 1e-9) << trajectory << " " << k;
            for (int i = 0; i < 10; ++i) {
                motion.advance(0.01);
            }
        }
        for (int i = 0; i < 400; ++i) {
            motion.advance(0.01);
            // 3 and 12 degrees a sample; the spin follows the shaft's turn by less than four times that.
            EXPECT_LT(motion.rate_rad_s().norm(), degreesToRadians(5.0 * 120.0));
        }
    }
}

TEST(RotorMotion, tumblingAndWalkingStayWithinTheTilt) {
    RotorMotionConfig config;
    config.kind = MotionKind::RandomWalk;
    config.tilt_rad = degreesToRadians(30);
    RotorMotion walk(config, 7);
    RotorMotion same(config, 7);
    RotorMotion other(config, 8);
    double square = 0.0;
    constexpr int Steps = 20000;
    for (int i = 0; i < Steps; ++i) {
        const Eigen::Matrix3d before = walk.rotation();
        walk.advance(0.01);
        same.advance(0.01);
        other.advance(0.01);
        ASSERT_EQ(walk.rotation(), same.rotation());
        EXPECT_LT(shaftOf(walk.rotation()).theta_rad, degreesToRadians(30) + 1e-9);
        square += std::pow(vectorOfRotation(walk.rotation() * before.transpose()).norm(), 2) / Steps;
        EXPECT_NEAR(walk.rotation().determinant(), 1.0, 1e-12);
    }
    EXPECT_NE(walk.rotation(), other.rotation());
    // Three axes of 0.5 sqrt(0.01) rad; less what the border refuses.
    EXPECT_LT(square, 3.0 * 0.0025 * 1.03);
    EXPECT_GT(square, 3.0 * 0.0025 * 0.8);
    config.kind = MotionKind::Tumble;
    RotorMotion tumble(config, 1);
    double largest_rad = 0.0;
    for (int i = 0; i < 3000; ++i) {
        tumble.advance(0.01);
        largest_rad = std::max(largest_rad, std::abs(anglesOf(tumble.rotation()).alpha_rad));
    }
    EXPECT_NEAR(radiansToDegrees(largest_rad), 30.0, 0.1);
}

TEST(RotorMotion, tableIsFollowedOnTheShortestWay) {
    RotorMotionConfig config;
    config.kind = MotionKind::Table;
    config.table = {{1.0, angles_deg(0, 0, 10)}, {2.0, angles_deg(0, 0, 50)}, {4.0, angles_deg(0, 30, 50)}};
    RotorMotion motion(config, 1);
    EXPECT_LT((motion.rotation() - rotationOf(angles_deg(0, 0, 10))).norm(), 1e-14);
    motion.advance(1.25);
    EXPECT_LT((motion.rotation() - rotationOf(angles_deg(0, 0, 20))).norm(), 1e-14);
    motion.advance(9.0);
    EXPECT_LT((motion.rotation() - rotationOf(angles_deg(0, 30, 50))).norm(), 1e-14);
    config.table[1].time_s = 1.0;
    EXPECT_EQ(checkRotorMotion(config).error().code, ErrorCode::OutOfRange);
    config.table[1].time_s = std::nan("");
    EXPECT_EQ(checkRotorMotion(config).error().code, ErrorCode::NotFinite);
    config.table.clear();
    EXPECT_EQ(checkRotorMotion(config).error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::models
