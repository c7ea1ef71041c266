#pragma once

#include "models/spherical/rotor_field.h"

namespace halbench::models {

/// q of a tensor that is that of the rotor up to noise: sqrt(tr(Q^2)/2).
inline double strengthOf_T(const TensorVector& tensor_T) {
    return tensor_T.norm() * 0.70710678118654752440;
}

/// Orientation whose field tensor is Q, as representative(): eigenvectors of +q, -q, 0 are the columns of M.
/// Errors of Q enter over the gaps: q for the shaft, 2 q for the spin. Q must not be zero.
Eigen::Matrix3d rotationByEigenvectors(const TensorVector& tensor_T);

/// The same without an eigenvalue problem, faster and slightly noisier: with Q/q, Q^2 + Q and Q^2 - Q are
/// twice the projectors on the first two columns of M; the columns with the largest diagonal entries are
/// taken, made orthogonal in equal parts and completed.
Eigen::Matrix3d rotationByProjectors(const TensorVector& tensor_T);

/// Columns: derivative of the tensor's coordinates for q = 1 with respect to a rotation about the rotor's own
/// axes, M -> M exp([w]x).
Eigen::Matrix<double, 5, 3> unitTensorDerivative(const Eigen::Matrix3d& rotation);
/// Coordinates of M diag(1, -1, 0) M^T.
TensorVector unitTensor(const Eigen::Matrix3d& rotation);

/// One Gauss-Newton step of (x - q x_M)^T N (x - q x_M) over M at the given q, x = measured coordinates with
/// the information N: all channels with their weights. From a start with the error of the tensor solution it
/// reaches the bound of Cramer and Rao for a known strength.
void refineRotation(const TensorVector& tensor_T, const Eigen::Matrix<double, 5, 5>& information,
                    double strength_T, Eigen::Matrix3d& rotation);
/// The same over M and q, for an unknown strength; both arguments are updated.
void refineRotationAndStrength(const TensorVector& tensor_T, const Eigen::Matrix<double, 5, 5>& information,
                               Eigen::Matrix3d& rotation, double& strength_T);

/// First-order change of the rotation vector (rotor axes) with the tensor's coordinates, rad/T, for the two
/// ways above; they differ off the tensors of a rotor.
Eigen::Matrix<double, 3, 5> eigenvectorSensitivity(const Eigen::Matrix3d& rotation, double strength_T);
Eigen::Matrix<double, 3, 5> projectorSensitivity(const Eigen::Matrix3d& rotation, double strength_T);

} // namespace halbench::models
