#pragma once

#include "models/spherical/coverage/coverage_proof.h"
#include "models/spherical/coverage/placed_sensor.h"

#include <string_view>
#include <vector>

namespace halbench::models {

/// Where sensors may sit, as seen from the centre: theta from Z, phi from X; and what they tolerate.
struct PlacementConstraints {
    double lowestTheta_rad = 0.0;
    double highestTheta_rad = 3.14159265358979323846;
    double lowestPhi_rad = -3.14159265358979323846;
    double highestPhi_rad = 3.14159265358979323846;
    double leastDistance_m = 5e-3; ///< between any two sensors
    /// Largest reading over the workspace must stay below; empty: any.
    std::optional<double> sensorRange_T;
};

enum class PlacementObjective {
    LeastReading,   ///< largest worst component over the workspace
    Conditioning,   ///< smallest singular-value ratio of the tensor's design
    PredictedError, ///< smallest rms rotation error over the workspace
};
inline constexpr std::array<std::string_view, 3> PlacementObjectiveNames = {"reading", "conditioning",
                                                                            "error"};

struct PlacementSearchConfig {
    PlacementDevice device;
    PlacementObjective objective = PlacementObjective::LeastReading;
    PlacementConstraints constraints;
    double latticeStep_rad = 0.08726646259971647; ///< 5 degrees, divides 45
    double threshold_T = 0.01;                    ///< for the proof
    double noise_T = 100e-6;                      ///< for the predicted error
    std::size_t finalists = 200;                  ///< pairs of each objective that are examined closely
};

struct PlacementResult {
    SensorTriple placement;     ///< main sensor first
    double least_T = 0.0;       ///< worst component over the workspace: a grid, refined
    double conditioning = 0.0;  ///< 0 for the additive device, which has no tensor
    double deviation_rad = 0.0; ///< rms of the rotation error over the workspace
};

struct PlacementSearch {
    PlacementResult best;
    CoverageProof proof;                 ///< of the best, with the bound within 0.1 mT
    std::vector<PlacementResult> pareto; ///< no other one is better in all three; best reading first
    std::uint64_t pairs = 0;             ///< pairs of the lattice considered
};

/// Places sensors 1 and 2 on the lattice of (da, db, dg) within +-45, +-45, +-90 degrees; the main sensor
/// stays on +X. Errors: OutOfRange for a step that does not divide 45 degrees, for constraints that leave no
/// pair, for the additive device with an objective other than LeastReading; Interrupted. The step of 5
/// degrees looks at 89 million pairs. Source: resources/help/spherical-theory.md section 6.
Result<PlacementSearch> searchPlacement(const PlacementSearchConfig& config, const WorkControl& control = {});

/// The three figures of one placement.
PlacementResult assessPlacement(const PlacementDevice& device, const SensorTriple& placement, double noise_T);

} // namespace halbench::models
