#pragma once

#include <QString>

namespace halbench::app {

/// Steady turn of an experiment, before it begins: direction, speed, turns and device time. `turn_rad_s`:
/// less than 0 in reverse.
QString turnText(double turn_rad_s, double turns, double duration_s);

} // namespace halbench::app
