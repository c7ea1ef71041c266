#include "models/spherical/additive_inverse.h"
#include "models/spherical/additive_uncertainty.h"
#include "models/spherical/any_estimator.h"
#include "models/spherical/orientation_uncertainty.h"
#include "tests/models/spherical/orientation_cases.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

constexpr double Noise_T = 100e-6;
constexpr double Assembly_T = 3.65e-3; ///< resources/help/spherical-theory.md section 8

SensorPoses publishedPoses() {
    return sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05);
}

struct Trial {
    EstimatorKind kind = EstimatorKind::Closed;
    SwarmRule rule = SwarmRule::LargestResidual;
    bool isPhysical = false;
    double deviation_T = Noise_T;
    double tilt_ratio = 1.0;  ///< of the workspace
    double right_deg = 180.0; ///< an error beyond it is another pose
    int poses = 4000;
};

/// Shares of the true poses that cone and intervals hold, of those that have them and are right.
struct Covered {
    int right = 0;
    int given = 0;
    int shaft = 0;
    int alpha = 0;
    int beta = 0;
    int gamma = 0;

    double ratio(int inside) const { return static_cast<double>(inside) / std::max(1, given); }
};

void count(const AdditiveUncertainty& uncertainty, const Eigen::Matrix3d& found, const Eigen::Matrix3d& truth,
           Covered& covered) {
    const double tilt_rad =
        std::atan2(found.col(2).cross(truth.col(2)).norm(), found.col(2).dot(truth.col(2)));
    const OrientationAngles angles = anglesOf(found);
    const OrientationAngles known = anglesOf(truth);
    const AngleIntervals half = angleIntervals95(angles, uncertainty.covariance_rad2);
    ++covered.given;
    covered.shaft += tilt_rad <= shaftCone95_rad(found, uncertainty.covariance_rad2);
    covered.alpha += std::abs(angles.alpha_rad - known.alpha_rad) <= half.alpha_rad;
    covered.beta += std::abs(angles.beta_rad - known.beta_rad) <= half.beta_rad;
    covered.gamma += std::abs(std::remainder(angles.gamma_rad - known.gamma_rad, Pi)) <= half.gamma_rad;
}

Covered run(const Trial& trial) {
    AnyEstimatorConfig config;
    config.kind = trial.kind;
    config.swarm.rule = trial.rule;
    const auto estimator = makeAdditiveEstimator(config);
    EXPECT_TRUE(estimator.has_value());
    const RotorField field({Q, 0.05, {}});
    const SensorPoses poses = publishedPoses();
    Random random(3);
    Covered covered;
    for (int i = 0; i < trial.poses; ++i) {
        OrientationAngles angles = drawn(random);
        angles.alpha_rad *= trial.tilt_ratio;
        angles.beta_rad *= trial.tilt_ratio;
        const Eigen::Matrix3d truth = rotationOf(angles);
        const SphericalReadings readings_T =
            (trial.isPhysical ? field.readings_T(truth, poses)
                              : additiveReadings_T(config.additive, angles)) +
            noise_T(random, trial.deviation_T);
        const auto estimate = (*estimator)(readings_T);
        if (!estimate) {
            continue;
        }
        const Eigen::Matrix3d found = nearestImage(rotationOf(estimate->angles), truth);
        if (radiansToDegrees(symmetricError_rad(found, truth)) > trial.right_deg) {
            continue;
        }
        ++covered.right;
        const AdditiveUncertainty uncertainty =
            additiveUncertainty(config.additive, poses, *estimate, readings_T, trial.deviation_T);
        if (uncertainty.gap == UncertaintyGap::None) {
            count(uncertainty, found, truth, covered);
        }
    }
    return covered;
}

/// 95 % within 3.5 standard deviations of the binomial count.
void expectCovered(const Covered& covered) {
    const double slack = 3.5 * std::sqrt(0.95 * 0.05 / covered.given);
    for (const int inside : {covered.shaft, covered.alpha, covered.beta, covered.gamma}) {
        EXPECT_NEAR(covered.ratio(inside), 0.95, slack) << covered.given;
    }
}

