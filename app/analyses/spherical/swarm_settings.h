#pragma once

#include "app/analyses/analysis.h"
#include "models/spherical/swarm_estimator.h"

#include <vector>

namespace halbench::app {

/// Settings of the published search, for every analysis that may run it; without them they are those of
/// models::SwarmConfig. Source: resources/help/spherical-theory.md section 5.4.
std::vector<AnalysisKey> swarmSettingKeys();

/// The search as set. The keys keep it within checkSwarmConfig().
models::SwarmConfig swarmSettings(const AnalysisValues& values);

/// Usage when a setting of the search is given to an analysis that does not run it; `remedy` says how it
/// would.
Result<void> checkNoSwarmSettings(const AnalysisValues& values, const char* remedy);

/// {trigger, rule, threshold_T, particles, iterations, first_inertia, last_inertia, c1, c2,
/// velocity_clamp_ratio, swarm_stop_T2, projection_steps, projection_stop_T2, k, cut_ratio, step_limit_rad}
JsonValue swarmJson(const models::SwarmConfig& config);

} // namespace halbench::app
