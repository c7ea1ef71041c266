#pragma once

#include "models/planar/planar_geometry.h"

#include <Eigen/Core>
#include <array>

namespace halbench::models {

/// How the platen stands on its three air bearings; changes are counted from the platen at rest without
/// current.
struct BearingState {
    std::array<double, 3> load_N{};      ///< carried by each bearing; negative: it would have to pull
    std::array<double, 3> gapChange_m{}; ///< of each air film
    double liftForce_N = 0.0;            ///< sum of the coils' vertical forces
    double lift_m = 0.0;                 ///< of the platen's origin
    double tiltX_rad = 0.0;              ///< about x', raises positive y'
    double tiltY_rad = 0.0;              ///< about y', raises negative x'
    bool isCarried = true;               ///< every bearing carries: the linear model holds
};

/// Three linear air bearings, one under the middle of each set of coils. Loads follow from the balance of
/// forces and moments (statically determinate), each coil's vertical force taken at its centre; gaps change
/// by load/stiffness. Quasi-static: the platen's own frequency on the films is above 1 kHz. Source:
/// resources/help/planar-theory.md sections 8 and 10.
class AirBearings {
public:
    AirBearings(const PlanarGeometry& geometry, double stiffness_N_per_m, double mass_kg,
                const Eigen::Vector2d& massCentre_m);

    BearingState under(const Eigen::Matrix<double, CoilCount, 1>& lift_N) const;

    double weight_N() const { return m_weight_N; }
    const std::array<Eigen::Vector2d, 3>& places_m() const { return m_place_m; } ///< platen axes

private:
    double m_stiffness_N_per_m;
    double m_weight_N;
    std::array<Eigen::Vector2d, 3> m_place_m;
    Eigen::Vector3d m_restLoad_N;
    Eigen::Matrix<double, 3, CoilCount> m_share; ///< of each coil's lift that relieves each bearing
    Eigen::Matrix3d m_plane;                     ///< gap changes -> lift, tilt about x', tilt about y'
};

} // namespace halbench::models
