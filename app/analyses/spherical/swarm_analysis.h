#pragma once

#include "app/analyses/analysis.h"

namespace halbench::app {

/// "swarm": convergence of the published search, particle swarm and gradient projection: fitness over the
/// iterations, and the work of the search over the fitness at which its second stage begins. Work is counted
/// in evaluations of the model, which equal seeds repeat; a time would not be.
Analysis swarmAnalysis();

} // namespace halbench::app
