#include "control/base/units.h"
#include "models/fields/halbach_ring.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double SensorRadius_m = 14.5e-3;

struct RingFigures {
    double centre_T;
    double radial_ratio;
    double tangential_ratio;
    double axisEnd_ratio;
};

HalbachRing ringOf(double radius_mm) {
    HalbachRing ring;
    ring.radius_m = 1e-3 * radius_mm;
    return ring;
}

RingFigures figuresOf(const HalbachRing& ring) {
    const auto magnets = ringMagnets(ring, 0.0);
    const double centre_T = magnetsField_T(magnets, Vector3d::Zero()).x();
    return {centre_T, magnetsField_T(magnets, Vector3d(SensorRadius_m, 0, 0)).x() / centre_T,
            magnetsField_T(magnets, Vector3d(0, SensorRadius_m, 0)).x() / centre_T,
            magnetsField_T(magnets, Vector3d(0, 0, 19.05e-3)).x() / centre_T};
}

struct ReferenceRow {
    double radius_mm;
    double centre3D_T, centre2D_T;
    double centreRemanence_T, sensorRemanence_T, remanence2D_T;
    double radial, tangential, axisEnd;
};

class RingReference : public ::testing::TestWithParam<ReferenceRow> {};

TEST_P(RingReference, meetsTheQuotedNumbers) {
    const ReferenceRow& row = GetParam();
    const HalbachRing ring = ringOf(row.radius_mm);
    const RingFigures figures = figuresOf(ring);
    EXPECT_NEAR(figures.centre_T, row.centre3D_T, 2e-5);
    EXPECT_NEAR(rodsCentreField_T(ring), row.centre2D_T, 2e-5);
    EXPECT_NEAR(longBarsField_T(ringMagnets(ring, 0.0), Vector2d::Zero()).x(), row.centre2D_T, 2e-5);
    EXPECT_NEAR(0.157 / figures.centre_T, row.centreRemanence_T, 2e-3);
    EXPECT_NEAR(0.157 / (figures.centre_T * figures.radial_ratio), row.sensorRemanence_T, 2e-3);
    EXPECT_NEAR(0.157 / rodsCentreField_T(ring), row.remanence2D_T, 2e-3);
    EXPECT_NEAR(figures.radial_ratio, row.radial, 5e-4);
    EXPECT_NEAR(figures.tangential_ratio, row.tangential, 5e-4);
    EXPECT_NEAR(figures.axisEnd_ratio, row.axisEnd, 5e-4);
}

INSTANTIATE_TEST_SUITE_P(
    Rings, RingReference,
    ::testing::Values(ReferenceRow{33.710, 0.07690, 0.11295, 2.042, 1.743, 1.390, 1.1711, 1.0558, 0.6713},
                      ReferenceRow{35.025, 0.06952, 0.10463, 2.258, 1.934, 1.501, 1.1679, 1.0547, 0.6814},
                      ReferenceRow{30.000, 0.10408, 0.14261, 1.509, 1.284, 1.101, 1.1751, 1.0574, 0.6417}));

TEST(HalbachRing, realMagnetsCannotReachTheStatedField) {
    const RingFigures figures = figuresOf(ringOf(33.710));
    EXPECT_NEAR(1.32 * figures.centre_T, 101.5e-3, 5e-5);
    EXPECT_NEAR(1.32 * figures.centre_T * figures.radial_ratio, 118.9e-3, 5e-5);
    EXPECT_FALSE(isRemanenceReal(0.157 / (figures.centre_T * figures.radial_ratio)));
    // A smaller ring could: 1.32 T reach 157 mT at the centre for 28.5 mm, at the sensor for about 30.3 mm.
    EXPECT_NEAR(1.32 * figuresOf(ringOf(28.5)).centre_T, 0.157, 7e-4); // 0.05 mm of radius
    const RingFigures sensor = figuresOf(ringOf(30.3));
    EXPECT_NEAR(1.32 * sensor.centre_T * sensor.radial_ratio, 0.157, 7e-4);
}

TEST(HalbachRing, barsFitDownToTheQuotedRadius) {
    EXPECT_FALSE(doBarsOverlap(ringOf(33.71)));
    EXPECT_FALSE(doBarsOverlap(ringOf(27.35)));
    EXPECT_TRUE(doBarsOverlap(ringOf(27.2)));
}

TEST(HalbachRing, longRingIsUniformTheRealOneIsNot) {
    const auto magnets = ringMagnets(ringOf(33.71), 0.0);
    const double centre_T = longBarsField_T(magnets, Vector2d::Zero()).x();
    // Two-dimensional: within 0.05 % at the sensors (5th order (14.5/33.7)^4 of a small bar harmonic).
    EXPECT_NEAR(longBarsField_T(magnets, Vector2d(SensorRadius_m, 0)).x() / centre_T, 1.0, 5e-4);
    EXPECT_NEAR(longBarsField_T(magnets, Vector2d(0, SensorRadius_m)).x() / centre_T, 1.0, 5e-4);
}

