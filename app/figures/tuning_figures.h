#pragma once

#include "app/figures/loop_curves.h"
#include "app/procedures/apply/apply_procedure.h"
#include "app/procedures/frequency/measured_loop.h"
#include "app/procedures/move/what_if.h"
#include "control/base/sample_block.h"
#include "widgets/figure/figure.h"
#include "widgets/language/display_units.h"

#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// The pictures of a tuning, in a report and in the window alike.

/// Open loop with its margins marked; `present` is the loop of the gains that run now, drawn beside it.
/// `measured`: the same gains on a measured plant, as points; those that are not coherent are hollow.
/// `uncertainty`, here and below: of the proposed loop; nothing draws no band.
widgets::Figure openLoopFigure(const AnalysisResult& predicted, const std::optional<AnalysisResult>& present,
                               const std::vector<NamedLoop>& others = {},
                               const std::optional<MeasuredLoop>& measured = std::nullopt,
                               const std::optional<LoopUncertainty>& uncertainty = std::nullopt);

/// Step of 1 rad or 1 degree of the linear loop with its current, `present` beside it; nothing for an
/// unstable loop.
std::optional<widgets::Figure> linearStepFigure(const AnalysisResult& predicted,
                                                const std::optional<AnalysisResult>& present,
                                                widgets::AngleUnit unit = widgets::AngleUnit::Radian,
                                                const std::vector<NamedLoop>& others = {},
                                                const std::optional<LoopUncertainty>& uncertainty = {});

/// The large step with friction and current limit, with the band in which friction may hold the rotor;
/// `present` beside it. Nothing when it was not predicted.
std::optional<widgets::Figure> largeStepFigure(const AnalysisResult& predicted,
                                               const std::optional<AnalysisResult>& present,
                                               widgets::AngleUnit unit = widgets::AngleUnit::Degree,
                                               const std::vector<NamedLoop>& others = {},
                                               const std::optional<LoopUncertainty>& uncertainty = {});

/// A verifying step from its start: measured over predicted with the set-point; what is left to the set-point
/// with the error that the prediction allows and what friction may hold; the current.
widgets::Figure verificationFigure(const VerificationBand& band, const Recording& measured,
                                   widgets::AngleUnit unit = widgets::AngleUnit::Degree);

/// Any recorded move as it was, over its set-point; what is left to that; the current.
widgets::Figure recordedMoveFigure(const RecordedMove& move,
                                   widgets::AngleUnit unit = widgets::AngleUnit::Degree);

/// Into one of these two: the same move as it would have been with other gains, with its band when that
/// is known. `reference_rad` of the move, from where the rotor was.
void addWhatIfCurves(widgets::Figure& figure, const WhatIf& whatIf, const std::optional<MotionEnvelope>& band,
                     const std::vector<double>& reference_rad,
                     widgets::AngleUnit unit = widgets::AngleUnit::Degree);

} // namespace halbench::app
