#include "models/spherical/orientation_estimator.h"
#include "tests/models/spherical/swarm_success.h"

#include <gtest/gtest.h>

namespace halbench::models {
namespace {

TEST(LargeSamples, successRatesOfTheSwarmAreTheKnownOnes) {
    for (const SwarmCase& known : SwarmCases) {
        const SwarmSuccess success = swarmSuccess(configOf(known), known.knowsSignOfBeta, 20000, 51);
        EXPECT_NEAR(success.right_ratio, known.right_ratio, 0.03);
    }
}

TEST(LargeSamples, millionPosesAreAllRight) {
    const SphericalSensing sensing;
    const RotorField field(sensing.field);
    for (const OrientationMethod method :
         {OrientationMethod::Tensor, OrientationMethod::Projector, OrientationMethod::TensorRefined,
          OrientationMethod::LevenbergMarquardt}) {
        OrientationConfig config;
        config.method = method;
        const OrientationEstimator estimator = *OrientationEstimator::make(sensing, config);
        Random random(52);
        double worst_rad = 0.0;
        for (int i = 0; i < 1000000; ++i) {
            const Eigen::Matrix3d truth = anyRotation(random);
            const OrientationEstimate estimate = estimator.estimate(field.readings_T(truth, sensing.poses));
            worst_rad = std::max(worst_rad, symmetricError_rad(estimate.rotation, truth));
        }
        EXPECT_LT(radiansToDegrees(worst_rad), 1e-9);
    }
}

TEST(LargeSamples, fitFromTheIdentityFindsEveryPose) {
    const SphericalSensing sensing;
    const RotorField field(sensing.field);
    const TensorSystem system(sensing);
    Random random(53);
    int wrong = 0;
    for (int i = 0; i < 1000000; ++i) {
        const Eigen::Matrix3d truth = anyRotation(random);
        const RotationFit fit =
            fitRotation(field, sensing.poses, system, field.readings_T(truth, sensing.poses),
                        Eigen::Matrix3d::Identity());
        wrong += !fit.hasConverged || radiansToDegrees(symmetricError_rad(fit.rotation, truth)) > 1e-9;
    }
    EXPECT_EQ(wrong, 0);
}

TEST(LargeSamples, strongHarmonicsAreSolvedEverywhere) {
    SphericalSensing sensing;
    sensing.field.harmonics = harmonicPreset(HarmonicPreset::H2);
    OrientationConfig config;
    config.method = OrientationMethod::LevenbergMarquardt;
    const OrientationEstimator estimator = *OrientationEstimator::make(sensing, config);
    const RotorField field(sensing.field);
    Random random(54);
    int wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        const Eigen::Matrix3d truth = rotationOf(drawn(random));
        const OrientationEstimate estimate = estimator.estimate(field.readings_T(truth, sensing.poses));
        wrong += estimate.verdict != OrientationVerdict::Determined ||
                 radiansToDegrees(symmetricError_rad(estimate.rotation, truth)) > 1e-6;
    }
    EXPECT_EQ(wrong, 0);
}

} // namespace
} // namespace halbench::models