TEST(AdditiveUncertainty, gainOfTheClosedFormUndoesTheJacobianAndIsItsDerivative) {
    Random random(5);
    const AdditiveModel model;
    for (int i = 0; i < 200; ++i) {
        const OrientationAngles angles = drawn(random);
        const AngleGain gain = inverseGain(Q, angles);
        OrientationJacobian jacobian;
        const SphericalReadings readings_T = additiveReadingsAndJacobian(model, angles, jacobian);
        EXPECT_LT((gain * jacobian - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-12);
        for (int channel = 0; channel < 9; ++channel) {
            SphericalReadings more_T = readings_T;
            SphericalReadings less_T = readings_T;
            more_T[channel] += 1e-7;
            less_T[channel] -= 1e-7;
            const OrientationAngles high = additiveInverse(Q, more_T);
            const OrientationAngles low = additiveInverse(Q, less_T);
            const Eigen::Vector3d slope =
                Eigen::Vector3d(high.alpha_rad - low.alpha_rad, high.beta_rad - low.beta_rad,
                                std::remainder(high.gamma_rad - low.gamma_rad, Pi)) /
                2e-7;
            // Slopes reach 10 rad/T; central differences of 1e-7 T leave 1e-16/1e-7 of rounding.
            EXPECT_LT((slope - gain.col(channel)).cwiseAbs().maxCoeff(), 1e-6) << channel;
        }
    }
}

TEST(AdditiveUncertainty, gainOfThreeChannelsIsTheInverseAndOfNineTheLeastSquares) {
    OrientationJacobian jacobian;
    additiveReadingsAndJacobian(AdditiveModel{}, angles_deg(20, -15, 30), jacobian);
    const ChannelMask main = {true, true, true};
    const auto three = leastSquaresGain(jacobian, main);
    ASSERT_TRUE(three);
    EXPECT_LT((three->leftCols<3>() * jacobian.topRows<3>() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_LT(three->rightCols<6>().norm(), 1e-14);
    const auto nine = leastSquaresGain(jacobian, AllChannels);
    ASSERT_TRUE(nine);
    const Eigen::Matrix3d normal = jacobian.transpose() * jacobian;
    EXPECT_LT((*nine - normal.inverse() * jacobian.transpose()).norm(), 1e-11);
    // The main sensor alone is singular over the plane beta = 0 (section 5.4).
    additiveReadingsAndJacobian(AdditiveModel{}, angles_deg(20, 0, 30), jacobian);
    EXPECT_FALSE(leastSquaresGain(jacobian, main));
    EXPECT_TRUE(leastSquaresGain(jacobian, AllChannels));
}

TEST(AdditiveUncertainty, conesOfTheClosedFormHoldNineteenOfTwenty) {
    for (const EstimatorKind kind : {EstimatorKind::Closed, EstimatorKind::ClosedFitted}) {
        for (const double deviation_T : {Noise_T, Assembly_T}) {
            const Covered covered = run({.kind = kind, .deviation_T = deviation_T});
            EXPECT_EQ(covered.given, 4000); // every pose has one
            expectCovered(covered);
        }
    }
}

TEST(AdditiveUncertainty, conesOfTheSwarmHoldNineteenOfTwentyWhereItIsRight) {
    for (const SwarmRule rule :
         {SwarmRule::LargestResidual, SwarmRule::FirstAboveThreshold, SwarmRule::AllNine}) {
        const Covered covered =
            run({.kind = EstimatorKind::Swarm, .rule = rule, .right_deg = 5.0, .poses = 1000});
        expectCovered(covered);
        EXPECT_GT(covered.given, 400) << static_cast<int>(rule);
    }
}

// Off zero tilt the readings of a physical rotor are none of the additive model: a cone would be a guess.
TEST(AdditiveUncertainty, readingsOfAPhysicalRotorHaveNoCone) {
    const Covered covered = run({.isPhysical = true, .poses = 1000});
    EXPECT_EQ(covered.right, 1000);
    EXPECT_LT(covered.given, 5);
}

// At small tilts sensors as assembled do not tell which device it is: the cone holds both.
TEST(AdditiveUncertainty, whereTheDeviceCannotBeToldTheConeHoldsThePhysicalOneToo) {
    for (const EstimatorKind kind : {EstimatorKind::Closed, EstimatorKind::ClosedFitted}) {
        const Covered covered =
            run({.kind = kind, .isPhysical = true, .deviation_T = Assembly_T, .tilt_ratio = 0.1});
        EXPECT_GT(covered.given, 3000);
        const double least = 0.95 - 3.5 * std::sqrt(0.95 * 0.05 / covered.given);
        for (const int inside : {covered.shaft, covered.alpha, covered.beta, covered.gamma}) {
            EXPECT_GT(covered.ratio(inside), least);
        }
    }
}

TEST(AdditiveUncertainty, aSearchThatDidNotSettleOrIsSingularSaysSo) {
    const AdditiveModel model;
    const OrientationAngles truth = angles_deg(20, -15, 30);
    const SphericalReadings readings_T = additiveReadings_T(model, truth);
    AdditiveEstimate off{angles_deg(20, -15, 31), AllChannels, false};
    EXPECT_EQ(additiveUncertainty(model, publishedPoses(), off, readings_T, Noise_T).gap,
              UncertaintyGap::NotSettled);
    const AdditiveEstimate unused{truth, {}, false}; // stopped before its first step
    EXPECT_EQ(additiveUncertainty(model, publishedPoses(), unused, readings_T, Noise_T).gap,
              UncertaintyGap::NotSettled);
    const OrientationAngles upright = angles_deg(20, 0, 30);
    const AdditiveEstimate main{upright, {true, true, true}, false};
    EXPECT_EQ(
        additiveUncertainty(model, publishedPoses(), main, additiveReadings_T(model, upright), Noise_T).gap,
        UncertaintyGap::Singular);
    const AdditiveEstimate right{truth, AllChannels, false};
    const AdditiveUncertainty known =
        additiveUncertainty(model, publishedPoses(), right, readings_T, Noise_T);
    EXPECT_EQ(known.gap, UncertaintyGap::None);
    EXPECT_LT(known.chiSquare, 1e-12);
}

} // namespace
} // namespace halbench::models
