#pragma once

#include "control/history/sample_history.h"

#include <optional>
#include <span>

namespace halbench::widgets {

/// Distance of the values of a sensor that flickers between a few steps of its converter: the least
/// difference of two values, where at most twenty different ones are seen and all differences are whole
/// multiples of it (within 2 % of it). Nothing where the values are smooth, constant or empty; NaN is left
/// out. Values on either side of a gap are not compared: the sensor may have moved there, or the stream have
/// begun anew elsewhere. An axis of such values must not be magnified to a few steps: at rest it would show a
/// solid block.
std::optional<double> sensorStep(std::span<const control::TimedValue> samples);

} // namespace halbench::widgets
