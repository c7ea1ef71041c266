#pragma once

#include "models/spherical/coverage/coverage_map.h"
#include "models/spherical/coverage/placed_sensor.h"

#include <array>
#include <string_view>
#include <vector>

namespace halbench::models {

/// The published criteria of placement.
enum class DifferenceFunction {
    First,  ///< T1 = sum over R, Theta, Phi of (B_1 - B_0)^2: where to put sensor 1
    Second, ///< T2 = the same for sensors 2, 0 plus that for 2, 1: where to put sensor 2
};
enum class DifferenceReduction { Mean, Max, Min, Home }; ///< over the poses; the publication does not say
inline constexpr std::array<std::string_view, 4> DifferenceReductionNames = {"mean", "max", "min", "home"};

/// All reductions of one placement, T^2: of signed readings and of their magnitudes.
struct DifferenceValues {
    std::array<double, 4> signed_T2{};
    std::array<double, 4> absolute_T2{};
};

/// alpha, beta -45 ... 45 degrees, gamma -90 ... 90 degrees, all inclusive.
PoseGrid placementLattice(double step_rad);
PlacementAngles placementAt(const PoseGrid& lattice, std::size_t index);

/// The function at every placement of the lattice (gamma fastest, then beta) for the last sensor; `first` is
/// sensor 1 for DifferenceFunction::Second; sensor 0 is the main one. Errors: of checkPoseGrid(),
/// Interrupted.
Result<std::vector<DifferenceValues>>
differenceValues(const PlacementDevice& device, DifferenceFunction function, const PlacementAngles& first,
                 const PoseGrid& lattice, const PoseGrid& poses, const WorkControl& control = {});

struct DifferenceRanking {
    double best_T2 = 0.0;
    std::vector<PlacementAngles> bestAt; ///< all placements that tie, to 1e-9 of the value
    double claimed_T2 = 0.0;
    int rank = 0; ///< of the claimed placement: 1 + number of better ones
};
/// Error: OutOfRange when the claimed placement is not on the lattice.
Result<DifferenceRanking> rankDifference(const std::vector<DifferenceValues>& values, const PoseGrid& lattice,
                                         bool isAbsolute, DifferenceReduction reduction,
                                         const PlacementAngles& claimed);

} // namespace halbench::models
