#include "models/fields/cuboid_magnet.h"

#include "control/base/units.h"

#include <cmath>

namespace halbench::models {
namespace {

Eigen::Vector2d turned(const Eigen::Vector2d& vector, double cosine, double sine) {
    return {cosine * vector.x() - sine * vector.y(), sine * vector.x() + cosine * vector.y()};
}

} // namespace

Eigen::Vector3d cuboidField(const Eigen::Vector3d& halfSize_m, const Eigen::Vector3d& point_m) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d sign((corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0,
                                   (corner & 4) != 0 ? 1.0 : -1.0);
        const Eigen::Vector3d d = point_m - sign.cwiseProduct(halfSize_m);
        const double R = d.norm();
        sum += sign.prod() * Eigen::Vector3d(std::atan2(d.y() * d.z(), d.x() * R), -std::atanh(d.z() / R),
                                             -std::atanh(d.y() / R));
    }
    return sum / (4.0 * Pi);
}

Eigen::Vector3d magnetField_T(const CuboidMagnet& magnet, const Eigen::Vector3d& point_m) {
    const double cosine = std::cos(magnet.angle_rad);
    const double sine = std::sin(magnet.angle_rad);
    const Eigen::Vector3d offset_m = point_m - magnet.centre_m;
    const Eigen::Vector2d inPlane_m = turned(offset_m.head<2>(), cosine, -sine);
    const Eigen::Vector3d own =
        cuboidField(magnet.halfSize_m, Eigen::Vector3d(inPlane_m.x(), inPlane_m.y(), offset_m.z()));
    const Eigen::Vector2d placed = turned(own.head<2>(), cosine, sine);
    return magnet.remanence_T * Eigen::Vector3d(placed.x(), placed.y(), own.z());
}

Eigen::Vector3d dipoleField_T(const CuboidMagnet& magnet, const Eigen::Vector3d& point_m) {
    const Eigen::Vector3d r = point_m - magnet.centre_m;
    const double distance_m = r.norm();
    const Eigen::Vector3d direction(std::cos(magnet.angle_rad), std::sin(magnet.angle_rad), 0.0);
    const Eigen::Vector3d unit = r / distance_m;
    const double volume_m3 = 8.0 * magnet.halfSize_m.prod();
    return magnet.remanence_T * volume_m3 / (4.0 * Pi * distance_m * distance_m * distance_m) *
           (3.0 * unit * unit.dot(direction) - direction);
}

Eigen::Vector2d longBarField_T(const CuboidMagnet& magnet, const Eigen::Vector2d& point_m) {
    const double cosine = std::cos(magnet.angle_rad);
    const double sine = std::sin(magnet.angle_rad);
    const Eigen::Vector2d own_m = turned(point_m - magnet.centre_m.head<2>(), cosine, -sine);
    // Limit c -> infinity of the cuboid: B_x = -1/(2 pi) sum s atan2(Y, X), B_y = -1/(2 pi) sum s ln R
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (int corner = 0; corner < 4; ++corner) {
        const Eigen::Vector2d sign((corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0);
        const Eigen::Vector2d d = own_m - sign.cwiseProduct(magnet.halfSize_m.head<2>());
        sum += sign.prod() * Eigen::Vector2d(std::atan2(d.y(), d.x()), std::log(d.norm()));
    }
    return turned(-magnet.remanence_T / (2.0 * Pi) * sum, cosine, sine);
}

} // namespace halbench::models
