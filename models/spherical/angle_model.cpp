#include "models/spherical/angle_model.h"

namespace halbench::models {

AngleModel angleModel(const AdditiveModel& model) {
    return [model](const OrientationAngles& angles, OrientationJacobian* jacobian) {
        return jacobian != nullptr ? additiveReadingsAndJacobian(model, angles, *jacobian)
                                   : additiveReadings_T(model, angles);
    };
}

AngleModel angleModel(const RotorField& field, const SensorPoses& poses) {
    return [field, poses](const OrientationAngles& angles, OrientationJacobian* jacobian) {
        const Eigen::Matrix3d rotation = rotationOf(angles);
        if (jacobian == nullptr) {
            return field.readings_T(rotation, poses);
        }
        const SphericalReadings readings_T = field.readingsAndJacobian(rotation, poses, *jacobian);
        *jacobian *= rateMatrix(angles);
        return readings_T;
    };
}

} // namespace halbench::models
