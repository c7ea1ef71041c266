#pragma once

#include "app/procedures/calibrate/calibrate_procedure.h"
#include "widgets/figure/figure.h"
#include "widgets/language/display_units.h"

#include <optional>
#include <vector>

namespace halbench::app {

/// Current at the first motion over the angle of the rotor, both ways; in a report and in the window alike.
widgets::Figure staticFrictionFigure(const std::vector<StaticFrictionPoint>& points,
                                     widgets::AngleUnit unit = widgets::AngleUnit::Degree);

/// The Hall readings with the ellipse that was fitted to them; nothing without either.
std::optional<widgets::Figure> hallEllipseFigure(const CalibrateResult& result);

/// How far the readings lie outside of that ellipse, over the angle that it makes of them.
std::optional<widgets::Figure> hallResidualFigure(const CalibrateResult& result,
                                                  widgets::AngleUnit unit = widgets::AngleUnit::Degree);

} // namespace halbench::app
