#include "models/planar/hall_chip.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace halbench::models {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const PlanarGeometry Nominal;
const double Gamma = waveNumber_per_m(Nominal.matrix);
const std::array<Vector2d, ChipCount> Places = {
    {{-63.5e-3, -19.05e-3}, {63.5e-3, -19.05e-3}, {0.0, 19.05e-3}}};

// Check values of the theory page, section 7, mT with seven decimals.
TEST(HallChip, fieldsMeetTheCheckValues) {
    const std::array<Vector2d, ChipCount> level_mT = {
        {{-19.3911973, -8.0517890}, {19.3911973, -8.0517890}, {4.8970876, 18.3076130}}};
    const std::array<Vector2d, ChipCount> turned_mT = {
        {{-6.3433533, -18.7137777}, {6.0469347, -19.5325259}, {18.8134548, 5.5827933}}};
    for (std::size_t i = 0; i < Places.size(); ++i) {
        EXPECT_LT((1e3 * chipField_T(Gamma, 20e-3, Places[i], {2e-3, -3e-3, 0.0}) - level_mT[i]).norm(),
                  1e-7);
        EXPECT_LT((1e3 * chipField_T(Gamma, 20e-3, Places[i], {10e-3, 4e-3, 8e-3}) - turned_mT[i]).norm(),
                  1e-7);
    }
}

TEST(HallChip, readsTheFieldOfTheMatrixAtItsHeight) {
    // Second route: the whole field of the matrix, turned into platen axes. Fifth harmonic: 6e-7 of 20 mT.
    const double height_m = chipHeight_m(Nominal.matrix, 20e-3);
    EXPECT_NEAR(height_m, 26.18e-3, 5e-6);
    const PlanarPose pose{7e-3, -12e-3, 0.2};
    for (const Vector2d& place_m : Places) {
        const Vector2d point_m = Vector2d(pose.x_m, pose.y_m) + Eigen::Rotation2Dd(pose.angle_rad) * place_m;
        const Vector3d field_T = matrixField_T(Nominal.matrix, {point_m.x(), point_m.y(), height_m});
        const Vector2d expected_T = Eigen::Rotation2Dd(-pose.angle_rad) * Vector2d(field_T.head<2>());
        EXPECT_LT((chipField_T(Gamma, 20e-3, place_m, pose) - expected_T).norm(), 2e-8);
    }
}

TEST(HallChip, slopeIsThatOfFiniteDifferences) {
    const PlanarPose pose{7e-3, -12e-3, 0.013};
    const double h = 1e-5;
    for (const Vector2d& place_m : Places) {
        const ChipFieldSlope slope = chipFieldSlope(Gamma, 20e-3, place_m, pose);
        const auto at = [&](double x, double y, double angle) {
            return chipField_T(Gamma, 20e-3, place_m, {pose.x_m + x, pose.y_m + y, pose.angle_rad + angle});
        };
        EXPECT_LT((slope.field_T - at(0, 0, 0)).norm(), 1e-16);
        // Central differences: (gamma h)^2/6 = 2.6e-7 of 2.5 T/m.
        EXPECT_LT((slope.slope.col(0) - (at(h, 0, 0) - at(-h, 0, 0)) / (2 * h)).norm(), 1e-6);
        EXPECT_LT((slope.slope.col(1) - (at(0, h, 0) - at(0, -h, 0)) / (2 * h)).norm(), 1e-6);
        EXPECT_LT((slope.slope.col(2) - (at(0, 0, h) - at(0, 0, -h)) / (2 * h)).norm(), 1e-6);
    }
}

TEST(HallChip, coilsReachTheChipsAsMuchAsTheTheorySays) {
    const auto crosstalk = coilFieldAtChips_T_per_A(Nominal, Places, chipHeight_m(Nominal.matrix, 20e-3));
    // Section 7: up to 0.60 mT/A, between coil 1 and chip 1 (two digits).
    const double nearest = crosstalk.block<2, 1>(0, 0).cwiseAbs().maxCoeff();
    EXPECT_NEAR(nearest, 0.60e-3, 5e-6);
    EXPECT_DOUBLE_EQ(crosstalk.cwiseAbs().maxCoeff(), nearest);
}

