#pragma once

#include "app/procedures/base/row_loss.h"
#include "app/procedures/relay/relay_procedure.h"

namespace halbench::app {

/// What was measured, as the judgement needs it.
struct RelayRun {
    RelayConfig config;
    RelayPlan plan;
    double period_s = 0.01;
    int delaySamples = 0;
    std::size_t firstRow = 0; ///< of the recording, that is measured
    std::size_t endRow = 0;   ///< behind the last one: the motor is disarmed after it
    Recording recording;
    RowLossCause rowLoss = {}; ///< why rows are missing in it, if any are
};

/// Cycle, ultimate gain and verdict; a pure function. Errors: Refused (rows missing, it did not swing),
/// NotFinite.
Result<RelayResult> estimateRelay(RelayRun run);
/// Verdict and findings of a result; takes away an ultimate gain that is refused.
void judgeRelay(RelayResult& result);

} // namespace halbench::app
