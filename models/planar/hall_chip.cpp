#include "models/planar/hall_chip.h"

#include "control/base/units.h"

#include <Eigen/Geometry>
#include <cmath>

namespace halbench::models {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double PermeabilityOver4Pi = 1e-7;

// Field of one ampere along a straight filament, T/A.
Vector3d filamentField_T(const Vector3d& from_m, const Vector3d& to_m, const Vector3d& point_m) {
    const Vector3d a = point_m - from_m;
    const Vector3d b = point_m - to_m;
    const double na = a.norm();
    const double nb = b.norm();
    return PermeabilityOver4Pi * a.cross(b) * (na + nb) / (na * nb * (na * nb + a.dot(b)));
}

// One ampere counter-clockwise around a rectangle of half sizes (u, v) about the origin at height zero.
Vector3d rectangleField_T(const Vector2d& half_m, const Vector3d& point_m) {
    const std::array<Vector3d, 4> corner = {{{-half_m.x(), -half_m.y(), 0.0},
                                             {half_m.x(), -half_m.y(), 0.0},
                                             {half_m.x(), half_m.y(), 0.0},
                                             {-half_m.x(), half_m.y(), 0.0}}};
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < corner.size(); ++i) {
        sum += filamentField_T(corner[i], corner[(i + 1) % corner.size()], point_m);
    }
    return sum;
}

// Gauss-Legendre rule with four nodes on 0 ... 1.
constexpr std::array Place = {0.069431844202973712, 0.33000947820757187, 0.66999052179242813,
                              0.93056815579702629};
constexpr std::array Weight = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                               0.17392742256872693};

// `point_m` relative to the coil's centre, in its axes, height above its underside.
Vector3d coilField_T(const PlanarGeometry& geometry, const Vector3d& point_m) {
    const PlanarWinding& winding = geometry.winding;
    const double turns =
        winding.turnsPerWidth_1_m * winding.width_m * winding.layersPerHeight_1_m * winding.height_m;
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < Place.size(); ++i) {
        const double r_m = winding.width_m * Place[i];
        const Vector2d half_m(0.5 * geometry.longStraight_m() + r_m, 0.5 * geometry.shortStraight_m() + r_m);
        for (std::size_t j = 0; j < Place.size(); ++j) {
            const Vector3d layer_m(0.0, 0.0, winding.height_m * Place[j]);
            sum += Weight[i] * Weight[j] * turns * rectangleField_T(half_m, point_m - layer_m);
        }
    }
    return sum;
}

} // namespace

Vector2d chipField_T(double waveNumber_per_m, double amplitude_T, const Vector2d& place_m,
                     const PlanarPose& pose) {
    const double c = std::cos(pose.angle_rad);
    const double s = std::sin(pose.angle_rad);
    const double X_m = pose.x_m + c * place_m.x() - s * place_m.y();
    const double Y_m = pose.y_m + s * place_m.x() + c * place_m.y();
    const double Bx = amplitude_T * std::sin(waveNumber_per_m * X_m);
    const double By = amplitude_T * std::sin(waveNumber_per_m * Y_m);
    return {Bx * c + By * s, -Bx * s + By * c};
}

ChipFieldSlope chipFieldSlope(double waveNumber_per_m, double amplitude_T, const Vector2d& place_m,
                              const PlanarPose& pose) {
    const double c = std::cos(pose.angle_rad);
    const double s = std::sin(pose.angle_rad);
    const double armX_m = c * place_m.x() - s * place_m.y();
    const double armY_m = s * place_m.x() + c * place_m.y();
    const double phaseX = waveNumber_per_m * (pose.x_m + armX_m);
    const double phaseY = waveNumber_per_m * (pose.y_m + armY_m);
    const double Bx = amplitude_T * std::sin(phaseX);
    const double By = amplitude_T * std::sin(phaseY);
    const double slopeX = waveNumber_per_m * amplitude_T * std::cos(phaseX);
    const double slopeY = waveNumber_per_m * amplitude_T * std::cos(phaseY);
    ChipFieldSlope result;
    result.field_T << Bx * c + By * s, -Bx * s + By * c;
    // dX/dangle = -armY, dY/dangle = armX; the axes of the chip turn too.
    result.slope << slopeX * c, slopeY * s, -slopeX * armY_m * c + slopeY * armX_m * s + result.field_T.y(),
        -slopeX * s, slopeY * c, slopeX * armY_m * s + slopeY * armX_m * c - result.field_T.x();
    return result;
}

double chipHeight_m(const MagnetMatrix& matrix, double amplitude_T) {
    return std::log(harmonicAmplitude_T(matrix, 1, 0.0) / amplitude_T) / waveNumber_per_m(matrix);
}

Eigen::Matrix<double, FieldCount, CoilCount>
coilFieldAtChips_T_per_A(const PlanarGeometry& geometry, const std::array<Vector2d, ChipCount>& place_m,
                         double chipHeight_m) {
    Eigen::Matrix<double, FieldCount, CoilCount> result;
    const auto coils = geometry.coils();
    for (int k = 0; k < CoilCount; ++k) {
        const PlanarCoil& coil = coils[static_cast<std::size_t>(k)];
        for (int j = 0; j < ChipCount; ++j) {
            const Vector2d away_m = place_m[static_cast<std::size_t>(j)] - coil.centre_m;
            const Vector2d own_m = coil.isAcross ? Vector2d(away_m.y(), -away_m.x()) : away_m;
            const Vector3d field =
                coil.sense *
                coilField_T(geometry, Vector3d(own_m.x(), own_m.y(), chipHeight_m - geometry.gap_m));
            const Vector2d platen =
                coil.isAcross ? Vector2d(-field.y(), field.x()) : Vector2d(field.head<2>());
            result.block<2, 1>(2 * j, k) = platen;
        }
    }
    return result;
}

Vector2d chipReading_T(const HallChip& chip, const Vector2d& field_T, ChipFault fault,
                       const Vector2d& previous_T, Random& noise) {
    // Noise is drawn whatever the fault: the other chips' numbers do not depend on it.
    Vector2d seen_T = chip.sensitivity * field_T + chip.offset_T;
    if (chip.noise_T > 0.0) {
        seen_T.x() += chip.noise_T * noise.gaussian();
        seen_T.y() += chip.noise_T * noise.gaussian();
    }
    switch (fault) {
    case ChipFault::Dead:
        return Vector2d::Zero();
    case ChipFault::Stuck:
        return previous_T;
    case ChipFault::Clipped:
    case ChipFault::None:
        break;
    }
    const double limit_T = fault == ChipFault::Clipped ? 0.5 * chip.amplitude_T : chip.range_T;
    return seen_T.cwiseMin(limit_T).cwiseMax(-limit_T);
}

} // namespace halbench::models
