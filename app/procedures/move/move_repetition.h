#pragma once

#include "app/procedures/move/move_procedure.h"

#include <optional>
#include <vector>

namespace halbench::app {

/// The same move several times, each from where the axis came to rest after the one before: what depends on
/// the start (quantised angles, high gains, place in the field) is judged as a share of many, not by one run.
struct RepeatConfig {
    int count = 1;
    /// Half of the window in the position unit of the axis: a run has settled when its error stays below
    /// this in the evaluated part; a travel, whose evaluated part is the way, when it stays there after it.
    std::optional<double> settled;
    bool alternates = false;      ///< every second run goes back
    std::string settledUnit = {}; ///< of `settled`
};

/// Statistics of the times in which the runs settled.
struct SettlingTimes {
    int count = 0; ///< runs that settled
    double least_s = 0.0;
    double median_s = 0.0;
    double mean_s = 0.0;
    double deviation_s = 0.0; ///< of the sample; 0 for a single run
    double largest_s = 0.0;
};

/// In the position unit of the axis.
struct MoveRepetition {
    RepeatConfig config;
    std::vector<double> start;      ///< where each run began, true if known
    std::vector<double> maxError;   ///< in the evaluated part
    std::vector<double> peakToPeak; ///< likewise
    /// MoveFigures::windowTime_s of each run, true if known.
    std::vector<std::optional<double>> windowTime_s;
    bool settlesAfterWay = false; ///< of a travel

    /// Share of the runs that settled; nothing without a limit for it.
    std::optional<double> settled_ratio() const;
    /// Nothing without a limit, or when no run came to rest within it.
    std::optional<SettlingTimes> settlingTimes() const;
};

struct RepeatedMove {
    MoveResult last;
    MoveRepetition repetition;
};

/// Errors: of runMove(); InvalidInput (a path that alternates).
Result<RepeatedMove> runRepeatedMove(devices::Device& device, const MoveConfig& config,
                                     const RepeatConfig& repeat, const ProcedureObserver& observer);

} // namespace halbench::app
