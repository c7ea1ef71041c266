#include "control/base/units.h"
#include "models/fields/coil.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace halbench::models {
namespace {

/// The nominal ring, scaled so that a sensor in the mid-plane at 14.5 mm sees 157 mT radially.
HalbachRing scaledRing() {
    HalbachRing ring;
    ring.remanence_T = 0.157 / magnetsField_T(ringMagnets(ring, 0.0), Eigen::Vector3d(14.5e-3, 0, 0)).x();
    return ring;
}

TEST(RadialCoil, uniformFieldFormulaGivesTheOnlyWidthTheNumbersContain) {
    RadialCoil coil;
    coil.meanWidth_m = 11.38e-3;
    EXPECT_NEAR(uniformFieldTorqueConstant_Nm_per_A(coil, 0.157), 1.43e-2, 5e-6);
}

TEST(RadialCoil, lorentzForceEqualsTheSlopeOfTheFluxLinkage) {
    const HalbachRing ring = scaledRing();
    RadialCoil coil;
    coil.axis_rad = 0.3;
    for (const double psi : {0.1, 1.0, 2.5}) {
        const auto slope = [&](double h) {
            return (coilFluxLinkage_Wb(coil, ring, psi + h, 2) - coilFluxLinkage_Wb(coil, ring, psi - h, 2)) /
                   (2.0 * h);
        };
        const double richardson = (4.0 * slope(2e-3) - slope(4e-3)) / 3.0;
        EXPECT_NEAR(rotorTorque_Nm_per_A(coil, ring, psi, 2) / richardson, 1.0, 1e-6);
    }
}

TEST(RadialCoil, referenceCoilGivesTheTorqueConstant) {
    const HalbachRing ring = scaledRing();
    RadialCoil coil;
    // 1.43e-2 for a mean width of 12.68 +- 0.1 mm
    coil.meanWidth_m = 12.58e-3;
    EXPECT_LT(phaseTorqueConstant(coil, ring).fundamental_Nm_per_A, 1.43e-2);
    coil.meanWidth_m = 12.78e-3;
    EXPECT_GT(phaseTorqueConstant(coil, ring).fundamental_Nm_per_A, 1.43e-2);
    coil.meanWidth_m = 12.68e-3;
    const TorqueConstant reference = phaseTorqueConstant(coil, ring);
    EXPECT_NEAR(reference.fifth_ratio, 0.34e-2, 5e-5);
    // Quoted 0.09 % is not reproduced: the 3rd is 0.005 % by force and by flux. 0.09 % is the size of the
    // 21st, which 24 samples per turn fold onto the 3rd.
    EXPECT_LT(reference.third_ratio, 1e-4);
    // Quoted 1.3524e-2 for 12.0 mm; how finely the quoted sum divided the winding is not stated. 2 x 2
    // filaments give 1.3521e-2, the limit of many 1.3563e-2: half a per cent, the same as the +-0.1 mm above.
    coil.meanWidth_m = 12.0e-3;
    EXPECT_NEAR(phaseTorqueConstant(coil, ring).fundamental_Nm_per_A, 1.3524e-2, 5e-3 * 1.3524e-2);
}

TEST(RadialCoil, torqueHarmonicsAgreeWithThoseOfTheFluxLinkage) {
    const HalbachRing ring = scaledRing();
    const RadialCoil coil;
    const TorqueConstant torque = phaseTorqueConstant(coil, ring, 2);
    std::complex<double> first;
    std::complex<double> fifth;
    for (int i = 0; i < 12; ++i) {
        const double psi = 2.0 * Pi * i / 12;
        const double linkage_Wb =
            coilFluxLinkage_Wb(coil, ring, psi, 2) - coilFluxLinkage_Wb(coil, ring, psi + Pi, 2);
        first += std::polar(linkage_Wb / 6.0, psi);
        fifth += std::polar(linkage_Wb / 6.0, 5.0 * psi);
    }
    // d/dpsi multiplies order n by n.
    EXPECT_NEAR(torque.fundamental_Nm_per_A / std::abs(first), 1.0, 1e-5);
    EXPECT_NEAR(torque.fifth_ratio, 5.0 * std::abs(fifth) / std::abs(first), 1e-5);
}

TEST(RadialCoil, endTurnsTakeAFewPerCent) {
    const HalbachRing ring = scaledRing();
    const RadialCoil coil;
    // Sides alone: r B_r integrated along z, at the angle of largest torque, one coil twice.
    double sides = 0.0;
    const auto magnets = ringMagnets(ring, 0.5 * Pi);
    for (const CoilFilament& filament : coilFilaments(coil, 3)) {
        const int parts = 200;
        for (int i = 0; i < parts; ++i) {
            const double z_m = filament.halfLength_m * ((2.0 * i + 1.0) / parts - 1.0);
            for (const double side : {-1.0, 1.0}) {
                const Eigen::Vector3d point_m(filament.radius_m, side * filament.halfWidth_m, z_m);
                const Eigen::Vector3d field_T = magnetsField_T(magnets, point_m);
                sides -= side * filament.turns * 2.0 * filament.halfLength_m / parts *
                         (point_m.x() * field_T.x() + point_m.y() * field_T.y());
            }
        }
    }
    const double share = rotorTorque_Nm_per_A(coil, ring, 0.5 * Pi) / sides;
    EXPECT_LT(share, 0.99);
    EXPECT_GT(share, 0.95);
}

TEST(RadialCoil, biotSavartGivesTheQuotedStrayFieldInsideTheCoil) {
    // Both coils of the phase at 4 A; the stated 10 mT is not what coplanar sensor and coil would give.
    const RadialCoil coil;
    RadialCoil opposite;
    opposite.axis_rad = Pi;
    const Eigen::Vector3d sensor_m(14.5e-3, 0, 0);
    const double own_T = 4.0 * coilField_T_per_A(coil, sensor_m).x();
    const double other_T = -4.0 * coilField_T_per_A(opposite, sensor_m).x();
    EXPECT_NEAR(own_T + other_T, 23.8e-3, 0.5e-3);
}

TEST(RadialCoil, fieldOnTheAxisOfASquareLoopIsTheTextbookOne) {
    RadialCoil loop;
    loop.turns = 1.0;
    loop.meanRadius_m = 0.0;
    loop.meanWidth_m = 0.02;
    loop.activeLength_m = 0.02;
    loop.windowTangential_m = 0.0;
    loop.windowRadial_m = 0.0;
    // Centre of a square of side a: B = 2 sqrt(2) mu0 I / (pi a)
    EXPECT_NEAR(coilField_T_per_A(loop, Eigen::Vector3d::Zero(), 1).x(), 2.0 * std::sqrt(2.0) * 4e-7 / 0.02,
                1e-16);
}

TEST(RadialCoil, holdsTheCopperOfThePublication) {
    // Section 2: 10.42 cm^3 in the active sides of four coils, 53 % of the winding window. AWG 22 is 0.6438
    // mm thick: 0.127 mm * 92^((36 - 22)/39).
    const RadialCoil coil;
    const double wire_m2 = Pi / 4.0 * std::pow(0.127e-3 * std::pow(92.0, 14.0 / 39.0), 2);
    EXPECT_NEAR(4.0 * 2.0 * coil.turns * wire_m2 * coil.activeLength_m, 10.42e-6, 0.005e-6);
    EXPECT_NEAR(coil.turns * wire_m2 / (coil.windowTangential_m * coil.windowRadial_m), 0.53, 0.005);
}

TEST(RadialCoil, filamentsCarryAllTurns) {
    double turns = 0.0;
    double radius_m = 0.0;
    for (const CoilFilament& filament : coilFilaments(RadialCoil{}, 4)) {
        turns += filament.turns;
        radius_m += filament.turns * filament.radius_m / 105.0;
    }
    EXPECT_NEAR(turns, 105.0, 1e-11);
    EXPECT_NEAR(radius_m, 15.6e-3, 1e-15);
}

} // namespace
} // namespace halbench::models
