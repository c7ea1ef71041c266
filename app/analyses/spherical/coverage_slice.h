#pragma once

#include "app/analyses/analysis.h"
#include "models/spherical/coverage/coverage_proof.h"
#include "models/spherical/coverage/placement_search.h"

#include <vector>

namespace halbench::app {

/// The angle that a slice of the workspace holds; the map is over the other two.
enum class HeldAngle { Alpha, Beta, Gamma };

struct CoverageSliceConfig {
    models::CoverageQuantity quantity = models::CoverageQuantity::LeastComponent_T;
    double threshold_T = 0.01;
    double noise_T = 100e-6; ///< of the predicted error
    HeldAngle held = HeldAngle::Gamma;
    double held_rad = 0.0;
    double step_rad = 0.017453292519943295; ///< 1 degree, of the other two; divides 45 degrees
};

/// Poses of a slice, row by row: alpha by beta, alpha by gamma or beta by gamma.
struct SliceOfCoverage {
    models::PoseGrid grid;
    std::vector<float> value;   ///< of the quantity
    std::vector<float> least_T; ///< least of the three components' largest magnitudes
    std::size_t uncovered = 0;  ///< poses where that is not above the threshold
};

/// Errors: OutOfRange; Interrupted.
Result<SliceOfCoverage> coverageSlice(const models::CoverageModel& model, const CoverageSliceConfig& config,
                                      const AnalysisControl& control = {});

/// A pose at which no sensor reads more than the threshold of one component.
struct Counterexample {
    int component = 0; ///< 0 R, 1 Theta, 2 Phi
    models::OrientationAngles at;
    double largest_T = 0.0;
};

struct CoverageJudgement {
    bool isProven = false; ///< every component exceeds the threshold everywhere
    /// At most one for each component and sign of the spin, least spin first.
    std::vector<Counterexample> counterexamples;
};

/// Errors: Interrupted. Source: resources/help/spherical-theory.md section 6.
Result<CoverageJudgement> judgeCoverage(const models::CoverageModel& model, double threshold_T,
                                        const AnalysisControl& control = {});

/// A direction of the shaft, and how many of its spins are not covered.
struct UncoveredShaft {
    double alpha_rad = 0.0;
    double beta_rad = 0.0;
    double share = 0.0; ///< of the spins, above 0
};

/// Coverage and figures of a placement over the whole workspace.
struct CoverageOfWorkspace {
    std::vector<UncoveredShaft> uncovered; ///< alpha and beta every 3 degrees, spins every degree
    models::PlacementResult figures;
};

/// Coverage by `model`, figures of the placement on `device`; of the config the threshold and the noise.
/// Errors: those of checkSensorPoses(), Interrupted.
Result<CoverageOfWorkspace> coverageOfWorkspace(const models::CoverageModel& model,
                                                const models::PlacementDevice& device,
                                                const models::SensorTriple& placement,
                                                const CoverageSliceConfig& config,
                                                const AnalysisControl& control = {});

} // namespace halbench::app
