#pragma once

#include "app/procedures/move/move_procedure.h"

#include <vector>

namespace halbench::app {

/// The same move several times, each from where the rotor came to rest after the one before: what depends on
/// the starting angle (quantised angles, high gains) is judged as a share of many, not by one run.
struct RepeatConfig {
    int count = 1;
    /// A run has settled when its error stays below this in the evaluated part.
    std::optional<double> settled_rad;
};

struct MoveRepetition {
    RepeatConfig config;
    std::vector<double> start_rad;      ///< where each run began, true if known
    std::vector<double> maxError_rad;   ///< in the evaluated part
    std::vector<double> peakToPeak_rad; ///< likewise

    /// Share of the runs that settled; nothing without a limit for it.
    std::optional<double> settled_ratio() const;
};

struct RepeatedMove {
    MoveResult last;
    MoveRepetition repetition;
};

/// Errors: of runMove().
Result<RepeatedMove> runRepeatedMove(devices::Device& device, const MoveConfig& config,
                                     const RepeatConfig& repeat, const ProcedureObserver& observer);

} // namespace halbench::app
