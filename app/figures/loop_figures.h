#pragma once

#include "app/figures/loop_curves.h"
#include "app/procedures/frequency/measured_loop.h"

namespace halbench::app {

/// Three more views of the open loop L that the Bode diagram shows, of the same points
/// (resources/help/tuning.md, "Views of the loop"). `measured`: the same gains on a measured plant, as
/// points; those that are not coherent are hollow.

/// L(i omega) in the complex plane around -1, with the unit circle and the circle of the modulus margin,
/// which the curve touches. Axes of equal scale; what lies outside is cut off.
widgets::Figure nyquistFigure(const AnalysisResult& predicted, const std::optional<AnalysisResult>& present,
                              const std::vector<NamedLoop>& others = {},
                              const std::optional<MeasuredLoop>& measured = std::nullopt);

/// Magnitude over phase, with the critical point (-180 degrees, 0 dB) and the line |1 + L| = 1/Ms around it.
widgets::Figure nicholsFigure(const AnalysisResult& predicted, const std::optional<AnalysisResult>& present,
                              const std::vector<NamedLoop>& others = {},
                              const std::optional<MeasuredLoop>& measured = std::nullopt);

/// |S| = 1/|1 + L| and |T| = |L/(1 + L)| over frequency, of the loops that are stable; nothing when the
/// proposed one is not.
std::optional<widgets::Figure> sensitivityFigure(const AnalysisResult& predicted,
                                                 const std::optional<AnalysisResult>& present,
                                                 const std::vector<NamedLoop>& others = {});

} // namespace halbench::app
