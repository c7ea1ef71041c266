#pragma once

#include "app/procedures/frequency/axes_frequency.h"
#include "widgets/figure/figure.h"

namespace halbench::app {

/// Open loop of every axis while the loops of the others are closed, with the multiple coherence of each.
/// Points that are not used are hollow.
widgets::Figure axesLoopsFigure(const AxesFrequencyResult& result);

/// Response of an axis to the effort of another relative to that to its own, |G_ij| F_j / (|G_ii| F_i) in dB
/// with F the effort that each has at its limit. Only what exceeds its 95 % scatter is drawn.
widgets::Figure axesCouplingFigure(const AxesFrequencyResult& result);

/// Largest singular values of sensitivity and complementary sensitivity, positions in units of the test
/// steps, at the frequencies where every axis is coherent.
widgets::Figure axesSensitivityFigure(const AxesFrequencyResult& result);

} // namespace halbench::app
