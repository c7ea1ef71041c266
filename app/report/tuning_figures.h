#pragma once

#include "app/procedures/analyse.h"
#include "widgets/figure.h"

#include <optional>

namespace halbench::app {

/// The pictures of a tuning, in a report and in the window alike.

/// Open loop with its margins marked; `present` is the loop of the gains that run now, drawn beside it.
widgets::Figure openLoopFigure(const AnalysisResult& predicted, const std::optional<AnalysisResult>& present);

/// Step of 1 rad of the linear loop with its current; nothing for an unstable loop.
std::optional<widgets::Figure> linearStepFigure(const AnalysisResult& predicted);

} // namespace halbench::app
