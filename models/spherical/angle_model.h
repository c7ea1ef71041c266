#pragma once

#include "models/spherical/additive_model.h"

#include <functional>

namespace halbench::models {

/// A device model as a function of the three angles; fills the derivatives by them (T/rad) when asked.
using AngleModel = std::function<SphericalReadings(const OrientationAngles&, OrientationJacobian*)>;

AngleModel angleModel(const AdditiveModel& model);
AngleModel angleModel(const RotorField& field, const SensorPoses& poses);

} // namespace halbench::models
