#pragma once

#include "models/planar/coil_wrench.h"
#include "models/planar/planar_geometry.h"

namespace halbench::models {

/// The published model of the coils' forces: heading ignored, straight sides only, fundamental only.
///   psi = gamma (y + y'_1 - L/4),  chi = gamma (x + a - 5L/4)
///   Fx = b (i5 cos chi + i6 sin chi),  Fy = b [(i1 + i4) cos psi - (i2 + i3) sin psi]
///   Tz = (3L/4) b [(i4 - i1) cos psi + (i2 - i3) sin psi] - c56 Fx
/// Source: resources/help/planar-theory.md section 5.1.
class PublishedWrench {
public:
    /// With the force constant that follows from the geometry.
    explicit PublishedWrench(const PlanarGeometry& geometry);
    /// With an identified force constant, negative by the sign of the phases.
    PublishedWrench(const PlanarGeometry& geometry, double forceConstant_N_per_A);

    CoilWrench at(const PlanarPose& pose) const;

    double forceConstant_N_per_A() const { return m_forceConstant_N_per_A; } ///< b
    double psi_rad(double y_m) const { return m_waveNumber_per_m * (y_m + m_yBase_m); }
    double chi_rad(double x_m) const { return m_waveNumber_per_m * (x_m + m_xBase_m); }
    double armX_m() const { return m_armX_m; }   ///< 3L/4, of the two pairs that push along y
    double arm56_m() const { return m_arm56_m; } ///< c56, of the pair that pushes along x

private:
    double m_forceConstant_N_per_A;
    double m_waveNumber_per_m;
    double m_xBase_m;
    double m_yBase_m;
    double m_armX_m;
    double m_arm56_m;
};

/// b_n = -lambda beta p (-1)^k b_n(z1) (4/(n gamma)^2) sin(n gamma a/2) (1 - e^(-n gamma d)), N/A.
double publishedForceConstant_N_per_A(const PlanarGeometry& geometry, int order = 1);

} // namespace halbench::models
