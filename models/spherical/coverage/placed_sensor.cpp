#include "models/spherical/coverage/placed_sensor.h"

#include "control/base/units.h"

#include <cmath>

namespace halbench::models {
namespace {

constexpr double ReferenceRadius_m = 0.05;

double strengthAt_T(const PlacementDevice& device) {
    return device.strength_T * std::pow(ReferenceRadius_m / device.radius_m, 4);
}

} // namespace

PlacedSensor::PlacedSensor(const PlacementDevice& device, const PlacementAngles& placement)
    : m_device(device), m_placement(placement),
      m_pose(sensorPose(placementRotation(placement, device.frames), device.radius_m)),
      m_scale_T(strengthAt_T(device)) {}

PlacedSensor::Tilt PlacedSensor::tiltOf(double alpha_rad, double beta_rad) {
    return {alpha_rad, beta_rad, rotorTensor_T(1.0, rotationOf({alpha_rad, beta_rad, 0.0})),
            rotorTensor_T(1.0, rotationOf({alpha_rad, beta_rad, 0.25 * Pi}))};
}

SensorSpin PlacedSensor::spin(const Tilt& tilt) const {
    if (m_device.device == SphericalDevice::Exact) {
        // Radial reading 3 n.Q n, tangential ones -2 t.Q n.
        const Eigen::Vector3d factor(3.0 * m_scale_T, -2.0 * m_scale_T, -2.0 * m_scale_T);
        const Eigen::Vector3d n = m_pose.axes.col(0);
        return {factor.cwiseProduct(m_pose.axes.transpose() * (tilt.cosine * n)),
                factor.cwiseProduct(m_pose.axes.transpose() * (tilt.sine * n))};
    }
    const AdditiveModel model{m_scale_T, {m_placement, m_placement, m_placement}};
    return {additiveReadings_T(model, {tilt.alpha_rad, tilt.beta_rad, 0.0}).head<3>(),
            additiveReadings_T(model, {tilt.alpha_rad, tilt.beta_rad, 0.25 * Pi}).head<3>()};
}

AdditiveModel additiveModelOf(const PlacementDevice& device, const SensorTriple& placement) {
    return {strengthAt_T(device), placement};
}

CoverageModel coverageModelOf(const PlacementDevice& device, const SensorTriple& placement) {
    if (device.device == SphericalDevice::Additive) {
        return CoverageModel(additiveModelOf(device, placement));
    }
    return CoverageModel({device.strength_T, ReferenceRadius_m, {}},
                         sensorPoses(placement, device.frames, device.radius_m));
}

} // namespace halbench::models
