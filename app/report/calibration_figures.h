#pragma once

#include "app/procedures/calibrate_procedure.h"
#include "widgets/display_units.h"
#include "widgets/figure.h"

#include <vector>

namespace halbench::app {

/// Current at the first motion over the angle of the rotor, both ways; in a report and in the window alike.
widgets::Figure staticFrictionFigure(const std::vector<StaticFrictionPoint>& points,
                                     widgets::AngleUnit unit = widgets::AngleUnit::Degree);

} // namespace halbench::app
