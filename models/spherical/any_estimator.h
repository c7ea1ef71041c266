#pragma once

#include "models/spherical/additive_uncertainty.h"
#include "models/spherical/orientation_estimator.h"
#include "models/spherical/swarm_estimator.h"

#include <functional>
#include <optional>
#include <span>
#include <string_view>

namespace halbench::models {

/// Every estimator, for crossing with every device.
enum class EstimatorKind {
    Tensor,
    Projector,
    Refined,
    LevenbergMarquardt,
    Closed,       ///< closed form of the additive model
    ClosedFitted, ///< the same, then least squares over all nine readings
    Swarm,        ///< published search on the additive model
};
inline constexpr std::array<std::string_view, 7> EstimatorNames = {"tensor", "projector",     "refined", "lm",
                                                                   "closed", "closed-fitted", "swarm"};

struct AnyEstimatorConfig {
    EstimatorKind kind = EstimatorKind::Refined;
    SphericalSensing sensing;   ///< of the first four
    OrientationConfig settings; ///< of the first four; the method is that of the kind
    AdditiveModel additive;     ///< of the others
    SwarmConfig swarm;
    std::uint64_t seed = 1; ///< of the swarm
};

/// Orientation as representative(), empty when the estimator gives none.
using AnyEstimator = std::function<std::optional<Eigen::Matrix3d>(const SphericalReadings&)>;

/// Estimators of the additive model, with what decides their angles; empty when there is no estimate.
using AdditiveEstimator = std::function<std::optional<AdditiveEstimate>(const SphericalReadings&)>;

/// Errors: of checkSwarmConfig(); OutOfRange for the closed form with sensor 1 elsewhere than at (0, 0, 45
/// degrees). The kind is one of the last three. The swarm's random numbers go on from call to call.
Result<AdditiveEstimator> makeAdditiveEstimator(const AnyEstimatorConfig& config);

/// Errors: of OrientationEstimator::make() and makeAdditiveEstimator().
Result<AnyEstimator> makeAnyEstimator(const AnyEstimatorConfig& config);

/// Errors over many poses, modulo the symmetry of the rotor.
struct EstimatorErrors {
    double rms_rad = 0.0; ///< of the poses with an estimate
    double worst_rad = 0.0;
    int failures = 0; ///< no estimate, or off by more than the limit
    int poses = 0;
};
EstimatorErrors estimatorErrors(const AnyEstimator& estimator, std::span<const SphericalReadings> readings_T,
                                std::span<const Eigen::Matrix3d> truth, double failureLimit_rad);

} // namespace halbench::models
