#pragma once

#include "models/fields/halbach_ring.h"

#include <Eigen/Core>
#include <vector>

namespace halbench::models {

/// A rectangular coil in the bore, coil axis radial along `axis_rad`: sides run along z, end turns
/// tangentially. The winding fills a window (tangential x radial); filaments of the window's sections carry
/// equal current. Source: resources/help/htm-theory.md sections 2 and 4.4 (the window and mean radius are
/// assumed, the mean width 12.68 mm is the one that gives 1.43e-2 N m/A).
struct RadialCoil {
    double turns = 105.0;
    double axis_rad = 0.0;
    double meanRadius_m = 15.6e-3;
    double meanWidth_m = 12.68e-3;   ///< tangential distance between the mid-lines of the two sides
    double activeLength_m = 38.1e-3; ///< axial length of every side; the end turns lie at its ends
    double windowTangential_m = 5.49e-3;
    double windowRadial_m = 11.75e-3;
};

/// One closed rectangular filament: corners (radius, +-halfWidth, +-halfLength) in the coil's frame.
struct CoilFilament {
    double radius_m = 0.0;
    double halfWidth_m = 0.0;
    double halfLength_m = 0.0;
    double turns = 0.0; ///< weight: its share of the coil's turns
};

/// Gauss-Legendre sections of the winding window, sections x sections filaments; the turns add up to
/// coil.turns.
std::vector<CoilFilament> coilFilaments(const RadialCoil& coil, int sections);

/// Torque per ampere on the rotor at angle psi, from the Lorentz force on the coil: every side contributes
/// +-integral of r B_r dz, every end turn +-integral of t B_z dt. Equals d(flux linkage)/d(psi).
double rotorTorque_Nm_per_A(const RadialCoil& coil, const HalbachRing& ring, double psi_rad,
                            int sections = 3);

/// Flux linkage at rotor angle psi, Wb: turns x integral of the field through each filament's plane.
double coilFluxLinkage_Wb(const RadialCoil& coil, const HalbachRing& ring, double psi_rad, int sections = 3);

/// Field of the coil itself for 1 A, T/A, by Biot-Savart on straight filaments, in the frame the coil is
/// placed in.
Eigen::Vector3d coilField_T_per_A(const RadialCoil& coil, const Eigen::Vector3d& point_m, int sections = 8);

/// Amplitude and harmonics of a phase's torque over one turn of the rotor: two opposite coils in series.
struct TorqueConstant {
    double fundamental_Nm_per_A = 0.0; ///< phi
    double third_ratio = 0.0;          ///< of the fundamental
    double fifth_ratio = 0.0;
};
TorqueConstant phaseTorqueConstant(const RadialCoil& coil, const HalbachRing& ring, int sections = 3);

/// The whole-turn formula in a uniform field: phi = 2 N B L w.
double uniformFieldTorqueConstant_Nm_per_A(const RadialCoil& coil, double field_T);

} // namespace halbench::models
