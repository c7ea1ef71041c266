#include "models/spherical/any_estimator.h"

#include "control/base/assert.h"
#include "control/base/units.h"
#include "models/spherical/additive_inverse.h"
#include "models/spherical/orientation.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace halbench::models {
namespace {

bool hasClosedForm(const AdditiveModel& model) {
    constexpr double Slack_rad = 1e-6; // boards keep angles in single precision
    const PlacementAngles& first = model.placement[1];
    return std::abs(first.alpha_rad) + std::abs(first.beta_rad) + std::abs(first.gamma_rad - 0.25 * Pi) <
           Slack_rad;
}

constexpr ChannelMask FirstTwoSensors = {true, true, true, true, true, true, false, false, false};

AdditiveEstimator closedForm(const AdditiveModel& model, bool isFitted) {
    if (!isFitted) {
        return [model](const SphericalReadings& readings_T) -> std::optional<AdditiveEstimate> {
            return AdditiveEstimate{additiveInverse(model.strength_T, readings_T), FirstTwoSensors, true};
        };
    }
    return [model](const SphericalReadings& readings_T) -> std::optional<AdditiveEstimate> {
        const AdditiveFit fit =
            fitAdditiveModel(model, readings_T, additiveInverse(model.strength_T, readings_T));
        return fit.hasConverged ? std::optional(AdditiveEstimate{fit.angles}) : std::nullopt;
    };
}

} // namespace

Result<AdditiveEstimator> makeAdditiveEstimator(const AnyEstimatorConfig& config) {
    HB_ASSERT(config.kind > EstimatorKind::LevenbergMarquardt);
    if (auto checked = checkSwarmConfig(config.swarm); !checked) {
        return failure(checked.error());
    }
    if (config.kind != EstimatorKind::Swarm) {
        if (!hasClosedForm(config.additive)) {
            return failure(ErrorCode::OutOfRange,
                           "The closed form of the additive model needs sensor 1 at (0, 0, 45 degrees).");
        }
        return closedForm(config.additive, config.kind == EstimatorKind::ClosedFitted);
    }
    const auto random = std::make_shared<Random>(config.seed); // a function may be copied
    return AdditiveEstimator([random, model = angleModel(config.additive), swarm = config.swarm](
                                 const SphericalReadings& readings_T) -> std::optional<AdditiveEstimate> {
        const SwarmEstimate found = estimateBySwarm(model, swarm, readings_T, *random);
        return AdditiveEstimate{found.angles, found.channels};
    });
}

Result<AnyEstimator> makeAnyEstimator(const AnyEstimatorConfig& config) {
    if (config.kind <= EstimatorKind::LevenbergMarquardt) {
        OrientationConfig settings = config.settings;
        settings.method = static_cast<OrientationMethod>(static_cast<int>(config.kind));
        auto estimator = OrientationEstimator::make(config.sensing, settings);
        if (!estimator) {
            return failure(estimator.error());
        }
        return AnyEstimator(
            [estimator = *estimator](const SphericalReadings& readings_T) -> std::optional<Eigen::Matrix3d> {
                const OrientationEstimate estimate = estimator.estimate(readings_T);
                if (estimate.verdict != OrientationVerdict::Determined) {
                    return std::nullopt;
                }
                return estimate.rotation;
            });
    }
    auto additive = makeAdditiveEstimator(config);
    if (!additive) {
        return failure(additive.error());
    }
    return AnyEstimator([additive = *std::move(additive)](
                            const SphericalReadings& readings_T) -> std::optional<Eigen::Matrix3d> {
        const std::optional<AdditiveEstimate> found = additive(readings_T);
        return found ? std::optional(representative(rotationOf(found->angles))) : std::nullopt;
    });
}

EstimatorErrors estimatorErrors(const AnyEstimator& estimator, std::span<const SphericalReadings> readings_T,
                                std::span<const Eigen::Matrix3d> truth, double failureLimit_rad) {
    HB_ASSERT(readings_T.size() == truth.size());
    EstimatorErrors errors;
    double square = 0.0;
    int estimated = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        ++errors.poses;
        const std::optional<Eigen::Matrix3d> found = estimator(readings_T[i]);
        if (!found) {
            ++errors.failures;
            continue;
        }
        const double off_rad = symmetricError_rad(*found, truth[i]);
        square += off_rad * off_rad;
        ++estimated;
        errors.worst_rad = std::max(errors.worst_rad, off_rad);
        errors.failures += off_rad > failureLimit_rad;
    }
    errors.rms_rad = estimated > 0 ? std::sqrt(square / estimated) : 0.0;
    return errors;
}

} // namespace halbench::models
