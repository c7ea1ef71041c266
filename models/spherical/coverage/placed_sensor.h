#pragma once

#include "models/spherical/coverage/coverage_model.h"
#include "models/spherical/spherical_parameters.h"

namespace halbench::models {

/// The device whose sensors are to be placed.
struct PlacementDevice {
    SphericalDevice device = SphericalDevice::Exact;
    SensorFrames frames = SensorFrames::Zyx; ///< of the exact device
    double radius_m = 0.05;
    double strength_T = 0.0991864782; ///< q at 50 mm
    double rotorRadius_m = 45.6e-3;
};

/// (R, Theta, Phi) of one sensor at fixed alpha and beta: cosine cos 2 gamma + sine sin 2 gamma.
struct SensorSpin {
    Eigen::Vector3d cosine_T;
    Eigen::Vector3d sine_T;
};

/// Readings of sensors at any placement, fast enough for searches.
class PlacedSensor {
public:
    PlacedSensor(const PlacementDevice& device, const PlacementAngles& placement);
    /// `tilt` as made by tiltOf(alpha, beta).
    struct Tilt {
        double alpha_rad = 0.0;
        double beta_rad = 0.0;
        Eigen::Matrix3d cosine; ///< field tensor for q = 1 at gamma = 0 and at 45 degrees
        Eigen::Matrix3d sine;
    };
    static Tilt tiltOf(double alpha_rad, double beta_rad);
    SensorSpin spin(const Tilt& tilt) const;

private:
    PlacementDevice m_device;
    PlacementAngles m_placement;
    SensorPose m_pose;
    double m_scale_T = 0.0;
};

/// The additive model of the device: its strength is that at the sensors, q (50 mm / r)^4.
AdditiveModel additiveModelOf(const PlacementDevice& device, const SensorTriple& placement);

/// The three placed sensors for coverage maps and proofs.
CoverageModel coverageModelOf(const PlacementDevice& device, const SensorTriple& placement);

} // namespace halbench::models
