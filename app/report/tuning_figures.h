#pragma once

#include "app/procedures/analyse.h"
#include "control/base/sample_block.h"
#include "widgets/figure.h"

#include <optional>

namespace halbench::app {

/// The pictures of a tuning, in a report and in the window alike.

/// Open loop with its margins marked; `present` is the loop of the gains that run now, drawn beside it.
widgets::Figure openLoopFigure(const AnalysisResult& predicted, const std::optional<AnalysisResult>& present);

/// Step of 1 rad of the linear loop with its current, `present` beside it; nothing for an unstable loop.
std::optional<widgets::Figure> linearStepFigure(const AnalysisResult& predicted,
                                                const std::optional<AnalysisResult>& present);

/// The large step with friction and current limit, in degrees, with the band in which friction may hold the
/// rotor; `present` beside it. Nothing when it was not predicted.
std::optional<widgets::Figure> largeStepFigure(const AnalysisResult& predicted,
                                               const std::optional<AnalysisResult>& present);

/// A verifying move: measured over predicted, in degrees from the start, with the current below.
widgets::Figure verificationFigure(const models::IdealTrace& predicted, const Recording& measured);

} // namespace halbench::app
