#include "models/spherical/rotor_field.h"

#include "models/fields/spherical_harmonic_rotor.h"
#include "models/spherical/orientation.h"

#include <cmath>

namespace halbench::models {
namespace {

constexpr double HalfRoot = 0.70710678118654752440;  ///< 1/sqrt(2)
constexpr double SixthRoot = 0.40824829046386301637; ///< 1/sqrt(6)

} // namespace

Eigen::Matrix3d tensorOf(const TensorVector& x) {
    // E1 = diag(1,-1,0)/sqrt2, E2 = diag(-1,-1,2)/sqrt6, then the pairs (1,2), (1,3), (2,3) over sqrt2.
    Eigen::Matrix3d q;
    q << HalfRoot * x[0] - SixthRoot * x[1], HalfRoot * x[2], HalfRoot * x[3], //
        HalfRoot * x[2], -HalfRoot * x[0] - SixthRoot * x[1], HalfRoot * x[4], //
        HalfRoot * x[3], HalfRoot * x[4], 2.0 * SixthRoot * x[1];
    return q;
}

TensorVector tensorCoordinates(const Eigen::Matrix3d& q) {
    TensorVector x;
    x << HalfRoot * (q(0, 0) - q(1, 1)), SixthRoot * (2.0 * q(2, 2) - q(0, 0) - q(1, 1)),
        HalfRoot * (q(0, 1) + q(1, 0)), HalfRoot * (q(0, 2) + q(2, 0)), HalfRoot * (q(1, 2) + q(2, 1));
    return x;
}

Eigen::Matrix3d rotorTensor_T(double strength_T, const Eigen::Matrix3d& rotation) {
    const Eigen::Vector3d u = rotation.col(0);
    const Eigen::Vector3d v = rotation.col(1);
    return strength_T * (u * u.transpose() - v * v.transpose());
}

Eigen::Matrix<double, 5, 3> tensorRotationDerivative(const Eigen::Matrix3d& tensor) {
    Eigen::Matrix<double, 5, 3> derivative;
    for (int k = 0; k < 3; ++k) {
        const Eigen::Matrix3d turn = crossMatrix(Eigen::Vector3d::Unit(k));
        derivative.col(k) = tensorCoordinates(turn * tensor - tensor * turn);
    }
    return derivative;
}

Eigen::Matrix<double, 9, 5> tensorDesign(const SensorPoses& poses, double referenceRadius_m) {
    Eigen::Matrix<double, 9, 5> design;
    for (int k = 0; k < 5; ++k) {
        const Eigen::Matrix3d basis = tensorOf(TensorVector::Unit(k));
        for (int i = 0; i < 3; ++i) {
            const SensorPose& pose = poses[static_cast<std::size_t>(i)];
            design.block<3, 1>(3 * i, k) =
                pose.axes.transpose() * tensorField_T(basis, referenceRadius_m, pose.position_m);
        }
    }
    return design;
}

RotorField::RotorField(const RotorFieldConfig& config)
    : m_config(config), m_harmonics(config.harmonics, config.referenceRadius_m) {}

Eigen::Vector3d RotorField::field_T(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& point_m) const {
    const Eigen::Matrix3d tensor_T = rotorTensor_T(m_config.strength_T, rotation);
    Eigen::Vector3d sum_T = tensorField_T(tensor_T, m_config.referenceRadius_m, point_m);
    if (hasHarmonics()) {
        sum_T += rotation * m_harmonics.field_T(rotation.transpose() * point_m);
    }
    return sum_T;
}

SphericalReadings RotorField::readings_T(const Eigen::Matrix3d& rotation, const SensorPoses& poses) const {
    SphericalReadings readings_T;
    for (int i = 0; i < 3; ++i) {
        const SensorPose& pose = poses[static_cast<std::size_t>(i)];
        readings_T.segment<3>(3 * i) = pose.axes.transpose() * field_T(rotation, pose.position_m);
    }
    return readings_T;
}

SphericalReadings RotorField::harmonicReadings_T(const Eigen::Matrix3d& rotation,
                                                 const SensorPoses& poses) const {
    SphericalReadings readings_T = SphericalReadings::Zero();
    for (int i = 0; i < 3 && hasHarmonics(); ++i) {
        const SensorPose& pose = poses[static_cast<std::size_t>(i)];
        readings_T.segment<3>(3 * i) =
            pose.axes.transpose() * (rotation * m_harmonics.field_T(rotation.transpose() * pose.position_m));
    }
    return readings_T;
}

SphericalReadings RotorField::readingsAndJacobian(const Eigen::Matrix3d& rotation, const SensorPoses& poses,
                                                  OrientationJacobian& jacobian) const {
    const Eigen::Matrix3d tensor_T = rotorTensor_T(m_config.strength_T, rotation);
    std::array<Eigen::Matrix3d, 3> turned;
    for (int k = 0; k < 3; ++k) {
        const Eigen::Matrix3d turn = crossMatrix(Eigen::Vector3d::Unit(k));
        turned[static_cast<std::size_t>(k)] = turn * tensor_T - tensor_T * turn;
    }
    SphericalReadings readings_T;
    for (int i = 0; i < 3; ++i) {
        const SensorPose& pose = poses[static_cast<std::size_t>(i)];
        const Eigen::Vector3d& p = pose.position_m;
        Eigen::Vector3d field = tensorField_T(tensor_T, m_config.referenceRadius_m, p);
        Eigen::Matrix3d slope;
        for (int k = 0; k < 3; ++k) {
            slope.col(k) = tensorField_T(turned[static_cast<std::size_t>(k)], m_config.referenceRadius_m, p);
        }
        if (hasHarmonics()) {
            const HarmonicField own = m_harmonics.fieldAndGradient(rotation.transpose() * p);
            const Eigen::Vector3d extra = rotation * own.field_T;
            const Eigen::Matrix3d gradient = rotation * own.gradient_T_per_m * rotation.transpose();
            field += extra;
            slope += gradient * crossMatrix(p) - crossMatrix(extra);
        }
        readings_T.segment<3>(3 * i) = pose.axes.transpose() * field;
        jacobian.middleRows<3>(3 * i) = pose.axes.transpose() * slope;
    }
    return readings_T;
}

} // namespace halbench::models
