#pragma once

#include "models/planar/planar_pose.h"

#include <Eigen/Core>

namespace halbench::models {

/// Forces of the six coils for one ampere in each: column = coil.
struct CoilWrench {
    Eigen::Matrix<double, 3, CoilCount> wrench =
        Eigen::Matrix<double, 3, CoilCount>::Zero(); ///< rows Fx, Fy in N/A, Tz in N m/A; see PlanarWrench
    Eigen::Matrix<double, 1, CoilCount> lift_N_per_A = Eigen::Matrix<double, 1, CoilCount>::Zero(); ///< Fz
};

} // namespace halbench::models
