#include "models/spherical/orientation_estimator.h"
#include "models/spherical/tensor_rotation.h"
#include "tests/models/spherical/orientation_cases.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <cmath>

namespace halbench::models {
namespace {

OrientationEstimator estimatorOf(OrientationMethod method, const SphericalSensing& sensing = {},
                                 bool isStrengthFree = true) {
    OrientationConfig config;
    config.method = method;
    config.fit.isStrengthFree = isStrengthFree;
    return *OrientationEstimator::make(sensing, config);
}

constexpr std::array TensorMethods = {OrientationMethod::Tensor, OrientationMethod::Projector,
                                      OrientationMethod::TensorRefined};

TEST(TensorSystem, designHasTheKnownSingularValues) {
    const TensorSystem system{SphericalSensing{}};
    const Eigen::JacobiSVD<Eigen::Matrix<double, 9, 5>> svd(system.design());
    const std::array<double, 5> known = {3.3325, 2.9135, 2.2005, 1.7829, 1.5444}; // four digits printed
    for (int i = 0; i < 5; ++i) {
        EXPECT_NEAR(svd.singularValues()[i], known[static_cast<std::size_t>(i)], 5e-5);
    }
    EXPECT_NEAR(system.conditioning(), 2.158, 5e-4);
    EXPECT_EQ(system.freedom(), 4);
    // Each pair of sensors alone: 6 equations, rank 5.
    const std::array<double, 3> pairs = {2.78, 2.12, 3.88}; // without sensor 0, 1, 2; two digits printed
    for (std::size_t missing = 0; missing < 3; ++missing) {
        ChannelMask used = AllChannels;
        used[3 * missing] = used[3 * missing + 1] = used[3 * missing + 2] = false;
        const TensorSystem pair(SphericalSensing{}, used);
        EXPECT_TRUE(pair.isDetermined());
        EXPECT_EQ(pair.freedom(), 1);
        EXPECT_NEAR(pair.conditioning(), pairs[missing], 5e-3);
    }
    SphericalSensing recommended;
    recommended.poses = sensorPoses(recommendedPlacement(), SensorFrames::Zyx, 0.05);
    EXPECT_NEAR(TensorSystem(recommended).conditioning(), 1.846, 5e-4);
    SphericalSensing stray;
    stray.hasUniformField = true;
    EXPECT_NEAR(TensorSystem(stray).smallestSingularValue(), 0.0535, 5e-5);
    EXPECT_EQ(TensorSystem(stray).freedom(), 1);
}

TEST(TensorEstimator, everyPoseIsFoundWithoutAStartValue) {
    const SphericalSensing sensing;
    const RotorField field(sensing.field);
    Random random(11);
    for (const OrientationMethod method : TensorMethods) {
        const OrientationEstimator estimator = estimatorOf(method);
        double worst_rad = 0.0;
        for (int i = 0; i < 5000; ++i) {
            const Eigen::Matrix3d truth = anyRotation(random);
            double strength_T = 0.0;
            const Eigen::Matrix3d found = estimator.solve(field.readings_T(truth, sensing.poses), strength_T);
            worst_rad = std::max(worst_rad, symmetricError_rad(found, truth));
            EXPECT_NEAR(strength_T, Q, 1e-14);
            EXPECT_GE(found(2, 2), 0.0);
            EXPECT_GE(found(0, 0), 0.0);
            EXPECT_NEAR(found.determinant(), 1.0, 1e-13);
        }
        EXPECT_LT(radiansToDegrees(worst_rad), 1e-9);
    }
}

TEST(TensorEstimator, axesOfTheStatorAreNoSpecialCase) {
    const SphericalSensing sensing;
    const RotorField field(sensing.field);
    for (const OrientationMethod method : TensorMethods) {
        const OrientationEstimator estimator = estimatorOf(method);
        for (int a = 0; a < 4; ++a) {
            for (int b = 0; b < 4; ++b) {
                for (int g = 0; g < 8; ++g) {
                    const Eigen::Matrix3d truth = rotationOf(angles_deg(90.0 * a, 90.0 * b, 45.0 * g));
                    double strength_T = 0.0;
                    const Eigen::Matrix3d found =
                        estimator.solve(field.readings_T(truth, sensing.poses), strength_T);
                    EXPECT_LT(radiansToDegrees(symmetricError_rad(found, truth)), 1e-9);
                }
            }
        }
    }
}

/// rms of the rotation angle over the workspace, degrees.
double noisyError_deg(OrientationMethod method, double deviation_T, bool isStrengthFree, std::uint64_t seed) {
    const SphericalSensing sensing;
    const RotorField field(sensing.field);
    const OrientationEstimator estimator = estimatorOf(method, sensing, isStrengthFree);
    Random random(seed);
    RootMeanSquare error;
    for (int i = 0; i < 20000; ++i) {
        const Eigen::Matrix3d truth = rotationOf(drawn(random));
        const SphericalReadings readings_T =
            field.readings_T(truth, sensing.poses) + noise_T(random, deviation_T);
        error.add(symmetricError_rad(estimator.estimate(readings_T).rotation, truth));
    }
    return radiansToDegrees(error.value());
}

// Section 7 of resources/help/spherical-theory.md; 2 %. 20000 poses scatter by 0.4 %. The refined column is
// that of a known strength.
TEST(TensorEstimator, noiseErrorsAreThoseOfTheTable) {
    const std::array<std::array<double, 4>, 3> table = {
        {{25e-6, 0.00748, 0.00772, 0.00716}, {100e-6, 0.0299, 0.0309, 0.0286}, {1e-3, 0.299, 0.308, 0.286}}};
    for (const auto& row : table) {
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(noisyError_deg(TensorMethods[k], row[0], false, 12), row[k + 1], 0.02 * row[k + 1]);
        }
    }
    EXPECT_NEAR(noisyError_deg(OrientationMethod::LevenbergMarquardt, 100e-6, false, 13), 0.0286,
                0.02 * 0.0286);
}

TEST(TensorEstimator, twelveBitsCostTheirPrintedError) {
    const SphericalSensing sensing;
    const RotorField field(sensing.field);
    const OrientationEstimator estimator = estimatorOf(OrientationMethod::TensorRefined, sensing, false);
    Random random(14);
    RootMeanSquare error;
    for (int i = 0; i < 20000; ++i) {
        const Eigen::Matrix3d truth = rotationOf(drawn(random));
        SphericalReadings readings_T = field.readings_T(truth, sensing.poses);
        const double step_T = 0.6 / 4096.0;
        readings_T = step_T * (readings_T / step_T).array().round();
        double strength_T = 0.0;
        error.add(symmetricError_rad(estimator.solve(readings_T, strength_T), truth));
    }
    EXPECT_NEAR(radiansToDegrees(error.value()), 0.0121, 0.02 * 0.0121);
}

TEST(TensorEstimator, chiSquareHasItsMeanAndTheResidualItsChannels) {
    const SphericalSensing sensing;
    const RotorField field(sensing.field);
    Random random(15);
    for (const OrientationMethod method : {OrientationMethod::Tensor, OrientationMethod::TensorRefined,
                                           OrientationMethod::LevenbergMarquardt}) {
        const OrientationEstimator estimator = estimatorOf(method);
        double sum = 0.0;
        constexpr int Poses = 4000;
        int freedom = 0;
        for (int i = 0; i < Poses; ++i) {
            const OrientationEstimate estimate = estimator.estimate(
                field.readings_T(rotationOf(drawn(random)), sensing.poses) + noise_T(random, 100e-6));
            EXPECT_EQ(estimate.verdict, OrientationVerdict::Determined);
            sum += estimate.chiSquare;
            freedom = estimate.freedom;
        }
        EXPECT_EQ(freedom, method == OrientationMethod::LevenbergMarquardt ? 5 : 4);
        // Variance of chi-square: twice its freedom; three standard deviations of the mean.
        EXPECT_NEAR(sum / Poses, freedom, 3.0 * std::sqrt(2.0 * freedom / Poses));
    }
}

TEST(TensorEstimator, covarianceIsThatOfTheErrors) {
    const SphericalSensing sensing;
    const RotorField field(sensing.field);
    const Eigen::Matrix3d truth = rotationOf(angles_deg(12, -20, 33));
    for (const OrientationMethod method : TensorMethods) {
        const OrientationEstimator estimator = estimatorOf(method);
        Random random(16);
        Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
        constexpr int Draws = 20000;
        Eigen::Matrix3d predicted;
        for (int i = 0; i < Draws; ++i) {
            const OrientationEstimate estimate =
                estimator.estimate(field.readings_T(truth, sensing.poses) + noise_T(random, 100e-6));
            const Eigen::Vector3d off = vectorOfRotation(estimate.rotation * truth.transpose());
            spread += off * off.transpose() / Draws;
            predicted = estimate.covariance_rad2;
        }
        // Entries scatter by at most sqrt(2/20000) = 1 % of the largest; four of that, and the prediction is
        // made at the estimate.
        EXPECT_LT((spread - predicted).cwiseAbs().maxCoeff(), 0.04 * predicted.diagonal().maxCoeff());
    }
}

TEST(TensorEstimator, boundOfCramerAndRaoHasItsRangeOverTheWorkspace) {
    const SphericalSensing sensing;
    const OrientationEstimator estimator = estimatorOf(OrientationMethod::TensorRefined, sensing, false);
    const OrientationEstimator free = estimatorOf(OrientationMethod::TensorRefined);
    const RotorField field(sensing.field);
    Random random(17);
    RootMeanSquare all;
    double best = 1.0;
    double worst = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const Eigen::Matrix3d truth = rotationOf(drawn(random));
        const SphericalReadings readings_T = field.readings_T(truth, sensing.poses);
        const OrientationEstimate estimate = estimator.estimate(readings_T);
        EXPECT_GE(free.estimate(readings_T).covariance_rad2.trace(), estimate.covariance_rad2.trace());
        const double deviation_deg = radiansToDegrees(std::sqrt(estimate.covariance_rad2.trace()));
        all.add(deviation_deg);
        best = std::min(best, deviation_deg);
        worst = std::max(worst, deviation_deg);
    }
    // Three digits printed.
    EXPECT_NEAR(all.value(), 0.0286, 1e-4);
    EXPECT_NEAR(best, 0.0237, 1e-4);
    EXPECT_NEAR(worst, 0.0332, 2e-4);
}

