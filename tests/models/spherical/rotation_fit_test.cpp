#include "models/spherical/orientation_estimator.h"
#include "models/spherical/orientation_uncertainty.h"
#include "tests/models/spherical/orientation_cases.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

TEST(RotationFit, everyPoseIsReachedFromTheIdentity) {
    const SphericalSensing sensing;
    const RotorField field(sensing.field);
    const TensorSystem system(sensing);
    Random random(21);
    int iterations = 0;
    for (int i = 0; i < 5000; ++i) {
        const Eigen::Matrix3d truth = anyRotation(random);
        const RotationFit fit =
            fitRotation(field, sensing.poses, system, field.readings_T(truth, sensing.poses),
                        Eigen::Matrix3d::Identity());
        ASSERT_TRUE(fit.hasConverged) << i;
        ASSERT_LT(radiansToDegrees(symmetricError_rad(fit.rotation, truth)), 1e-9) << i;
        iterations += fit.iterations;
    }
    EXPECT_LT(iterations / 5000.0, 12.0); // about 8 is usual
}

struct HarmonicErrors {
    double rms_deg = 0.0;
    double worst_deg = 0.0;
};

HarmonicErrors harmonicErrors(OrientationMethod method, int passes, std::uint64_t seed) {
    SphericalSensing sensing;
    sensing.field.harmonics = harmonicPreset(HarmonicPreset::H1);
    OrientationConfig config;
    config.method = method;
    config.harmonicPasses = passes;
    config.fit.isStrengthFree = false;
    const OrientationEstimator estimator = *OrientationEstimator::make(sensing, config);
    const RotorField field(sensing.field);
    Random random(seed);
    RootMeanSquare error;
    HarmonicErrors errors;
    for (int i = 0; i < 20000; ++i) {
        const Eigen::Matrix3d truth = rotationOf(drawn(random));
        double strength_T = 0.0;
        const double off_deg = radiansToDegrees(
            symmetricError_rad(estimator.solve(field.readings_T(truth, sensing.poses), strength_T), truth));
        error.add(off_deg);
        errors.worst_deg = std::max(errors.worst_deg, off_deg);
    }
    errors.rms_deg = error.value();
    return errors;
}

// Section 5.1 of resources/help/spherical-theory.md: harmonics ignored and after passes. rms scatters by
// less than 1 %; the worst of a sample lies below that of the whole workspace.
TEST(HarmonicPasses, errorsFallAsKnown) {
    const HarmonicErrors ignored = harmonicErrors(OrientationMethod::Tensor, 0, 22);
    EXPECT_NEAR(ignored.rms_deg, 0.487, 0.02 * 0.487);
    EXPECT_NEAR(ignored.worst_deg, 1.10, 0.06);
    const HarmonicErrors refined = harmonicErrors(OrientationMethod::TensorRefined, 0, 22);
    EXPECT_NEAR(refined.rms_deg, 0.394, 0.02 * 0.394);
    EXPECT_NEAR(refined.worst_deg, 0.726, 0.05);
    const HarmonicErrors once = harmonicErrors(OrientationMethod::Tensor, 1, 22);
    EXPECT_NEAR(once.rms_deg, 0.0100, 0.1 * 0.0100);
    EXPECT_LT(once.worst_deg, 0.053);
    const HarmonicErrors twice = harmonicErrors(OrientationMethod::Tensor, 2, 22);
    EXPECT_LT(twice.rms_deg, 5e-4);
    EXPECT_LT(twice.worst_deg, 3.6e-3);
    EXPECT_LT(harmonicErrors(OrientationMethod::Tensor, 4, 22).worst_deg, 1e-4);
}

TEST(RotationSearch, strongHarmonicsAreSolvedByFallbackStarts) {
    SphericalSensing sensing;
    sensing.field.harmonics = harmonicPreset(HarmonicPreset::H2);
    OrientationConfig config;
    config.method = OrientationMethod::LevenbergMarquardt;
    const OrientationEstimator estimator = *OrientationEstimator::make(sensing, config);
    const RotorField field(sensing.field);
    Random random(23);
    for (int i = 0; i < 2000; ++i) {
        const Eigen::Matrix3d truth = rotationOf(drawn(random));
        const OrientationEstimate estimate = estimator.estimate(field.readings_T(truth, sensing.poses));
        ASSERT_EQ(estimate.verdict, OrientationVerdict::Determined) << i;
        ASSERT_LT(radiansToDegrees(symmetricError_rad(estimate.rotation, truth)), 1e-6) << i;
    }
}

