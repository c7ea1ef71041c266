#pragma once

#include "app/documents/result_header.h"
#include "app/experiments/run_outcome.h"

namespace halbench::app {

/// What a step will do, as far as it can be known before it runs.
struct StepPlan {
    std::string kind;
    std::string name;
    double duration_s = 0.0;
    double peakCurrent_A = 0.0;
    double highestTemperature_degC = 0.0;
};

/// `run --dry-run`: steps with the coils' heat carried from one to the next; totals over all of them.
struct RunPlan {
    std::vector<StepPlan> steps;
    double duration_s = 0.0;
    double peakCurrent_A = 0.0;
    double highestTemperature_degC = 0.0;
};

/// Predicts without arming or writing anything. Gains that a `tune` step will only find are foreseen as the
/// recommended preset. Errors: of the steps' configurations, of reading the device.
Result<RunPlan> planRun(const Experiment& experiment, devices::Device& device);

JsonValue planDocument(const ResultHeader& header, const RunPlan& plan);
std::string planText(const RunPlan& plan);

} // namespace halbench::app