TEST(HalbachRing, idealCylinderWithAverageRemanenceAgreesWithTheBars) {
    const double outer_m = 38.2e-3;
    const double inner_m = 31.85e-3;
    const HalbachRing ring = ringOf(35.025);
    EXPECT_NEAR(magnetAreaFraction(ring, outer_m, inner_m), 0.577, 5e-4);
    const double ideal_T = idealCylinderField_T(0.577, outer_m, inner_m);
    EXPECT_NEAR(ideal_T, 0.1049, 5e-5);
    EXPECT_NEAR(ideal_T / longBarsField_T(ringMagnets(ring, 0.0), Vector2d::Zero()).x(), 1.0, 3.5e-3);
}

TEST(HalbachRing, fieldAtTheSensorsGrowsByTwoPercentPerMillimetre) {
    // What models/plants takes for the radius error of a sensor: 0.171 (r/14.5 mm)^2 of the centre field
    // makes 2 * 0.171/1.171/14.5 mm = 20 per metre; higher orders in r add a few per cent to that.
    const auto magnets = ringMagnets(HalbachRing{}, 0.0);
    const auto radial_T = [&](double radius_m) {
        return magnetsField_T(magnets, Vector3d(radius_m, 0, 0)).x();
    };
    const double slope_T_per_m = (radial_T(SensorRadius_m + 1e-4) - radial_T(SensorRadius_m - 1e-4)) / 2e-4;
    EXPECT_NEAR(slope_T_per_m / radial_T(SensorRadius_m), 20.0, 2.0);
}

TEST(HalbachRing, magnetVolumeIsTheQuotedOne) {
    const HalbachRing ring;
    EXPECT_NEAR(ring.bars * 8.0 * ring.halfSize_m.prod(), 30.73e-6, 5e-9);
}

TEST(HalbachRing, barsMakeTheirShareOfTheRotorsInertia) {
    // Section 5: 2.6e-4 kg m^2. NdFeB has 7.5 g/cm^3; a square bar adds m a^2/6 about its own axis.
    const HalbachRing ring;
    const double mass_kg = 7500.0 * ring.bars * 8.0 * ring.halfSize_m.prod();
    const double side_m = 2.0 * ring.halfSize_m.x();
    EXPECT_NEAR(mass_kg * (ring.radius_m * ring.radius_m + side_m * side_m / 6.0), 2.6e-4, 0.05e-4);
}

TEST(HalbachRing, turningTheRotorTurnsTheFieldMap) {
    Random random(3);
    const HalbachRing ring = scatteredRing(HalbachRing{}, RingScatter{}, random);
    const double psi = 0.77;
    const Eigen::Matrix3d turn =
        (Eigen::Matrix3d() << std::cos(psi), -std::sin(psi), 0, std::sin(psi), std::cos(psi), 0, 0, 0, 1)
            .finished();
    for (const Vector3d& point_m :
         {Vector3d(0.01, 0.004, 0.003), Vector3d(-0.014, 0.0, -0.01), Vector3d(0, 0, 0)}) {
        const Vector3d turned_T = magnetsField_T(ringMagnets(ring, psi), turn * point_m);
        EXPECT_LT((turned_T - turn * magnetsField_T(ringMagnets(ring, 0.0), point_m)).norm(), 1e-14);
    }
}

TEST(HalbachRing, scatterHasTheConfiguredSpreadAndFollowsItsSeed) {
    Random random(11);
    double remanence = 0.0;
    double angle = 0.0;
    const int rings = 200;
    for (int i = 0; i < rings; ++i) {
        for (const BarDeviation& bar : scatteredRing(HalbachRing{}, RingScatter{}, random).deviations) {
            remanence += bar.remanence_ratio * bar.remanence_ratio;
            angle += bar.angle_rad * bar.angle_rad;
        }
    }
    // rms of 4000 draws: 1.1 % of itself; four of that
    EXPECT_NEAR(std::sqrt(remanence / (20 * rings)), 0.02, 0.045 * 0.02);
    EXPECT_NEAR(radiansToDegrees(std::sqrt(angle / (20 * rings))), 1.0, 0.045);
    Random one(5);
    Random two(5);
    EXPECT_EQ(scatteredRing(HalbachRing{}, RingScatter{}, one).deviations[7].angle_rad,
              scatteredRing(HalbachRing{}, RingScatter{}, two).deviations[7].angle_rad);
}

} // namespace
} // namespace halbench::models
