#pragma once

#include "app/actuators/planar/motion_windows.h"

#include <Eigen/Core>
#include <vector>

namespace halbench::app {

/// Unknowns of the equations of motion per unit of moving mass m; forces F_k = K_k(q) i_k by the windings of
/// the nominal geometry (resources/help/planar-theory.md 5.3 and 8), r_c = (c_x, c_y) the centre of mass:
///
///   x'' - c_y phi'' + b_x (x' - c_y phi') + b_xphi phi' + s_x x + s_xphi phi + f_x sgn x' + o_x = sum g_k
///   F_xk y'' + c_x phi'' + b_y (y' + c_x phi') + b_yphi phi' + s_y y + s_yphi phi + f_y sgn y' + o_y = sum
///   g_k F_yk r phi'' + b_phi phi' + d_x x' + d_y y' + s_phi phi + m_x x + m_y y + f_phi sgn phi' + o_phi
///                                                = sum g_k (T_k - c_x F_yk + c_y F_xk)
///
/// with the forces late by `Delay` behind the board's outputs. g_k: force of coil k over its nominal one and
/// over m; r = Iz/m.
namespace platen {
enum Unknown {
    Gain1,
    DampingX = Gain1 + models::CoilCount,
    DampingXphi, ///< of coils beside the centre whose back-EMF brakes them
    StiffnessX,
    StiffnessXphi,
    FrictionX,
    OffsetX,
    DampingY,
    DampingYphi,
    StiffnessY,
    StiffnessYphi,
    FrictionY,
    OffsetY,
    Inertia, ///< Iz/m, m^2
    DampingPhi,
    DampingMomentX,
    DampingMomentY,
    StiffnessPhi,
    MomentX,
    MomentY,
    FrictionPhi,
    OffsetPhi,
    Delay, ///< s
    CentreX,
    CentreY,
    Count
};
} // namespace platen

using PlatenVector = Eigen::Matrix<double, platen::Count, 1>;
using PlatenMatrix = Eigen::Matrix<double, platen::Count, platen::Count>;

struct PlatenFit {
    PlatenVector value = PlatenVector::Zero();
    PlatenMatrix covariance = PlatenMatrix::Zero();
    double freedom = 0.0;                                  ///< of Student's t
    int windows = 0;                                       ///< of the motion that were used
    int leftOut = 0;                                       ///< because rows were missing
    Eigen::Vector3d residualRms = Eigen::Vector3d::Zero(); ///< m/s^2, m/s^2, m^2/s^2 (torque over mass)
};

/// Weak form: each equation is multiplied by smooth functions of windows of 0.4 s and integrated by parts, so
/// that positions are never differentiated. Weighted by the joint scatter of the three equations at each
/// frequency; the covariance takes the windows as independent clusters (jackknife, CR3) and assumes nothing
/// about the noise within; the errors of the calibration are added. `poses`: one a row.
///
/// Errors: Refused (fewer than 30 whole windows, or a motion that does not decide every unknown), NotFinite.
Result<PlatenFit> fitPlaten(const PlatenMotion& motion, const std::vector<models::PlanarPose>& poses,
                            const models::PlanarGeometry& geometry, const PoseErrors& errors = {});

} // namespace halbench::app
