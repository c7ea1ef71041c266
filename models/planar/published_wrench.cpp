#include "models/planar/published_wrench.h"

#include <cmath>

namespace halbench::models {

double publishedForceConstant_N_per_A(const PlanarGeometry& geometry, int order) {
    const double g = order * waveNumber_per_m(geometry.matrix);
    const PlanarWinding& winding = geometry.winding;
    return -winding.turnsPerWidth_1_m * winding.layersPerHeight_1_m * geometry.longStraight_m() *
           coilHeightIntegral_Tm(geometry, order) * (4.0 / g) * std::sin(0.5 * g * winding.width_m);
}

PublishedWrench::PublishedWrench(const PlanarGeometry& geometry)
    : PublishedWrench(geometry, publishedForceConstant_N_per_A(geometry)) {}

PublishedWrench::PublishedWrench(const PlanarGeometry& geometry, double forceConstant_N_per_A)
    : m_forceConstant_N_per_A(forceConstant_N_per_A),
      m_waveNumber_per_m(models::waveNumber_per_m(geometry.matrix)),
      m_xBase_m(geometry.winding.width_m - 1.25 * geometry.matrix.pitch_m),
      m_yBase_m(geometry.arm56_m - 1.25 * geometry.matrix.pitch_m), // y'_1 = c56 - L
      m_armX_m(0.75 * geometry.matrix.pitch_m), m_arm56_m(geometry.arm56_m) {}

CoilWrench PublishedWrench::at(const PlanarPose& pose) const {
    const double b = m_forceConstant_N_per_A;
    const double psi = psi_rad(pose.y_m);
    const double chi = chi_rad(pose.x_m);
    const double cosPsi = b * std::cos(psi);
    const double sinPsi = b * std::sin(psi);
    const double cosChi = b * std::cos(chi);
    const double sinChi = b * std::sin(chi);
    CoilWrench result;
    result.wrench.row(0) << 0.0, 0.0, 0.0, 0.0, cosChi, sinChi;
    result.wrench.row(1) << cosPsi, -sinPsi, -sinPsi, cosPsi, 0.0, 0.0;
    result.wrench.row(2) << -m_armX_m * cosPsi, m_armX_m * sinPsi, -m_armX_m * sinPsi, m_armX_m * cosPsi,
        -m_arm56_m * cosChi, -m_arm56_m * sinChi;
    result.lift_N_per_A << -sinPsi, -cosPsi, -cosPsi, -sinPsi, -sinChi, cosChi;
    return result;
}

} // namespace halbench::models
