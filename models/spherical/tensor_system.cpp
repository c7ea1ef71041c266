#include "models/spherical/tensor_system.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::models {
namespace {

template <int Columns>
std::pair<double, double> singularRange(const Eigen::Matrix<double, 9, Columns>& matrix) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Columns, Columns>> eigen(
        matrix.transpose() * matrix, Eigen::EigenvaluesOnly);
    const auto& squares = eigen.eigenvalues();
    return {std::sqrt(std::max(0.0, squares[0])), std::sqrt(squares[Columns - 1])};
}

} // namespace

Eigen::Matrix<double, 9, 3> uniformFieldDesign(const SensorPoses& poses) {
    Eigen::Matrix<double, 9, 3> design;
    for (int i = 0; i < 3; ++i) {
        design.middleRows<3>(3 * i) = poses[static_cast<std::size_t>(i)].axes.transpose();
    }
    return design;
}

TensorSystem::TensorSystem(const SphericalSensing& sensing, const ChannelMask& used)
    : m_design(tensorDesign(sensing.poses, sensing.field.referenceRadius_m)),
      m_weight(Eigen::Matrix<double, 9, 9>::Zero()), m_covariance(Eigen::Matrix<double, 5, 5>::Zero()),
      m_solver(Eigen::Matrix<double, 5, 9>::Zero()), m_uniformSolver(Eigen::Matrix<double, 3, 9>::Zero()) {
    const Eigen::Matrix<double, 9, 3> uniform = uniformFieldDesign(sensing.poses);
    Eigen::Matrix<double, 9, 8> both;
    both << m_design, uniform;
    for (int i = 0; i < ChannelCount; ++i) {
        if (used[static_cast<std::size_t>(i)]) {
            m_weight(i, i) = 1.0 / (sensing.deviation_T[i] * sensing.deviation_T[i]);
            ++m_channels;
        } else {
            both.row(i).setZero();
        }
    }
    const auto [smallest, largest] = sensing.hasUniformField
                                         ? singularRange<8>(both)
                                         : singularRange<5>(Eigen::Matrix<double, 9, 5>(both.leftCols<5>()));
    m_smallestSingularValue = smallest;
    m_conditioning = smallest > 0.0 ? largest / smallest : std::numeric_limits<double>::infinity();
    m_freedom = m_channels - (sensing.hasUniformField ? 8 : 5);
    if (sensing.hasUniformField && isDetermined()) {
        const Eigen::Matrix<double, 3, 9> weighted = uniform.transpose() * m_weight;
        const Eigen::Matrix3d own = weighted * uniform;
        m_uniformSolver = own.inverse() * weighted;
        m_weight -= (weighted.transpose() * m_uniformSolver).eval();
    }
    m_weightedDesign = m_design.transpose() * m_weight;
    m_information = m_weightedDesign * m_design;
    if (isDetermined()) {
        const Eigen::LDLT<Eigen::Matrix<double, 5, 5>> factor(m_information);
        m_covariance = factor.solve(Eigen::Matrix<double, 5, 5>::Identity());
        m_solver = factor.solve(m_weightedDesign);
    }
}

} // namespace halbench::models