TEST(MissingChannels, poseIsFoundFromTwoSensorsAndFromFewerBySearch) {
    const SphericalSensing sensing;
    const OrientationEstimator estimator = *OrientationEstimator::make(sensing, {});
    const RotorField field(sensing.field);
    ChannelMask two = AllChannels;
    two[3] = two[4] = two[5] = false;
    ChannelMask four{};
    four[0] = four[1] = four[5] = four[7] = true;
    ChannelMask one{};
    one[0] = one[1] = one[2] = true;
    Random random(24);
    int ambiguous = 0;
    for (int i = 0; i < 300; ++i) {
        const Eigen::Matrix3d truth = rotationOf(drawn(random));
        SphericalReadings readings_T = field.readings_T(truth, sensing.poses);
        readings_T.segment<3>(3).setConstant(std::nan(""));
        const OrientationEstimate pair = estimator.estimate(readings_T, two);
        EXPECT_EQ(pair.verdict, OrientationVerdict::Determined);
        EXPECT_EQ(pair.freedom, 1);
        EXPECT_LT(symmetricError_rad(pair.rotation, truth), 1e-12);
        EXPECT_EQ(estimator.estimate(readings_T, one).verdict, OrientationVerdict::NotDetermined);
        const OrientationEstimate few = estimator.estimate(field.readings_T(truth, sensing.poses), four);
        const double nearest =
            std::min(symmetricError_rad(few.rotation, truth), symmetricError_rad(few.other, truth));
        if (few.verdict == OrientationVerdict::Reduced) {
            EXPECT_LT(symmetricError_rad(few.rotation, truth), 1e-6);
        } else {
            ASSERT_EQ(few.verdict, OrientationVerdict::Ambiguous);
            ++ambiguous;
            EXPECT_LT(nearest, Pi);
        }
    }
    // Four readings of a quadratic field leave several poses in part of the workspace.
    EXPECT_GT(ambiguous, 0);
    EXPECT_LT(ambiguous, 300);
}

TEST(Uncertainty, coneAndIntervalsHoldTheTruthIn95Percent) {
    SphericalSensing sensing;
    sensing.deviation_T << 1e-4, 2e-4, 1e-4, 3e-4, 1e-4, 1e-4, 2e-4, 1e-4, 5e-4;
    const RotorField field(sensing.field);
    constexpr int Poses = 6000;
    // Binomial: sqrt(0.95 0.05/6000) = 0.28 %; three and a half of that.
    constexpr double Tolerance = 0.01;
    for (const OrientationMethod method :
         {OrientationMethod::Tensor, OrientationMethod::Projector, OrientationMethod::TensorRefined,
          OrientationMethod::LevenbergMarquardt}) {
        OrientationConfig config;
        config.method = method;
        const OrientationEstimator estimator = *OrientationEstimator::make(sensing, config);
        Random random(25);
        std::array<int, 4> inside{};
        for (int i = 0; i < Poses; ++i) {
            const OrientationAngles angles = drawn(random);
            const Eigen::Matrix3d truth = rotationOf(angles);
            const SphericalReadings error_T = noise_T(random, 1.0).cwiseProduct(sensing.deviation_T);
            const OrientationEstimate estimate =
                estimator.estimate(field.readings_T(truth, sensing.poses) + error_T);
            const Eigen::Matrix3d near = nearestImage(estimate.rotation, truth);
            const OrientationAngles found = anglesOf(near);
            const AngleIntervals half = angleIntervals95(found, estimate.covariance_rad2);
            inside[0] += std::abs(found.alpha_rad - angles.alpha_rad) < half.alpha_rad;
            inside[1] += std::abs(found.beta_rad - angles.beta_rad) < half.beta_rad;
            inside[2] += std::abs(found.gamma_rad - angles.gamma_rad) < half.gamma_rad;
            inside[3] += std::acos(std::min(1.0, near.col(2).dot(truth.col(2)))) <
                         shaftCone95_rad(near, estimate.covariance_rad2);
        }
        for (const int count : inside) {
            EXPECT_NEAR(static_cast<double>(count) / Poses, 0.95, Tolerance);
        }
    }
}

TEST(Uncertainty, coneHasTheQuantilesOfOneAndTwoDirections) {
    const Eigen::Matrix3d none = Eigen::Matrix3d::Identity();
    EXPECT_NEAR(shaftCone95_rad(none, Eigen::Vector3d(1e-4, 0, 7).asDiagonal()), 1.96e-2, 0.01e-2);
    // Two equal variances: Rayleigh, sqrt(-2 ln 0.05) = 2.4477
    EXPECT_NEAR(shaftCone95_rad(none, Eigen::Vector3d(1e-4, 1e-4, 7).asDiagonal()), 2.4477e-2, 1e-6);
    const AngleIntervals singular = angleIntervals95(angles_deg(0, 90, 0), 1e-8 * none);
    EXPECT_EQ(singular.alpha_rad, Pi);
}

} // namespace
} // namespace halbench::models
