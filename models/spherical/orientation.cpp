#include "models/spherical/orientation.h"

#include "control/base/units.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace halbench::models {

Eigen::Matrix3d rotationX(double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    return (Eigen::Matrix3d() << 1, 0, 0, 0, c, -s, 0, s, c).finished();
}

Eigen::Matrix3d rotationY(double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    return (Eigen::Matrix3d() << c, 0, s, 0, 1, 0, -s, 0, c).finished();
}

Eigen::Matrix3d rotationZ(double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    return (Eigen::Matrix3d() << c, -s, 0, s, c, 0, 0, 0, 1).finished();
}

Eigen::Matrix3d rotationOf(const OrientationAngles& angles) {
    return rotationX(angles.alpha_rad) * rotationY(angles.beta_rad) * rotationZ(angles.gamma_rad);
}

OrientationAngles anglesOf(const Eigen::Matrix3d& rotation) {
    return {std::atan2(-rotation(1, 2), rotation(2, 2)), std::asin(std::clamp(rotation(0, 2), -1.0, 1.0)),
            std::atan2(-rotation(0, 1), rotation(0, 0))};
}

ShaftDirection shaftOf(const Eigen::Matrix3d& rotation) {
    const Eigen::Vector3d z = rotation.col(2);
    const double phi_rad = std::atan2(z.y(), z.x());
    // atan2 instead of acos: exact near the pole.
    return {std::atan2(std::hypot(z.x(), z.y()), z.z()), phi_rad < 0.0 ? phi_rad + 2.0 * Pi : phi_rad};
}

OrientationAngles anglesForShaft(const ShaftDirection& shaft, double gamma_rad) {
    const double s = std::sin(shaft.theta_rad);
    return {std::atan2(-s * std::sin(shaft.phi_rad), std::cos(shaft.theta_rad)),
            std::asin(s * std::cos(shaft.phi_rad)), gamma_rad};
}

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
    return (Eigen::Matrix3d() << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0).finished();
}

Eigen::Matrix3d rotationOfVector(const Eigen::Vector3d& vector_rad) {
    const double square = vector_rad.squaredNorm();
    const double angle = std::sqrt(square);
    // Rodrigues; the series below 1e-4 rad is exact to the last bit.
    const double first = angle < 1e-4 ? 1.0 - square / 6.0 : std::sin(angle) / angle;
    const double second = angle < 1e-4 ? 0.5 - square / 24.0 : (1.0 - std::cos(angle)) / square;
    // [w]x [w]x = w w^T - |w|^2 I
    Eigen::Matrix3d rotation =
        (second * vector_rad) * vector_rad.transpose() + first * crossMatrix(vector_rad);
    rotation.diagonal().array() += 1.0 - second * square;
    return rotation;
}

Eigen::Vector3d vectorOfRotation(const Eigen::Matrix3d& rotation) {
    const Eigen::AngleAxisd angleAxis(rotation); // by way of the quaternion: accurate at every angle
    return angleAxis.angle() * angleAxis.axis();
}

Eigen::Matrix3d rateMatrix(const OrientationAngles& angles) {
    const Eigen::Matrix3d tilt = rotationX(angles.alpha_rad);
    Eigen::Matrix3d rates;
    rates.col(0) = Eigen::Vector3d::UnitX();
    rates.col(1) = tilt.col(1);
    rates.col(2) = tilt * rotationY(angles.beta_rad).col(2);
    return rates;
}

const std::array<Eigen::Vector3d, 4>& symmetrySigns() {
    // Diagonals of I, Rx(pi), Ry(pi), Rz(pi).
    static const std::array<Eigen::Vector3d, 4> signs = {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, -1, -1),
                                                         Eigen::Vector3d(-1, 1, -1),
                                                         Eigen::Vector3d(-1, -1, 1)};
    return signs;
}

Eigen::Matrix3d representative(const Eigen::Matrix3d& rotation) {
    Eigen::Matrix3d chosen = rotation;
    if (chosen(2, 2) < 0.0) {
        chosen.rightCols<2>() *= -1.0;
    }
    if (chosen(0, 0) < 0.0) {
        chosen.leftCols<2>() *= -1.0;
    }
    return chosen;
}

Eigen::Matrix3d nearestImage(const Eigen::Matrix3d& rotation, const Eigen::Matrix3d& reference) {
    // The trace of reference^T rotation is 1 + 2 cos(angle): the largest one is the nearest image.
    const Eigen::Vector3d overlap = (reference.cwiseProduct(rotation)).colwise().sum().transpose();
    const auto& signs = symmetrySigns();
    const auto best = std::max_element(signs.begin(), signs.end(), [&](const auto& a, const auto& b) {
        return overlap.dot(a) < overlap.dot(b);
    });
    return rotation * best->asDiagonal();
}

double symmetricError_rad(const Eigen::Matrix3d& rotation, const Eigen::Matrix3d& reference) {
    // |A - B| (Frobenius) = 2 sqrt(2) sin(angle/2); unlike acos of the trace it is exact for tiny angles.
    const double distance = (nearestImage(rotation, reference) - reference).norm();
    return 2.0 * std::asin(std::min(1.0, distance / std::sqrt(8.0)));
}

} // namespace halbench::models
