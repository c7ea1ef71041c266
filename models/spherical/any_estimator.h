#pragma once

#include "models/spherical/additive_model.h"
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

/// Errors: of OrientationEstimator::make() and checkSwarmConfig(); OutOfRange for the closed form with sensor
/// 1 elsewhere than at (0, 0, 45 degrees). The swarm's random numbers go on from call to call.
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
