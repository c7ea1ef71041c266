#pragma once

#include "app/workspaces/display_quantity.h"
#include "widgets/figure.h"

namespace halbench::app {

/// The picture with the angles and speeds of its vertical axes as the user prefers to read them: axis,
/// curves, reference lines. What else it shows stays.
widgets::Figure inUnits(widgets::Figure figure, const DisplayUnits& units);

} // namespace halbench::app
