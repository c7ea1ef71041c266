#pragma once

#include "app/procedures/tune/tune.h"
#include "app/tuning/gains_judgement.h"

#include <string>

namespace halbench::app {

/// Files of --bode, --step and --poles; an empty one is not asked for.
struct LoopTableFiles {
    std::string bode, step, poles;
    bool isAny() const { return !bode.empty() || !step.empty() || !poles.empty(); }
};

/// A loop and what its bands are drawn of; the conditions have its timing, and its axis if it is one of
/// several.
struct TabledLoop {
    const MotorEstimate& estimate;
    LoopLaw law;
    LoopConditions conditions;
    JudgedWith with;
};

/// A loop as tables for other programs: open loop over frequency, a step of the reference and of a load over
/// time, both with the bands of the motors that the uncertainty allows (empty cells where none is known), and
/// poles, zeros and root locus. Columns of an axis are named in its units, those of a motor in rad and A.
/// Errors: FileSystem.
Result<void> writeLoopTables(const LoopTableFiles& files, const TabledLoop& loop,
                             const AnalysisResult& result);

} // namespace halbench::app
