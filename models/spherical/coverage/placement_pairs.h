#pragma once

#include "models/spherical/coverage/coverage_map.h"
#include "models/spherical/coverage/placed_sensor.h"

#include <functional>
#include <vector>

namespace halbench::models {

/// Two places of a lattice for sensors 1 and 2.
struct PlacementPair {
    std::size_t first = 0; ///< index into the candidates
    std::size_t second = 0;
    double value = 0.0; ///< of the criterion on the coarse poses
};

/// Pairs of candidates with the largest worst reading over coarse poses of the workspace: for R, Theta and
/// Phi the largest magnitude of main sensor, first and second, the least of them over all poses. For a level
/// T only poses count where the main sensor does not reach T; the candidates that fail one together with
/// `first` drop out at once, hardest poses first. T falls until `wanted` pairs are left; all pairs are
/// considered. `isAllowed` judges a pair of candidates. Sorted, best first. Error: Interrupted.
Result<std::vector<PlacementPair>>
pairsByLeastReading(const PlacementDevice& device, const std::vector<PlacementAngles>& candidates,
                    const std::function<bool(std::size_t, std::size_t)>& isAllowed, std::size_t wanted,
                    const WorkControl& control);

} // namespace halbench::models
