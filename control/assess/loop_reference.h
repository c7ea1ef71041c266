#pragma once

#include "control/law/board_law.h"

namespace halbench::control {

/// A position reference that starts at t = 0: the shapes of the board's generator that have an ideal
/// prediction, in rad. staircase: amplitude (1 + floor(t/period)), at most `count` steps.
struct LoopReference {
    enum class Shape { Step, Ramp, Sine, Staircase };
    Shape shape = Shape::Step;
    double amplitude_rad = 0.0;
    double rate_rad_s = 0.0; ///< ramp; held at |amplitude| when that is not zero, as on the board
    double frequency_Hz = 0.0;
    double period_s = 1.0;
    int count = 1;
};

ReferencePoint evaluateReference(const LoopReference& reference, double time_s);

} // namespace halbench::control