TEST(TensorEstimator, uniformFieldIsFoundAsAnUnknown) {
    const SphericalSensing plain;
    SphericalSensing sensing;
    sensing.hasUniformField = true;
    sensing.deviation_T.setConstant(50e-6);
    const RotorField field(sensing.field);
    const OrientationEstimator ignoring = estimatorOf(OrientationMethod::Tensor);
    const OrientationEstimator estimating = estimatorOf(OrientationMethod::Tensor, sensing);
    Random random(18);
    RootMeanSquare ignored;
    RootMeanSquare estimated;
    for (int i = 0; i < 20000; ++i) {
        const Eigen::Matrix3d truth = rotationOf(drawn(random));
        const Eigen::Vector3d stray_T =
            2e-3 * Eigen::Vector3d(random.gaussian(), random.gaussian(), random.gaussian()).normalized();
        const SphericalReadings clean_T =
            field.readings_T(truth, sensing.poses) + uniformFieldDesign(sensing.poses) * stray_T;
        double strength_T = 0.0;
        ignored.add(symmetricError_rad(ignoring.solve(clean_T, strength_T), truth));
        estimated.add(
            symmetricError_rad(estimating.solve(clean_T + noise_T(random, 50e-6), strength_T), truth));
        if (i < 100) {
            const OrientationEstimate exact = estimating.estimate(clean_T);
            EXPECT_LT(symmetricError_rad(exact.rotation, truth), 1e-11);
            EXPECT_LT((exact.uniformField_T - stray_T).norm(), 1e-13);
        }
    }
    EXPECT_NEAR(radiansToDegrees(ignored.value()), 0.364, 0.03 * 0.364);
    EXPECT_NEAR(radiansToDegrees(estimated.value()), 0.183, 0.03 * 0.183);
}

