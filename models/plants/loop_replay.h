#pragma once

#include "models/htm/htm_ideal_loop.h"

#include <span>
#include <vector>

namespace halbench::models {

/// The ideal loop of htm_ideal_loop.h behind a reference that was recorded, with a disturbance in it.
struct LoopReplayConfig {
    RotorConfig rotor;
    double torqueConstant_Nm_per_A = 1.43e-2;
    PositionLaw law;
    double friction_ratio = 1.0;               ///< of this run over K_f
    std::span<const ReferencePoint> reference; ///< one a period of the law, from the start of the rotor
    std::span<const double> disturbance_A;     ///< one a row, added to the current; empty: none
    std::size_t rows = 0;                      ///< 1 ms apart, whatever the law's period is
};

struct LoopReplay {
    std::vector<double> angle_rad; ///< from the start, at rest
    std::vector<double> current_A; ///< asked for by the law, held after that instant
};

/// Deterministic; 1 s of motor time takes about 0.1 ms. After its end a reference stays where it is.
LoopReplay replayLoop(const LoopReplayConfig& config);

/// Speed and acceleration of a reference of which samples are known: central differences of what does not
/// stand alone; a jump has no speed, as on the board, and a corner no acceleration.
std::vector<ReferencePoint> referencePoints(std::span<const double> value_rad, double period_s);

} // namespace halbench::models
