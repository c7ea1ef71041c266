#pragma once

#include "control/design/load_step.h"
#include "widgets/display_units.h"
#include "widgets/figure.h"

#include <optional>

namespace halbench::app {

/// Angle and current after the load of app/procedures/disturbance.h, `present` beside it, with peak and
/// recovery of the proposed loop; nothing for one that is unstable.
std::optional<widgets::Figure> disturbanceFigure(const std::optional<control::LoadStep>& proposed,
                                                 const std::optional<control::LoadStep>& present,
                                                 widgets::AngleUnit unit = widgets::AngleUnit::Radian);

} // namespace halbench::app
