#pragma once

#include "models/spherical/sensor_placement.h"

#include <string>

namespace halbench::app {

/// Order of the rotations of an orientation (alpha, beta, gamma), about axes fixed in the stator:
/// M = Rx(alpha) Ry(beta) Rz(gamma). Source: resources/help/spherical-theory.md section 2.
std::string orientationOrder();

/// Order of the rotations that bring a sensor from the X axis to its place. Source: section 2.
std::string placementOrder(models::SensorFrames frames);

} // namespace halbench::app