TEST(TensorEstimator, strengthOfTheMagnetDoesNotEnterTheTensorAngles) {
    const SphericalSensing sensing;
    RotorFieldConfig weaker = sensing.field;
    weaker.strength_T *= 0.97;
    const RotorField field(weaker);
    OrientationConfig held;
    held.method = OrientationMethod::LevenbergMarquardt;
    held.fit.isStrengthFree = false;
    held.chiSquareLimit = 1e9;
    const OrientationEstimator fixed = *OrientationEstimator::make(sensing, held);
    const OrientationEstimator free = estimatorOf(OrientationMethod::TensorRefined);
    Random random(19);
    RootMeanSquare error;
    double worst_deg = 0.0;
    for (int i = 0; i < 5000; ++i) {
        const Eigen::Matrix3d truth = rotationOf(drawn(random));
        const SphericalReadings readings_T = field.readings_T(truth, sensing.poses);
        double strength_T = 0.0;
        EXPECT_LT(symmetricError_rad(free.solve(readings_T, strength_T), truth), 1e-13);
        const double off_deg =
            radiansToDegrees(symmetricError_rad(fixed.estimate(readings_T).rotation, truth));
        error.add(off_deg);
        worst_deg = std::max(worst_deg, off_deg);
    }
    EXPECT_NEAR(error.value(), 0.73, 0.02);
    EXPECT_NEAR(worst_deg, 1.45, 0.05);
}

