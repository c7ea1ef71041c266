#include "models/spherical/tensor_rotation.h"

#include "models/spherical/orientation.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace halbench::models {
namespace {

constexpr double HalfRoot = 0.70710678118654752440;  ///< 1/sqrt(2)
constexpr double SixthRoot = 0.40824829046386301637; ///< 1/sqrt(6)

/// Coordinates of a b^T + b a^T without its trace.
TensorVector symmetricProduct(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double xx = 2.0 * a[0] * b[0];
    const double yy = 2.0 * a[1] * b[1];
    const double zz = 2.0 * a[2] * b[2];
    TensorVector x;
    x << HalfRoot * (xx - yy), SixthRoot * (2.0 * zz - xx - yy), 2.0 * HalfRoot * (a[0] * b[1] + a[1] * b[0]),
        2.0 * HalfRoot * (a[0] * b[2] + a[2] * b[0]), 2.0 * HalfRoot * (a[1] * b[2] + a[2] * b[1]);
    return x;
}

/// Column of a symmetric matrix with the largest diagonal entry.
int strongestColumn(const Eigen::Matrix3d& matrix) {
    const int first = matrix(0, 0) >= matrix(1, 1) ? 0 : 1;
    return matrix(first, first) >= matrix(2, 2) ? first : 2;
}

} // namespace

Eigen::Matrix3d rotationByEigenvectors(const TensorVector& tensor_T) {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
    eigen.computeDirect(tensorOf(tensor_T / strengthOf_T(tensor_T)));
    const Eigen::Matrix3d& vectors = eigen.eigenvectors(); // eigenvalues -q, 0, +q
    Eigen::Matrix3d rotation;
    rotation << vectors.col(2), vectors.col(0), vectors.col(2).cross(vectors.col(0));
    return representative(rotation);
}

Eigen::Matrix3d rotationByProjectors(const TensorVector& tensor_T) {
    const Eigen::Matrix3d unit = tensorOf(tensor_T / strengthOf_T(tensor_T));
    const Eigen::Matrix3d square = unit * unit;
    const Eigen::Matrix3d plus = square + unit;
    const Eigen::Matrix3d minus = square - unit;
    const Eigen::Vector3d u = plus.col(strongestColumn(plus)).normalized();
    const Eigen::Vector3d v = minus.col(strongestColumn(minus)).normalized();
    const double overlap = 0.5 * u.dot(v);
    Eigen::Matrix3d rotation;
    rotation.col(0) = (u - overlap * v).normalized();
    // Exactly orthogonal: what remains after equal parts is of second order in the overlap.
    const Eigen::Vector3d rest = v - overlap * u;
    rotation.col(1) = (rest - rotation.col(0).dot(rest) * rotation.col(0)).normalized();
    rotation.col(2) = rotation.col(0).cross(rotation.col(1));
    return representative(rotation);
}

Eigen::Matrix<double, 5, 3> unitTensorDerivative(const Eigen::Matrix3d& rotation) {
    const Eigen::Vector3d u = rotation.col(0);
    const Eigen::Vector3d v = rotation.col(1);
    const Eigen::Vector3d p = rotation.col(2);
    // Turning about u moves v to p, about v moves u to -p, about p moves u to v and v to -u.
    Eigen::Matrix<double, 5, 3> derivative;
    derivative.col(0) = -symmetricProduct(v, p);
    derivative.col(1) = -symmetricProduct(u, p);
    derivative.col(2) = 2.0 * symmetricProduct(u, v);
    return derivative;
}

TensorVector unitTensor(const Eigen::Matrix3d& rotation) {
    const Eigen::Vector3d u = rotation.col(0);
    const Eigen::Vector3d v = rotation.col(1);
    return symmetricProduct(u + v, 0.5 * (u - v));
}

void refineRotation(const TensorVector& tensor_T, const Eigen::Matrix<double, 5, 5>& information,
                    double strength_T, Eigen::Matrix3d& rotation) {
    const Eigen::Matrix<double, 5, 3> turn = strength_T * unitTensorDerivative(rotation);
    const Eigen::Matrix<double, 5, 3> weighted = information * turn;
    const Eigen::Matrix3d normal = turn.transpose() * weighted;
    const Eigen::Matrix3d inverse = normal.inverse();
    const Eigen::Vector3d step =
        inverse * (weighted.transpose() * (tensor_T - strength_T * unitTensor(rotation)));
    rotation = representative(rotation * rotationOfVector(step));
}

void refineRotationAndStrength(const TensorVector& tensor_T, const Eigen::Matrix<double, 5, 5>& information,
                               Eigen::Matrix3d& rotation, double& strength_T) {
    const TensorVector unit = unitTensor(rotation);
    const Eigen::Matrix<double, 5, 3> turn = strength_T * unitTensorDerivative(rotation);
    const TensorVector missing = information * (tensor_T - strength_T * unit);
    const Eigen::Matrix<double, 5, 3> weighted = information * turn;
    const TensorVector weightedUnit = information * unit;
    // Strength eliminated, then the three rotations.
    const double own = unit.dot(weightedUnit);
    const Eigen::Vector3d coupling = turn.transpose() * weightedUnit;
    const double excess = unit.dot(missing);
    const Eigen::Matrix3d normal = turn.transpose() * weighted - coupling * coupling.transpose() / own;
    const Eigen::Matrix3d inverse = normal.inverse();
    const Eigen::Vector3d step = inverse * (turn.transpose() * missing - coupling * (excess / own));
    strength_T += (excess - coupling.dot(step)) / own;
    rotation = representative(rotation * rotationOfVector(step));
}

Eigen::Matrix<double, 3, 5> eigenvectorSensitivity(const Eigen::Matrix3d& rotation, double strength_T) {
    // w_p = v.dQ u/(2 q), w_v = -u.dQ p/q, w_u = -v.dQ p/q; a.dQ b = (dx . coordinates of a b^T + b a^T)/2.
    Eigen::Matrix<double, 3, 5> sensitivity = unitTensorDerivative(rotation).transpose() / (2.0 * strength_T);
    sensitivity.row(2) /= 4.0;
    return sensitivity;
}

Eigen::Matrix<double, 3, 5> projectorSensitivity(const Eigen::Matrix3d& rotation, double strength_T) {
    const Eigen::Matrix3d unit = tensorOf(unitTensor(rotation));
    const Eigen::Vector3d u = rotation.col(0);
    const Eigen::Vector3d v = rotation.col(1);
    const Eigen::Vector3d p = rotation.col(2);
    const int j = strongestColumn(unit * unit + unit);
    const int k = strongestColumn(unit * unit - unit);
    Eigen::Matrix<double, 3, 5> sensitivity;
    for (int i = 0; i < 5; ++i) {
        const TensorVector basis = TensorVector::Unit(i);
        // The scale by the fitted strength changes the length only along the tensor itself.
        const TensorVector turned = basis - unitTensor(rotation) * (0.5 * unitTensor(rotation).dot(basis));
        const Eigen::Matrix3d change = tensorOf(turned);
        const Eigen::Matrix3d square = unit * change + change * unit;
        const Eigen::Vector3d du = (square + change).col(j) / (2.0 * u[j]);
        const Eigen::Vector3d dv = (square - change).col(k) / (2.0 * v[k]);
        sensitivity.col(i) << p.dot(dv), -p.dot(du), 0.5 * (v.dot(du) - u.dot(dv));
    }
    return sensitivity / strength_T;
}

} // namespace halbench::models