TEST(HallChip, farAwayACoilIsADipole) {
    // Second route: moment m = turns-weighted area; B = mu0/(4 pi r^3) (3 (m r^) r^ - m). At 2 m and a coil
    // of 50 mm the quadrupole-free remainder is (0.05/2)^2 = 6e-4.
    PlanarGeometry geometry;
    const double a = geometry.winding.width_m;
    const double p = geometry.longStraight_m();
    const double q = geometry.shortStraight_m();
    const double area_m2 = p * q + a * (p + q) + 4.0 * a * a / 3.0; // sharp corners, mean over the turns
    const double turns = geometry.winding.turnsPerWidth_1_m * a * geometry.winding.layersPerHeight_1_m *
                         geometry.winding.height_m;
    const auto coils = geometry.coils();
    const std::array<Vector2d, ChipCount> far = {{{1.5, 0.3}, {-1.0, 1.2}, {0.2, -1.8}}};
    const auto field = coilFieldAtChips_T_per_A(geometry, far, 1.0);
    for (const int k : {0, 4}) {
        const PlanarCoil& coil = coils[static_cast<std::size_t>(k)];
        for (int j = 0; j < ChipCount; ++j) {
            const Vector2d away = far[static_cast<std::size_t>(j)] - coil.centre_m;
            const Vector3d r(away.x(), away.y(), 1.0 - geometry.gap_m - 0.5 * geometry.winding.height_m);
            const Vector3d m(0.0, 0.0, coil.sense * turns * area_m2);
            const Vector3d B =
                1e-7 / std::pow(r.norm(), 3) * (3.0 * r.normalized() * r.normalized().dot(m) - m);
            EXPECT_LT((field.block<2, 1>(2 * j, k) - B.head<2>()).norm(), 1e-3 * B.norm());
        }
    }
}

TEST(HallChip, errorsAndLimitsActInTheirOrder) {
    HallChip chip;
    chip.sensitivity << 1.01, 0.003, -0.002, 0.98;
    chip.offset_T = {1e-4, -2e-4};
    Random noise(1);
    const Vector2d field_T(10e-3, -15e-3);
    const Vector2d previous_T(1e-3, 2e-3);
    const Vector2d expected_T(10e-3 * 1.01 - 15e-3 * 0.003 + 1e-4, -10e-3 * 0.002 - 15e-3 * 0.98 - 2e-4);
    EXPECT_LT((chipReading_T(chip, field_T, ChipFault::None, previous_T, noise) - expected_T).norm(), 1e-17);
    EXPECT_EQ(chipReading_T(chip, field_T, ChipFault::Dead, previous_T, noise), Vector2d(0.0, 0.0));
    EXPECT_EQ(chipReading_T(chip, field_T, ChipFault::Stuck, previous_T, noise), previous_T);
    const Vector2d clipped_T = chipReading_T(chip, field_T, ChipFault::Clipped, previous_T, noise);
    EXPECT_EQ(clipped_T, Vector2d(10e-3, -10e-3));
    EXPECT_EQ(chipReading_T(chip, 10.0 * field_T, ChipFault::None, previous_T, noise),
              Vector2d(40e-3, -40e-3));
}

TEST(HallChip, noiseHasTheGivenSizeAndIsDrawnInEveryFault) {
    HallChip chip;
    chip.noise_T = 18e-6;
    Random noise(7);
    double square = 0.0;
    const int count = 20000;
    for (int i = 0; i < count; ++i) {
        square +=
            chipReading_T(chip, Vector2d::Zero(), ChipFault::None, Vector2d::Zero(), noise).squaredNorm();
    }
    // 40 000 numbers: the rms of a sample has a relative spread of 1/sqrt(80 000) = 0.35 %; three sigma.
    EXPECT_NEAR(std::sqrt(square / (2 * count)), 18e-6, 0.011 * 18e-6);
    Random healthy(3);
    Random dead(3);
    chipReading_T(chip, Vector2d::Zero(), ChipFault::None, Vector2d::Zero(), healthy);
    chipReading_T(chip, Vector2d::Zero(), ChipFault::Dead, Vector2d::Zero(), dead);
    EXPECT_EQ(healthy.bits(), dead.bits());
}

} // namespace
} // namespace halbench::models
