#include "models/spherical/spherical_calibration.h"

#include <Eigen/LU>

namespace halbench::models {

Eigen::Matrix3d SensorCalibration::sensitivity() const {
    Eigen::Matrix3d mixing;
    mixing << 1.0, skew_ratio[0], skew_ratio[1], //
        skew_ratio[0], 1.0, skew_ratio[2],       //
        skew_ratio[1], skew_ratio[2], 1.0;
    return mixing * gain_ratio.asDiagonal();
}

SphericalCalibration nominalCalibration(const SensorPoses& poses, const RotorFieldConfig& field) {
    SphericalCalibration calibration;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        calibration.sensors[i].pose = poses[i];
    }
    calibration.field = field;
    return calibration;
}

SphericalReadings correctedReadings_T(const SphericalCalibration& calibration,
                                      const SphericalReadings& readings_T, double coilCurrent_A) {
    SphericalReadings corrected_T = readings_T - coilCurrent_A * calibration.coil_T_per_A;
    for (int i = 0; i < 3; ++i) {
        const SensorCalibration& sensor = calibration.sensors[static_cast<std::size_t>(i)];
        const Eigen::Vector3d own_T = corrected_T.segment<3>(3 * i) - sensor.offset_T;
        corrected_T.segment<3>(3 * i) = sensor.sensitivity().inverse() * own_T;
    }
    return corrected_T;
}

SphericalSensing sensingOf(const SphericalCalibration& calibration, double deviation_T) {
    SphericalSensing sensing;
    for (std::size_t i = 0; i < sensing.poses.size(); ++i) {
        sensing.poses[i] = calibration.sensors[i].pose;
    }
    sensing.field = calibration.field;
    sensing.deviation_T.setConstant(deviation_T);
    return sensing;
}

} // namespace halbench::models
