#include "models/spherical/coverage/coverage_model.h"

#include "control/base/assert.h"
#include "control/base/units.h"

#include <Eigen/LU>
#include <cmath>

namespace halbench::models {

CoverageModel::CoverageModel(const RotorFieldConfig& field, const SensorPoses& poses)
    : m_isAdditive(false), m_field(field), m_poses(poses) {
    HB_ASSERT(!m_field.hasHarmonics());
    for (int i = 0; i < 3; ++i) {
        const SensorPose& pose = poses[static_cast<std::size_t>(i)];
        const double scale = field.strength_T * std::pow(field.referenceRadius_m / pose.position_m.norm(), 4);
        for (int k = 0; k < 3; ++k) {
            const double radial = std::fabs(pose.axes.col(k).dot(pose.position_m.normalized()));
            const double tangential = std::sqrt(std::fmax(0.0, 1.0 - radial * radial));
            m_slopeBound[3 * i + k] = scale * (6.0 * radial + 4.0 * tangential);
        }
    }
}

CoverageModel::CoverageModel(const AdditiveModel& model)
    : m_isAdditive(true), m_additive(model), m_field(RotorFieldConfig{}) {
    for (int i = 0; i < 9; ++i) {
        m_slopeBound[i] = model.strength_T * (i % 3 == 0 ? 6.0 : 4.0);
    }
}

SpinReadings CoverageModel::spinReadings(double alpha_rad, double beta_rad) const {
    return {readings_T({alpha_rad, beta_rad, 0.0}), readings_T({alpha_rad, beta_rad, 0.25 * Pi})};
}

SphericalReadings CoverageModel::readings_T(const OrientationAngles& angles) const {
    return m_isAdditive ? additiveReadings_T(m_additive, angles)
                        : m_field.readings_T(rotationOf(angles), m_poses);
}

OrientationJacobian CoverageModel::jacobian(const OrientationAngles& angles) const {
    OrientationJacobian jacobian;
    if (!m_isAdditive) {
        m_field.readingsAndJacobian(rotationOf(angles), m_poses, jacobian);
        return jacobian;
    }
    additiveReadingsAndJacobian(m_additive, angles, jacobian);
    return jacobian * rateMatrix(angles).inverse();
}

} // namespace halbench::models
