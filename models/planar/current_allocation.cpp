#include "models/planar/current_allocation.h"

#include "control/base/assert.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

namespace halbench::models {
namespace {

constexpr double Lever_m = 50e-3;
constexpr double LargestCondition = 1e4;

} // namespace

CoilCurrents_A setWiseCurrents_A(const PublishedWrench& model, const PlanarPose& pose,
                                 const PlanarWrench& wrench) {
    const double turning_N = (wrench.torque_Nm + model.arm56_m() * wrench.forceX_N) / (2.0 * model.armX_m());
    const double b = model.forceConstant_N_per_A();
    const double f12 = (0.5 * wrench.forceY_N - turning_N) / b;
    const double f34 = (0.5 * wrench.forceY_N + turning_N) / b;
    const double f56 = wrench.forceX_N / b;
    const double psi = model.psi_rad(pose.y_m);
    const double chi = model.chi_rad(pose.x_m);
    CoilCurrents_A current_A;
    current_A << f12 * std::cos(psi), -f12 * std::sin(psi), -f34 * std::sin(psi), f34 * std::cos(psi),
        f56 * std::cos(chi), f56 * std::sin(chi);
    return current_A;
}

std::optional<CoilCurrents_A> leastNormCurrents_A(const CoilWrench& coils, const PlanarWrench& wrench) {
    Eigen::Matrix<double, 3, CoilCount> K = coils.wrench;
    K.row(2) /= Lever_m;
    const Eigen::Matrix3d gram = K * K.transpose();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
    eigen.computeDirect(gram, Eigen::EigenvaluesOnly);
    if (!(eigen.eigenvalues()(0) * LargestCondition > eigen.eigenvalues()(2))) {
        return std::nullopt;
    }
    const Eigen::Vector3d w(wrench.forceX_N, wrench.forceY_N, wrench.torque_Nm / Lever_m);
    return CoilCurrents_A(K.transpose() * (gram.inverse() * w));
}

Allocation limited(const CoilCurrents_A& current_A, double limit_A) {
    const double largest_A = current_A.cwiseAbs().maxCoeff();
    if (largest_A <= limit_A) {
        return {current_A, 1.0, false};
    }
    const double scale = limit_A / largest_A;
    return {scale * current_A, scale, true};
}

CurrentAllocator::CurrentAllocator(AllocationMethod method, const PlanarGeometry& geometry,
                                   double forceConstant_N_per_A, double limit_A)
    : m_method(method), m_published(geometry, forceConstant_N_per_A),
      m_windings(WrenchModel::Windings, geometry, method == AllocationMethod::Full ? MatrixOrderCount : 1),
      m_scale(forceConstant_N_per_A / windingsForceConstant_N_per_A(geometry)), m_limit_A(limit_A) {
    HB_ASSERT(forceConstant_N_per_A < 0.0 && limit_A > 0.0);
}

CoilWrench CurrentAllocator::coilsAt(const PlanarPose& pose) const {
    if (m_method == AllocationMethod::SetWise) {
        return m_published.at(pose);
    }
    CoilWrench coils = m_windings.at(pose);
    coils.wrench *= m_scale;
    coils.lift_N_per_A *= m_scale;
    return coils;
}

Allocation CurrentAllocator::allocate(const PlanarPose& pose, const PlanarWrench& wrench) const {
    if (m_method == AllocationMethod::SetWise) {
        return limited(setWiseCurrents_A(m_published, pose, wrench), m_limit_A);
    }
    const auto current_A = leastNormCurrents_A(coilsAt(pose), wrench);
    // Coils of a machine that passed checkPlanarParameters() determine every wrench at small headings;
    // beyond, nothing is driven.
    return current_A ? limited(*current_A, m_limit_A) : Allocation{CoilCurrents_A::Zero(), 0.0, true};
}

PlanarWrench CurrentAllocator::wrench(const PlanarPose& pose, const CoilCurrents_A& current_A) const {
    return wrenchOf(coilsAt(pose).wrench * current_A);
}

} // namespace halbench::models
