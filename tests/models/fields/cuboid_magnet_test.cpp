#include "models/fields/cuboid_magnet.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const Vector3d BarHalfSize_mm(3.175, 3.175, 19.05);

CuboidMagnet bar() {
    CuboidMagnet magnet;
    magnet.centre_m = Vector3d(1e-3, -2e-3, 0.5e-3);
    magnet.halfSize_m = 1e-3 * BarHalfSize_mm;
    magnet.angle_rad = 0.4;
    magnet.remanence_T = 1.3;
    return magnet;
}

/// Second route: the same magnet as surface charge on its two pole faces, summed by a fine midpoint rule.
Vector3d chargedFaces(const Vector3d& halfSize, const Vector3d& point, int parts) {
    Vector3d sum = Vector3d::Zero();
    const double dy = 2.0 * halfSize.y() / parts;
    const double dz = 2.0 * halfSize.z() / parts;
    for (const double side : {-1.0, 1.0}) {
        for (int i = 0; i < parts; ++i) {
            for (int k = 0; k < parts; ++k) {
                const Vector3d d = point - Vector3d(side * halfSize.x(), (i + 0.5) * dy - halfSize.y(),
                                                    (k + 0.5) * dz - halfSize.z());
                sum += side * dy * dz / (4.0 * M_PI) * d / std::pow(d.norm(), 3);
            }
        }
    }
    return sum;
}

/// Column j = dB/dx_j by central differences.
Eigen::Matrix3d gradient(const CuboidMagnet& magnet, const Vector3d& point_m) {
    const double h = 1e-6;
    Eigen::Matrix3d result;
    for (int j = 0; j < 3; ++j) {
        Vector3d step = Vector3d::Zero();
        step[j] = h;
        result.col(j) =
            (magnetField_T(magnet, point_m + step) - magnetField_T(magnet, point_m - step)) / (2.0 * h);
    }
    return result;
}

TEST(CuboidMagnet, meetsTheTestVector) {
    const Vector3d field = cuboidField(BarHalfSize_mm, Vector3d(5.0, 4.0, 7.0));
    EXPECT_NEAR(field.x(), 0.05339615, 5e-9);
    EXPECT_NEAR(field.y(), 0.16203944, 5e-9);
    EXPECT_NEAR(field.z(), 0.00503137, 5e-9);
}

TEST(CuboidMagnet, equalsItsChargedPoleFaces) {
    for (const Vector3d& point :
         {Vector3d(5.0, 4.0, 7.0), Vector3d(-9.0, 1.0, -20.0), Vector3d(0.0, 8.0, 3.0)}) {
        const Vector3d difference =
            cuboidField(BarHalfSize_mm, point) - chargedFaces(BarHalfSize_mm, point, 400);
        EXPECT_LT(difference.norm(), 1e-5); // midpoint rule on 0.016 x 0.095 mm patches
    }
}

TEST(CuboidMagnet, hasNeitherDivergenceNorCurlOutside) {
    const CuboidMagnet magnet = bar();
    for (const Vector3d& point_m :
         {Vector3d(9e-3, 1e-3, 3e-3), Vector3d(-4e-3, 7e-3, 22e-3), Vector3d(0, 0, -25e-3)}) {
        const Eigen::Matrix3d slope = gradient(magnet, point_m);
        // Central differences at 1 um leave h^2/6 B''' ~ 1e-12 * |slope|/mm^2 and rounding 1e-16/1e-6.
        const double tolerance = 1e-6 * slope.norm() + 1e-9;
        EXPECT_NEAR(slope.trace(), 0.0, tolerance);
        EXPECT_LT((slope - slope.transpose()).norm(), tolerance);
    }
}

TEST(CuboidMagnet, isLinearInRemanence) {
    CuboidMagnet magnet = bar();
    const Vector3d point_m(8e-3, 3e-3, 1e-3);
    const Vector3d one = magnetField_T(magnet, point_m);
    magnet.remanence_T *= -2.5;
    EXPECT_LT((magnetField_T(magnet, point_m) + 2.5 * one).norm(), 1e-15);
}

TEST(CuboidMagnet, looksLikeItsDipoleFromAfar) {
    const CuboidMagnet magnet = bar();
    double previous = 0.0;
    for (const double distance_m : {0.5, 1.0, 2.0}) {
        const Vector3d point_m = magnet.centre_m + distance_m * Vector3d(0.6, 0.48, 0.64);
        const Vector3d dipole_T = dipoleField_T(magnet, point_m);
        const double deviation = (magnetField_T(magnet, point_m) - dipole_T).norm() / dipole_T.norm();
        if (previous > 0.0) {
            // The next pole of a symmetric body is the octupole: relative deviation falls as 1/distance^2;
            // the pole after it still contributes (19 mm/500 mm)^2 = 0.15 %; far away the eight corner terms
            // cancel to 1e-8.
            EXPECT_NEAR(previous / deviation, 4.0, 0.02);
        }
        previous = deviation;
    }
}

TEST(CuboidMagnet, becomesTheLongBarWhenStretched) {
    CuboidMagnet magnet = bar();
    magnet.halfSize_m.z() = 10.0;
    const Vector3d stretched_T = magnetField_T(magnet, Vector3d(9e-3, 4e-3, 0.5e-3));
    const Vector2d long_T = longBarField_T(magnet, Vector2d(9e-3, 4e-3));
    EXPECT_LT((stretched_T.head<2>() - long_T).norm(), 1e-6); // ends 1000 widths away leave (10 mm/10 m)^2
}

TEST(CuboidMagnet, turnsWithItsAngle) {
    CuboidMagnet magnet = bar();
    magnet.centre_m.setZero();
    magnet.angle_rad = 0.0;
    const Vector3d point_m(8e-3, 3e-3, 1e-3);
    const Vector3d before_T = magnetField_T(magnet, point_m);
    const Eigen::Matrix3d turn =
        (Eigen::Matrix3d() << std::cos(0.9), -std::sin(0.9), 0, std::sin(0.9), std::cos(0.9), 0, 0, 0, 1)
            .finished();
    magnet.angle_rad = 0.9;
    EXPECT_LT((magnetField_T(magnet, turn * point_m) - turn * before_T).norm(), 1e-15);
}

TEST(CuboidMagnet, flagsRemanenceNobodySells) {
    EXPECT_TRUE(isRemanenceReal(1.48));
    EXPECT_FALSE(isRemanenceReal(1.743)); // what the printed 157 mT would need
}

} // namespace
} // namespace halbench::models
