#pragma once

#include "app/procedures/tune/disturbance.h"
#include "widgets/figure/figure.h"
#include "widgets/language/display_units.h"

#include <optional>

namespace halbench::app {

/// Angle and current after the load of app/procedures/tune/disturbance.h, `present` beside it, with peak and
/// recovery of the proposed loop, and the band of the motors that the data allow when it is known; nothing
/// for one that is unstable.
std::optional<widgets::Figure>
disturbanceFigure(const std::optional<control::LoadStep>& proposed,
                  const std::optional<control::LoadStep>& present,
                  widgets::AngleUnit unit = widgets::AngleUnit::Radian, double load_A = DisturbanceLoad_A,
                  const std::optional<control::DisturbanceEnvelope>& band = {});

} // namespace halbench::app