// A strength that is held belongs to the model: of a magnet 3 % weaker chi-square says so, with 6 degrees of
// freedom where it is right.
TEST(TensorEstimator, chiSquareOfAKnownStrengthTellsAnotherMagnet) {
    const SphericalSensing sensing;
    const OrientationEstimator held = estimatorOf(OrientationMethod::TensorRefined, sensing, false);
    for (const double strength_ratio : {1.0, 0.97, 1.05}) {
        RotorFieldConfig config = sensing.field;
        config.strength_T *= strength_ratio;
        const RotorField field(config);
        Random random(23);
        double sum = 0.0;
        constexpr int Poses = 4000;
        for (int i = 0; i < Poses; ++i) {
            const Eigen::Matrix3d truth = rotationOf(drawn(random));
            const OrientationEstimate found =
                held.estimate(field.readings_T(truth, sensing.poses) + noise_T(random, 100e-6));
            EXPECT_EQ(found.freedom, 6);
            sum += found.chiSquare;
        }
        if (strength_ratio == 1.0) {
            EXPECT_NEAR(sum / Poses, 6.0, 4.0 * std::sqrt(12.0 / Poses)); // 4 sigma of the mean
        } else {
            EXPECT_GT(sum / Poses, 1000.0); // 3 % of some 0.1 T in nine readings of 0.1 mT: thousands
        }
    }
}

TEST(TensorEstimator, refusesWhatCannotBeSensed) {
    SphericalSensing sensing;
    sensing.field.strength_T = -Q;
    EXPECT_EQ(OrientationEstimator::make(sensing, {}).error().code, ErrorCode::OutOfRange);
    sensing = {};
    sensing.deviation_T[3] = 0.0;
    EXPECT_EQ(OrientationEstimator::make(sensing, {}).error().code, ErrorCode::OutOfRange);
    sensing = {};
    sensing.field.harmonics = {{3, 1, 1e-3}};
    EXPECT_EQ(OrientationEstimator::make(sensing, {}).error().code, ErrorCode::OutOfRange);
    sensing = {};
    // Three sensors on one axis through the centre: radius 50, 60 and -50 mm.
    for (std::size_t i = 1; i < 3; ++i) {
        sensing.poses[i] = sensing.poses[0];
        sensing.poses[i].position_m.x() = i == 1 ? 0.06 : -0.05;
    }
    EXPECT_EQ(OrientationEstimator::make(sensing, {}).error().code, ErrorCode::OutOfRange);
    const OrientationEstimator estimator = estimatorOf(OrientationMethod::Tensor);
    EXPECT_EQ(estimator.estimate(SphericalReadings::Zero()).verdict, OrientationVerdict::NotDetermined);
    EXPECT_EQ(estimator.estimate(SphericalReadings::Constant(std::nan(""))).verdict,
              OrientationVerdict::NotDetermined);
}

} // namespace
} // namespace halbench::models
