#pragma once

#include "app/procedures/base/row_loss.h"
#include "app/procedures/frequency/frequency_plan.h"

namespace halbench::app {

/// One stage of the plan and the row of the recording where its first measured period begins.
struct MeasuredStage {
    FrequencyStage stage;
    std::size_t firstRow = 0;
    std::vector<std::size_t> sweepRows; ///< of a chirp: where each sweep may begin
};

/// Recording of a frequency response with its plan and its law, before it is judged.
struct FrequencyRun {
    FrequencyConfig config;
    FrequencyMargins margins; ///< the law that ran and its period
    double turn_rad_s = 0.0;
    std::optional<StrayField> stray;
    std::vector<MeasuredStage> stages;
    Recording recording;
    RowLossCause rowLoss = {};   ///< why rows are missing in it, if any are
    double sensorExcess_K = 0.0; ///< CoilTemperatures::sensorExcess_K, the larger of before and after
};

/// Plant, loops, margins and rotor of it; a pure function. Errors: Refused (rows missing), NotFinite.
Result<FrequencyResult> estimateFrequency(FrequencyRun run);
/// Verdict and findings of the estimate.
DataQuality judgeFrequency(const FrequencyResult& result);

} // namespace halbench::app
