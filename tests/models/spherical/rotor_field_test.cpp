#include "models/spherical/additive_model.h"
#include "models/spherical/orientation.h"
#include "models/spherical/rotor_field.h"
#include "tests/models/spherical/orientation_cases.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

TEST(Orientation, shaftAndAnglesFollowTheirDefinitions) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const OrientationAngles angles = drawn(random);
        const Eigen::Matrix3d m = rotationOf(angles);
        const double sa = std::sin(angles.alpha_rad);
        const double ca = std::cos(angles.alpha_rad);
        const double sb = std::sin(angles.beta_rad);
        const double cb = std::cos(angles.beta_rad);
        EXPECT_LT((m.col(2) - Eigen::Vector3d(sb, -cb * sa, cb * ca)).norm(), 1e-15);
        const OrientationAngles back = anglesOf(m);
        EXPECT_NEAR(back.alpha_rad, angles.alpha_rad, 1e-14);
        EXPECT_NEAR(back.beta_rad, angles.beta_rad, 1e-14);
        EXPECT_NEAR(back.gamma_rad, angles.gamma_rad, 1e-14);
        const OrientationAngles again = anglesForShaft(shaftOf(m), angles.gamma_rad);
        EXPECT_LT(symmetricError_rad(rotationOf(again), m), 1e-13);
        // exp and log are inverse; the rate matrix is the derivative of M.
        EXPECT_LT((rotationOfVector(vectorOfRotation(m)) - m).norm(), 1e-13);
        const double h = 1e-6;
        const OrientationAngles later{angles.alpha_rad + 0.3 * h, angles.beta_rad - 0.5 * h,
                                      angles.gamma_rad + 0.7 * h};
        const Eigen::Vector3d rate = vectorOfRotation(rotationOf(later) * m.transpose()) / h;
        // First-order difference: error h.
        EXPECT_LT((rate - rateMatrix(angles) * Eigen::Vector3d(0.3, -0.5, 0.7)).norm(), 1e-6);
    }
}

TEST(Orientation, errorsAreCountedModuloTheSymmetryOfTheRotor) {
    const Eigen::Matrix3d m = rotationOf(angles_deg(10, 20, 89.9));
    const Eigen::Matrix3d turned = rotationOf(angles_deg(10, 20, -89.9));
    EXPECT_NEAR(radiansToDegrees(symmetricError_rad(turned, m)), 0.2, 1e-10);
    for (const Eigen::Vector3d& sign : symmetrySigns()) {
        EXPECT_LT(symmetricError_rad(m * sign.asDiagonal(), m), 1e-15);
        EXPECT_LT((representative(m * sign.asDiagonal()) - m).norm(), 1e-15);
        const RotorField field({Q, 0.05, harmonicPreset(HarmonicPreset::H1)});
        const SensorPoses poses = sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05);
        EXPECT_LT((field.readings_T(m * sign.asDiagonal(), poses) - field.readings_T(m, poses))
                      .cwiseAbs()
                      .maxCoeff(),
                  1e-15);
    }
}

TEST(SensorPlacement, publishedTripleHasItsPlaces) {
    for (const SensorFrames frames : {SensorFrames::Zyx, SensorFrames::Xyz, SensorFrames::Natural}) {
        const SensorPoses poses = sensorPoses(publishedPlacement(), frames, 0.05);
        const double half = std::sqrt(0.5);
        EXPECT_LT((poses[0].position_m - 0.05 * Eigen::Vector3d(1, 0, 0)).norm(), 1e-16);
        EXPECT_LT((poses[1].position_m - 0.05 * Eigen::Vector3d(half, half, 0)).norm(), 1e-16);
        EXPECT_LT((poses[2].position_m - 0.05 * Eigen::Vector3d(0, -half, -half)).norm(), 1e-16);
        EXPECT_LT((poses[0].axes.col(1) - Eigen::Vector3d(0, 0, -1)).norm(), 1e-16);
        EXPECT_LT((poses[0].axes.col(2) - Eigen::Vector3d(0, 1, 0)).norm(), 1e-16);
        EXPECT_TRUE(checkSensorPoses(poses, 45.6e-3).has_value());
    }
    // Sensor 2 of zyx and nat differ by a roll of 45 degrees about the radius.
    const SensorPose zyx = sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05)[2];
    const SensorPose nat = sensorPoses(publishedPlacement(), SensorFrames::Natural, 0.05)[2];
    EXPECT_NEAR(std::abs(zyx.axes.col(1).dot(nat.axes.col(1))), std::sqrt(0.5), 1e-15);
    // The recommended places are theta 65 and 115, phi -55 and +55 degrees.
    const SensorPoses good = sensorPoses(recommendedPlacement(), SensorFrames::Zyx, 0.05);
    EXPECT_NEAR(good[1].position_m.z() / 0.05, std::cos(degreesToRadians(65)), 1e-15);
    EXPECT_NEAR(good[2].position_m.z() / 0.05, std::cos(degreesToRadians(115)), 1e-15);
    EXPECT_NEAR(std::atan2(good[2].position_m.y(), good[2].position_m.x()), degreesToRadians(55), 1e-15);
}

