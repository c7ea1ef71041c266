#pragma once

#include "control/base/random.h"
#include "models/planar/planar_geometry.h"

#include <Eigen/Core>
#include <array>

namespace halbench::models {

/// In-plane field of the matrix at a place of the platen, in platen axes, T:
///   B = R(-angle) (b sin(gamma X), b sin(gamma Y)),   (X, Y) = (x, y) + R(angle) place.
/// Pure sines: at the height of the chips the fifth harmonic is 6e-7 of the first.
/// Source: resources/help/planar-theory.md section 7.
Eigen::Vector2d chipField_T(double waveNumber_per_m, double amplitude_T, const Eigen::Vector2d& place_m,
                            const PlanarPose& pose);

/// The same with its derivative: column = x, y, angle, in T/m, T/m, T/rad.
struct ChipFieldSlope {
    Eigen::Vector2d field_T;
    Eigen::Matrix<double, 2, 3> slope;
};
ChipFieldSlope chipFieldSlope(double waveNumber_per_m, double amplitude_T, const Eigen::Vector2d& place_m,
                              const PlanarPose& pose);

/// Height above the magnets at which the fundamental's in-plane amplitude is `amplitude_T`.
double chipHeight_m(const MagnetMatrix& matrix, double amplitude_T);

/// Field of one ampere in each coil at the chips, platen axes, T/A: rows Bx'1, By'1, Bx'2, ... By'3. By
/// Biot-Savart's law on rectangular turns, 4 x 4 Gauss sections of the winding.
Eigen::Matrix<double, FieldCount, CoilCount>
coilFieldAtChips_T_per_A(const PlanarGeometry& geometry,
                         const std::array<Eigen::Vector2d, ChipCount>& place_m, double chipHeight_m);

/// One two-axis Hall chip as built: field seen = sensitivity B + offset + noise, clipped at the range.
struct HallChip {
    Eigen::Vector2d place_m = Eigen::Vector2d::Zero();         ///< true place, platen axes
    double amplitude_T = 20e-3;                                ///< at its true height
    Eigen::Matrix2d sensitivity = Eigen::Matrix2d::Identity(); ///< gain errors, cross-axis shares
    Eigen::Vector2d offset_T = Eigen::Vector2d::Zero();
    double noise_T = 0.0;
    double range_T = 40e-3;
};

enum class ChipFault {
    None,
    Dead,   ///< no signal: reads zero field, without noise
    Stuck,  ///< repeats the last reading
    Clipped ///< saturates at half of the matrix' amplitude
};

/// What the chip reports for a field in platen axes; draws two normal numbers when noise_T is not zero.
/// `previous_T` is its last report.
Eigen::Vector2d chipReading_T(const HallChip& chip, const Eigen::Vector2d& field_T, ChipFault fault,
                              const Eigen::Vector2d& previous_T, Random& noise);

} // namespace halbench::models
