#pragma once

#include "app/actuators/motion_needs.h"

namespace halbench::app {

/// Judged by the fit's own measure, from at most 150 rows: cheap enough for a display that follows.
MotionNeeds sensingNeeds(const Recording& rows, const std::map<std::string, double>& values);

} // namespace halbench::app
