#pragma once

#include "control/law/board_law.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace halbench::control {

/// A plant that begins at rest at 0 rad: holds a current for so long from where it is, and answers its angle
/// then.
using HeldCurrentPlant = std::function<double(double current_A, double duration_s)>;

/// The law of the board behind a reference that was recorded, with a disturbance in the loop.
struct LoopReplayConfig {
    SampledPositionLaw law;
    std::span<const ReferencePoint> reference; ///< one a period of the law, from the start of the plant
    std::span<const double> disturbance_A;     ///< one a row, added to the current; empty: none
    std::size_t rows = 0;                      ///< 1 ms apart, whatever the law's period is
};

struct LoopReplay {
    std::vector<double> angle_rad; ///< from the start, at rest
    std::vector<double> current_A; ///< asked for by the law, held after that instant
};

/// Deterministic; 1 s of the loop calls the plant about 1000 times. After its end a reference stays where it
/// is.
LoopReplay replayLoop(const LoopReplayConfig& config, const HeldCurrentPlant& plant);

/// Speed and acceleration of a reference of which samples are known: central differences of what does not
/// stand alone; a jump has no speed, as on the board, and a corner no acceleration.
std::vector<ReferencePoint> referencePoints(std::span<const double> value_rad, double period_s);

} // namespace halbench::control
