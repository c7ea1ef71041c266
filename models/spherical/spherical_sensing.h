#pragma once

#include "control/base/result.h"
#include "models/spherical/rotor_field.h"

#include <array>

namespace halbench::models {

constexpr int ChannelCount = 9;
/// Channels in use, in the order of SphericalReadings.
using ChannelMask = std::array<bool, ChannelCount>;
constexpr ChannelMask AllChannels = {true, true, true, true, true, true, true, true, true};

/// The device as an estimator believes it to be. Readings are those of ideal sensors: gains, offsets and coil
/// fields have been taken out before.
struct SphericalSensing {
    SensorPoses poses = sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05);
    RotorFieldConfig field;
    SphericalReadings deviation_T = SphericalReadings::Constant(100e-6); ///< rms of each reading's error
    bool hasUniformField = false; ///< three components of a uniform stray field are unknowns too
    double rotorRadius_m = 45.6e-3;
};

/// OutOfRange or NotFinite: impossible sensor poses, deviations or a strength of zero or less, harmonics
/// of odd degree or order, which are not the same for the four images of an orientation.
Result<void> checkSphericalSensing(const SphericalSensing& sensing);

} // namespace halbench::models
