#pragma once

#include "app/procedures/apply/apply_axes.h"
#include "app/procedures/tune/analyse.h"
#include "widgets/figure/figure.h"

#include <optional>

namespace halbench::app {

/// Test step of the loop of one axis with friction and effort limit, position over effort, in the units of
/// the axis; `present` beside it. Nothing when it was not predicted.
std::optional<widgets::Figure> axisStepFigure(const LoopAxis& axis, const AnalysisResult& predicted,
                                              const std::optional<AnalysisResult>& present);

/// The verification step of one axis: measured over predicted from its start, what is left to the reference
/// and how far the other axes went meanwhile. Nothing without its motion.
std::optional<widgets::Figure> axisVerificationFigure(const AxisVerification& verified);

} // namespace halbench::app
