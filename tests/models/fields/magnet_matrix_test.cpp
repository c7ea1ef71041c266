#include "models/fields/magnet_matrix.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const MagnetMatrix Published;

// Expected values: resources/help/planar-theory.md section 4, printed with six to eight digits.
TEST(MagnetMatrix, amplitudesAreThoseOfTheTheoryPage) {
    EXPECT_NEAR(waveNumber_per_m(Published), 123.68475, 5e-6);
    EXPECT_NEAR(harmonicAmplitude_T(Published, 1, 0.0), 0.509909, 5e-7);
    EXPECT_NEAR(harmonicAmplitude_T(Published, 1, 3e-3), 0.351840, 5e-7);
    EXPECT_LT(harmonicAmplitude_T(Published, 5, 3e-3), 0.0);
    EXPECT_GT(harmonicAmplitude_T(Published, 9, 3e-3), 0.0);
}

TEST(MagnetMatrix, largestFieldAtThreeMillimetresIsAboutSevenTenthsOfATesla) {
    EXPECT_NEAR(matrixField_T(Published, Vector3d(0.0, 0.0, 3e-3), 1).z(), 0.70368, 5e-6);
    EXPECT_NEAR(matrixField_T(Published, Vector3d(0.0, 0.0, 3e-3), 20).z(), 0.66781, 5e-6);
}

TEST(MagnetMatrix, fieldMeetsTheTestVector) {
    const Vector3d field_T = matrixField_T(Published, Vector3d(4e-3, -9e-3, 5e-3));
    EXPECT_NEAR(field_T.x(), 0.12656123, 5e-9);
    EXPECT_NEAR(field_T.y(), -0.25015357, 5e-9);
    EXPECT_NEAR(field_T.z(), 0.36306519, 5e-9);
}

TEST(MagnetMatrix, gradientIsThatOfFiniteDifferencesAndHasNeitherDivergenceNorCurl) {
    // Fourth-order differences with h = 50 um: error h^4 (9 gamma)^4/30 = 3e-7 of the ninth order's slope,
    // which is 5 % of the first's at 3 mm.
    const double h = 5e-5;
    for (const Vector3d& point_m :
         {Vector3d(4e-3, -9e-3, 5e-3), Vector3d(21e-3, 3e-3, 3e-3), Vector3d(-70e-3, 11e-3, 12e-3)}) {
        Matrix3d differences;
        for (int j = 0; j < 3; ++j) {
            const Vector3d step_m = h * Vector3d::Unit(j);
            const auto at = [&](double steps) { return matrixField_T(Published, point_m + steps * step_m); };
            differences.col(j) = (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * h);
        }
        const Matrix3d gradient = matrixFieldGradient_T_per_m(Published, point_m);
        const double scale = gradient.norm();
        EXPECT_LT((differences - gradient).norm(), 1e-7 * scale);
        EXPECT_LT(std::fabs(gradient.trace()), 1e-12 * scale);
        EXPECT_LT((gradient - gradient.transpose()).norm(), 1e-12 * scale);
    }
}

TEST(MagnetMatrix, fieldRepeatsAfterAPitchAndTheInPlanePartTurnsAfterHalfAPitch) {
    const Vector3d point_m(7e-3, -3e-3, 4e-3);
    const Vector3d here_T = matrixField_T(Published, point_m);
    const Vector3d pitch_T = matrixField_T(Published, point_m + Vector3d(Published.pitch_m, 0.0, 0.0));
    const Vector3d half_T = matrixField_T(Published, point_m + Vector3d(0.5 * Published.pitch_m, 0.0, 0.0));
    EXPECT_LT((pitch_T - here_T).norm(), 1e-13);
    EXPECT_NEAR(half_T.x(), -here_T.x(), 1e-13);
    EXPECT_NEAR(half_T.y(), here_T.y(), 1e-15);
}

TEST(MagnetMatrix, fifthHarmonicIsGoneAtTheHallSensors) {
    const double height_m = 26.18e-3;
    // The height is printed to 10 um: 5 um x gamma x 20 mT.
    EXPECT_NEAR(harmonicAmplitude_T(Published, 1, height_m), 20e-3, 13e-6);
    EXPECT_LT(
        std::fabs(harmonicAmplitude_T(Published, 5, height_m) / harmonicAmplitude_T(Published, 1, height_m)),
        1e-6);
}

} // namespace
} // namespace halbench::models
