#pragma once

#include "widgets/figure/figure.h"

namespace halbench::app {

/// An angle within half a turn: (-180, 180] degrees.
double wrapped_deg(double phase_deg);

/// A Bode plot with its phase, the second panel, within half a turn: a line that leaves at one edge goes on
/// at the other, interrupted between them. A band is there as often as it reaches into the half turn.
widgets::Figure withWrappedPhase(widgets::Figure bode);

} // namespace halbench::app
