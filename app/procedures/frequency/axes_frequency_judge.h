#pragma once

#include "app/procedures/base/row_loss.h"
#include "app/procedures/frequency/axes_frequency_plan.h"

namespace halbench::app {

/// One experiment and the row of the recording where its first measured period begins.
struct AxesExperiment {
    std::size_t band = 0;
    std::size_t firstRow = 0;
};

/// All that was measured, as the estimate needs it.
struct AxesFrequencyRun {
    AxesFrequencyConfig config;
    AxesFrequencyPlan plan;
    std::vector<devices::AxisSpec> axes;
    std::vector<control::SampledPositionLaw> laws;
    std::vector<AxesFrequencyBand> bands;
    std::vector<AxesExperiment> experiments; ///< of each band as many as there are axes, one after the other
    Recording recording;
    RowLossCause rowLoss = {};
};

/// Plant, loops and margins of it; a pure function. Errors: Refused (rows missing, an axis that was not
/// excited), InvalidInput, NotFinite.
Result<AxesFrequencyResult> estimateAxesFrequency(const devices::Catalogue& catalogue, AxesFrequencyRun run);
/// Verdict and findings of the estimate.
DataQuality judgeAxesFrequency(const AxesFrequencyResult& result);

} // namespace halbench::app