TEST(SensorPlacement, refusesSensorsThatCannotBe) {
    SensorPoses poses = sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05);
    poses[1] = poses[0];
    EXPECT_EQ(checkSensorPoses(poses, 45.6e-3).error().code, ErrorCode::OutOfRange);
    poses = sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.04);
    EXPECT_EQ(checkSensorPoses(poses, 45.6e-3).error().code, ErrorCode::OutOfRange);
    poses = sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05);
    poses[2].axes(0, 0) = std::nan("");
    EXPECT_EQ(checkSensorPoses(poses, 45.6e-3).error().code, ErrorCode::NotFinite);
}

TEST(RotorField, mainSensorIsTheAdditiveModelAndPureRollsAreExact) {
    const RotorField field({Q, 0.05, {}});
    AdditiveModel model;
    model.placement[1] = {degreesToRadians(30), 0.0, 0.0}; // only da: a roll about the sensor's radius
    const SensorPoses poses = sensorPoses(model.placement, SensorFrames::Zyx, 0.05);
    Random random(2);
    for (int i = 0; i < 500; ++i) {
        const OrientationAngles angles = drawn(random);
        const SphericalReadings difference =
            field.readings_T(rotationOf(angles), poses) - additiveReadings_T(model, angles);
        EXPECT_LT(difference.head<6>().cwiseAbs().maxCoeff(), 1e-14);
    }
}

TEST(RotorField, auxiliarySensorsAgreeWithTheAdditiveModelAtZeroTiltOnly) {
    const RotorField field({Q, 0.05, {}});
    const SensorPoses poses = sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05);
    for (double gamma = -90.0; gamma <= 90.0; gamma += 7.5) {
        const OrientationAngles angles = angles_deg(0, 0, gamma);
        const SphericalReadings difference =
            field.readings_T(rotationOf(angles), poses) - additiveReadings_T({}, angles);
        EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-14) << gamma;
    }
    // Known rms over the workspace, T; printed with two digits, and 20000 draws scatter by
    // less than 1 %.
    const std::array<double, 9> rms_T = {0, 0, 0, 0.056, 0.056, 0.0048, 0.134, 0.083, 0.064};
    SphericalReadings square = SphericalReadings::Zero();
    Random random(3);
    for (int i = 0; i < 20000; ++i) {
        const OrientationAngles angles = drawn(random);
        const SphericalReadings difference =
            field.readings_T(rotationOf(angles), poses) - additiveReadings_T({}, angles);
        square += difference.cwiseAbs2() / 20000.0;
    }
    for (int i = 3; i < 9; ++i) {
        const double expected_T = rms_T[static_cast<std::size_t>(i)];
        EXPECT_NEAR(std::sqrt(square[i]), expected_T, 0.02 * expected_T + 1e-4) << i;
    }
}

TEST(RotorField, additiveModelHasTheCheckValuesOfTheFigures) {
    // Figure 7, alpha 30, beta 0, gamma 87.5: magnitudes printed to 0.1 mT.
    const SphericalReadings seen = additiveReadings_T({}, angles_deg(30, 0, 87.5)).cwiseAbs();
    const std::array<double, 9> printed = {0.2964, 0.0086, 0.0150, 0.0259, 0.0988,
                                           0.1711, 0.1482, 0.0986, 0.0138};
    for (int i = 0; i < 9; ++i) {
        EXPECT_NEAR(seen[i], printed[static_cast<std::size_t>(i)], 6e-5) << i;
    }
    // Figure 5, alpha 2, gamma 90: Theta of the three sensors at beta -45, 0, 45.
    const std::array<std::array<double, 4>, 3> figure5 = {
        {{-45, 0.0991, 0.0049, 0.0}, {0, 0.0, 0.0069, 0.0725}, {45, 0.0991, 0.0049, 0.0}}};
    for (const auto& row : figure5) {
        const SphericalReadings slice = additiveReadings_T({}, angles_deg(2, row[0], 90)).cwiseAbs();
        EXPECT_NEAR(slice[1], row[1], 6e-5);
        EXPECT_NEAR(slice[4], row[2], 6e-5);
        EXPECT_NEAR(slice[7], row[3], 6e-5);
    }
}

