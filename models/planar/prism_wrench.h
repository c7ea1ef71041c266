#pragma once

#include "models/planar/coil_wrench.h"
#include "models/planar/planar_geometry.h"

#include <array>

namespace halbench::models {

/// Forces of coils made of four straight prisms each, without corners, at any heading and with harmonics, in
/// closed form. Source: resources/help/planar-theory.md section 5.2.
class PrismWrench {
public:
    /// The first `orders` harmonics of the field, 1 ... 3.
    explicit PrismWrench(const PlanarGeometry& geometry, int orders = MatrixOrderCount);

    CoilWrench at(const PlanarPose& pose) const;

private:
    PlanarGeometry m_geometry;
    std::array<PlanarCoil, CoilCount> m_coils;
    std::array<double, MatrixOrderCount> m_density_N_per_A_m2{}; ///< lambda beta times the height integral
};

} // namespace halbench::models
