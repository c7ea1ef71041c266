#include "models/fields/magnet_matrix.h"

#include "control/base/assert.h"
#include "control/base/units.h"

#include <cmath>

namespace halbench::models {

double waveNumber_per_m(const MagnetMatrix& matrix) {
    return 2.0 * Pi / matrix.pitch_m;
}

double harmonicAmplitude_T(const MagnetMatrix& matrix, int order, double height_m) {
    HB_ASSERT(order >= 1 && order % 4 == 1);
    const double sign = (order / 4) % 2 == 0 ? 1.0 : -1.0;
    const double g = order * waveNumber_per_m(matrix);
    return sign * (2.0 * std::sqrt(2.0) * matrix.magnetisation_T / (Pi * order)) *
           -std::expm1(-g * matrix.thickness_m) * std::exp(-g * height_m);
}

Eigen::Vector3d matrixField_T(const MagnetMatrix& matrix, const Eigen::Vector3d& point_m, int count) {
    HB_ASSERT(count >= 1);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = 0; i < count; ++i) {
        const int order = 4 * i + 1;
        const double g = order * waveNumber_per_m(matrix);
        sum += harmonicAmplitude_T(matrix, order, point_m.z()) *
               Eigen::Vector3d(std::sin(g * point_m.x()), std::sin(g * point_m.y()),
                               std::cos(g * point_m.x()) + std::cos(g * point_m.y()));
    }
    return sum;
}

Eigen::Matrix3d matrixFieldGradient_T_per_m(const MagnetMatrix& matrix, const Eigen::Vector3d& point_m,
                                            int count) {
    HB_ASSERT(count >= 1);
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (int i = 0; i < count; ++i) {
        const int order = 4 * i + 1;
        const double g = order * waveNumber_per_m(matrix);
        const double slope_T_per_m = g * harmonicAmplitude_T(matrix, order, point_m.z());
        const double sx = std::sin(g * point_m.x());
        const double sy = std::sin(g * point_m.y());
        const double cx = std::cos(g * point_m.x());
        const double cy = std::cos(g * point_m.y());
        Eigen::Matrix3d part;
        part << cx, 0.0, -sx, 0.0, cy, -sy, -sx, -sy, -(cx + cy);
        sum += slope_T_per_m * part;
    }
    return sum;
}

} // namespace halbench::models