TEST(RotorField, counterexampleOfTheCoverageClaimReadsNoTheta) {
    const SphericalReadings seen = additiveReadings_T({}, angles_deg(0, 0, 17.63));
    EXPECT_NEAR(seen[1], 0.0, 1e-17);
    EXPECT_NEAR(seen[4], 0.0, 1e-17);
    EXPECT_NEAR(seen[7], -9.3e-6, 0.05e-6);
}

TEST(RotorField, largestEffectOfThePresetH1Is6mT) {
    const RotorField field({Q, 0.05, harmonicPreset(HarmonicPreset::H1)});
    const SensorPoses poses = sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05);
    double largest_T = 0.0;
    Random random(4);
    for (int i = 0; i < 20000; ++i) {
        const Eigen::Matrix3d m = rotationOf(drawn(random));
        largest_T = std::max(largest_T, field.harmonicReadings_T(m, poses).cwiseAbs().maxCoeff());
    }
    // Upper end: at (theta 90, phi 0) all four B_r terms add up to -(-3) + 1 + 1.5 + 0.5 = 6.0 mT exactly.
    EXPECT_LE(largest_T, 6.0e-3 + 1e-12);
    EXPECT_GT(largest_T, 5.8e-3);
}

TEST(RotorField, tensorDesignAndJacobianAreTheReadingsAndTheirDerivative) {
    const SensorPoses nominal = sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05);
    SensorPoses poses = nominal;
    poses[1] = displacedPose(poses[1], {0.02, -0.01, 0.03}, {1e-3, -2e-3, 1.5e-3});
    Random random(5);
    for (const HarmonicPreset preset : {HarmonicPreset::H0, HarmonicPreset::H1, HarmonicPreset::H2}) {
        const RotorField field({Q, 0.05, harmonicPreset(preset)});
        for (int i = 0; i < 50; ++i) {
            const Eigen::Matrix3d m = rotationOf(drawn(random));
            const SphericalReadings linear =
                tensorDesign(poses, 0.05) * tensorCoordinates(rotorTensor_T(Q, m));
            const SphericalReadings whole = field.readings_T(m, poses);
            EXPECT_LT((linear + field.harmonicReadings_T(m, poses) - whole).cwiseAbs().maxCoeff(), 1e-15);
            OrientationJacobian jacobian;
            EXPECT_LT((field.readingsAndJacobian(m, poses, jacobian) - whole).norm(), 1e-15);
            for (int k = 0; k < 3; ++k) {
                const double h = 1e-5; // central differences: error h^2 times slopes of at most 30 T/rad^3
                const Eigen::Vector3d w = h * Eigen::Vector3d::Unit(k);
                const SphericalReadings slope = (field.readings_T(rotationOfVector(w) * m, poses) -
                                                 field.readings_T(rotationOfVector(-w) * m, poses)) /
                                                (2.0 * h);
                EXPECT_LT((slope - jacobian.col(k)).cwiseAbs().maxCoeff(), 3e-9);
            }
        }
    }
}

TEST(RotorField, additiveJacobianIsTheDerivative) {
    Random random(6);
    for (int i = 0; i < 50; ++i) {
        const OrientationAngles angles = drawn(random);
        OrientationJacobian jacobian;
        EXPECT_LT((additiveReadingsAndJacobian({}, angles, jacobian) - additiveReadings_T({}, angles)).norm(),
                  1e-15);
        for (int k = 0; k < 3; ++k) {
            const double h = 1e-5; // as above
            const auto moved = [&](double by) {
                OrientationAngles turned = angles;
                (k == 0 ? turned.alpha_rad : k == 1 ? turned.beta_rad : turned.gamma_rad) += by;
                return additiveReadings_T({}, turned);
            };
            const SphericalReadings slope = (moved(h) - moved(-h)) / (2.0 * h);
            EXPECT_LT((slope - jacobian.col(k)).cwiseAbs().maxCoeff(), 1e-9);
        }
    }
}

} // namespace
} // namespace halbench::models
