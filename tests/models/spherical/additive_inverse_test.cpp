#include "models/spherical/additive_inverse.h"
#include "models/spherical/rotor_motion.h"
#include "tests/models/spherical/orientation_cases.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

double additiveError_rad(const OrientationAngles& found, const OrientationAngles& truth) {
    return symmetricError_rad(rotationOf(found), rotationOf(truth));
}

TEST(AdditiveInverse, everyPoseOfTheAdditiveModelIsFound) {
    const AdditiveModel model;
    Random random(41);
    for (int i = 0; i < 20000; ++i) {
        OrientationAngles truth = drawn(random);
        truth.alpha_rad *= 3.9; // the whole circle and |beta| < 88 degrees
        truth.beta_rad *= 1.95;
        const OrientationAngles found = additiveInverse(model.strength_T, additiveReadings_T(model, truth));
        ASSERT_LT(radiansToDegrees(additiveError_rad(found, truth)), 1e-9);
    }
}

// Section 7 of resources/help/spherical-theory.md; 2 %, of which the sample takes 0.5.
TEST(AdditiveInverse, noiseErrorsAreThoseOfTheTable) {
    const AdditiveModel model;
    for (const auto& [deviation_T, closed_deg, fitted_deg] :
         {std::array{25e-6, 0.0129, 0.0085}, {100e-6, 0.0516, 0.0341}, {1e-3, 0.516, 0.341}}) {
        Random random(42);
        RootMeanSquare closed;
        RootMeanSquare fitted;
        for (int i = 0; i < 20000; ++i) {
            const OrientationAngles truth = drawn(random);
            const SphericalReadings readings_T =
                additiveReadings_T(model, truth) + noise_T(random, deviation_T);
            const OrientationAngles start = additiveInverse(model.strength_T, readings_T);
            const AdditiveFit fit = fitAdditiveModel(model, readings_T, start);
            EXPECT_TRUE(fit.hasConverged);
            closed.add(additiveError_rad(start, truth));
            fitted.add(additiveError_rad(fit.angles, truth));
        }
        EXPECT_NEAR(radiansToDegrees(closed.value()), closed_deg, 0.02 * closed_deg);
        EXPECT_NEAR(radiansToDegrees(fitted.value()), fitted_deg, 0.02 * fitted_deg);
    }
}

/// rms error of the additive estimators against the exact device at a tilt (or over the workspace when 0).
std::pair<double, double> crossedError_deg(double tilt_deg, int count) {
    const RotorField field({Q, 0.05, {}});
    const SensorPoses poses = sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05);
    const AdditiveModel model;
    Random random(43);
    RootMeanSquare closed;
    RootMeanSquare fitted;
    for (int i = 0; i < count; ++i) {
        OrientationAngles truth = drawn(random);
        if (tilt_deg > 0.0) {
            truth =
                anglesForShaft({degreesToRadians(tilt_deg), 2.0 * Pi * random.uniform()}, truth.gamma_rad);
        }
        const SphericalReadings readings_T = field.readings_T(rotationOf(truth), poses);
        const OrientationAngles start = additiveInverse(Q, readings_T);
        closed.add(additiveError_rad(start, truth));
        if (tilt_deg == 0.0) {
            fitted.add(additiveError_rad(searchAdditiveModel(model, readings_T).angles, truth));
        }
    }
    return {radiansToDegrees(closed.value()), tilt_deg == 0.0 ? radiansToDegrees(fitted.value()) : 0.0};
}

// Section 4 of resources/help/spherical-theory.md: three digits printed, and the sample scatters by 1 %.
TEST(AdditiveInverse, crossedWithTheExactDeviceItHasTheKnownErrors) {
    for (const auto& [tilt_deg, known_deg] :
         {std::pair{1.0, 0.54}, {2.0, 1.09}, {5.0, 2.69}, {10.0, 5.37}, {20.0, 10.6}, {30.0, 15.8}}) {
        EXPECT_NEAR(crossedError_deg(tilt_deg, 20000).first, known_deg, 0.03 * known_deg) << tilt_deg;
    }
    const auto [closed_deg, fitted_deg] = crossedError_deg(0.0, 5000);
    EXPECT_NEAR(closed_deg, 18.9, 0.03 * 18.9);
    EXPECT_NEAR(fitted_deg, 24.6, 0.05 * 24.6);
}

// Section 5.6 of resources/help/spherical-theory.md: shares of the workspace; 20000 draws scatter by 0.35
// points.
TEST(AdditiveInverse, mainSensorAloneIsAmbiguousInMostOfTheWorkspace) {
    constexpr int Poses = 20000;
    Random random(44);
    int any = 0;
    int sameSign = 0;
    int mainOnly = 0;
    int mainOnlyAmbiguous = 0;
    for (int i = 0; i < Poses; ++i) {
        const OrientationAngles angles = drawn(random);
        const SphericalReadings readings_T = additiveReadings_T({}, angles);
        bool isAmbiguous = false;
        for (const OrientationAngles& other : sameMainReadings(angles)) {
            EXPECT_LT((additiveReadings_T({}, other) - readings_T).head<3>().norm(), 1e-14);
            const bool isInside = isInWorkspace(other);
            isAmbiguous = isAmbiguous || isInside;
            sameSign += isInside && other.beta_rad * angles.beta_rad > 0.0;
        }
        const bool isMainOnly = readings_T.head<3>().cwiseAbs().minCoeff() >= 0.01;
        any += isAmbiguous;
        mainOnly += isMainOnly;
        mainOnlyAmbiguous += isMainOnly && isAmbiguous;
    }
    EXPECT_NEAR(static_cast<double>(any) / Poses, 0.627, 0.011);
    EXPECT_NEAR(static_cast<double>(sameSign) / Poses, 0.101, 0.007);
    EXPECT_NEAR(static_cast<double>(mainOnly) / Poses, 0.856, 0.008);
    EXPECT_NEAR(static_cast<double>(mainOnlyAmbiguous) / Poses, 0.493, 0.011);
}

} // namespace
} // namespace halbench::models
