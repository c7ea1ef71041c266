#pragma once

#include "app/experiments/run_outcome.h"
#include "app/headless/command_context.h"

namespace halbench::app {

/// Runs the steps of an experiment one after the other on one device and judges its checks. What `apply`,
/// `calibrate` and `set` changed stays for the steps that follow and after a run that reached its end; a run
/// that a step's error ended puts back what was there before it and leaves the actuator disarmed.
/// With a folder, a `record` step writes its STEP.csv there while it records.
/// Never fails itself: the error of a step is in the outcome.
RunOutcome runExperiment(CommandContext& context, devices::Device& device, const Experiment& experiment,
                         std::uint64_t seed, const std::string& folder = {});

} // namespace halbench::app
