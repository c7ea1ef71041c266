#include "app/analyses/spherical/angle_error.h"

#include "models/spherical/orientation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

struct RowError {
    double rotation_rad = 0.0;
    double shaft_rad = 0.0;
};

/// Of w, x, y, z, alpha, beta, gamma.
RowError errorOf(const double* row) {
    const Eigen::Matrix3d estimate =
        Eigen::Quaterniond(row[0], row[1], row[2], row[3]).normalized().toRotationMatrix();
    const Eigen::Matrix3d truth = models::rotationOf({row[4], row[5], row[6]});
    const Eigen::Vector3d shaft = models::nearestImage(truth, estimate).col(2);
    return {models::symmetricError_rad(estimate, truth),
            std::atan2(shaft.cross(estimate.col(2)).norm(), shaft.dot(estimate.col(2)))};
}

} // namespace

std::vector<std::string> angleErrorRoles() {
    return {"orientation.w", "orientation.x", "orientation.y", "orientation.z",
            "truth.alpha",   "truth.beta",    "truth.gamma",   "shaft.cone95"};
}

AngleErrors angleErrors(const Recording& rows, std::size_t mostPoints) {
    const std::size_t width = angleErrorRoles().size();
    AngleErrors errors;
    errors.rows = rows.rows();
    if (errors.rows == 0) {
        return errors;
    }
    const std::size_t part = (errors.rows + mostPoints - 1) / mostPoints;
    double squares = 0.0;
    for (std::size_t begin = 0; begin < errors.rows; begin += part) {
        RowError largest;
        std::size_t at = begin;
        for (std::size_t i = begin; i < std::min(begin + part, errors.rows); ++i) {
            const RowError error = errorOf(rows.values.data() + i * width);
            squares += error.rotation_rad * error.rotation_rad;
            if (i == begin || error.rotation_rad > largest.rotation_rad) {
                largest = error;
                at = i;
            }
        }
        errors.time_s.push_back(rows.time_s[at]);
        errors.rotation_rad.push_back(largest.rotation_rad);
        errors.shaft_rad.push_back(largest.shaft_rad);
        errors.cone_rad.push_back(rows.values[at * width + width - 1]);
        errors.worst_rad = std::max(errors.worst_rad, largest.rotation_rad);
    }
    errors.rms_rad = std::sqrt(squares / static_cast<double>(errors.rows));
    return errors;
}

} // namespace halbench::app
