#pragma once

#include "app/analyses/spherical/recorded_rows.h"
#include "models/spherical/any_estimator.h"
#include "models/spherical/coverage/placed_sensor.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::app {

/// Poses on which estimators are compared.
enum class ComparedPoses { Workspace, Trajectory1, Trajectory2, Trajectory3, Trajectory4 };
inline constexpr std::array<std::string_view, 5> ComparedPosesNames = {
    "workspace", "trajectory1", "trajectory2", "trajectory3", "trajectory4"};

/// Device, poses and errors of a comparison of estimators.
struct EstimatorComparisonConfig {
    models::SphericalDevice device = models::SphericalDevice::Exact; ///< makes the readings
    models::SphericalSensing sensing;                                ///< with the harmonics of the device
    models::AdditiveModel additive;                                  ///< of the same device
    ComparedPoses poses = ComparedPoses::Workspace;
    int count = 2000;      ///< random poses of the workspace
    double spin_rad = 0.0; ///< along a trajectory
    int passes = 0;        ///< how often estimators correct the harmonics; 0: they do not know them
    bool isStrengthFree = true;
    double noise_T = 0.0;                            ///< of a reading, rms
    double failureLimit_rad = 0.0017453292519943296; ///< 0.1 degrees: a larger error is a failure
    std::uint64_t seed = 1;                          ///< of poses, noise and swarm
    models::SwarmConfig swarm;                       ///< settings of the published search
    /// Take the place of poses and readings that are made; their noise is their own.
    std::shared_ptr<const RecordedRows> rows;
    double possibleLimit_ratio = 1.0;          ///< as models::OrientationConfig
    std::optional<models::EstimatorKind> only; ///< empty: all of them
    bool keepsPoses = false;                   ///< for pictures of a few poses
};

/// One estimator on all poses, modulo the symmetry of the rotor.
struct ComparedEstimator {
    models::EstimatorKind kind = models::EstimatorKind::Refined;
    std::optional<models::EstimatorErrors> errors; ///< empty: it does not suit the placement
    std::string reason;                            ///< why it does not
    double shaftRms_rad = 0.0;
    int estimated = 0;                   ///< poses with an estimate, right or wrong
    std::optional<double> timePerPose_s; ///< with a clock only
    /// Of the four orientations with the same field those nearest to the truth; empty where poses are not
    /// kept.
    std::vector<std::optional<Eigen::Matrix3d>> found;
};

struct EstimatorComparison {
    int poses = 0;
    int inside = 0; ///< of the workspace
    /// False: recorded rows without true angles, compared with the projector with a Gauss-Newton step.
    bool isAgainstTruth = true;
    std::vector<ComparedEstimator> estimators;
    std::vector<Eigen::Matrix3d> truth; ///< empty where poses are not kept
};

/// A running time in seconds; empty: nothing is timed.
using StopWatch = std::function<double()>;

/// Every estimator on the same poses with the same noise, or on the same recorded rows. Equal settings give
/// equal errors; the time is that of this machine now. Errors: of makeAnyEstimator(); Refused (no row to
/// compare with); Interrupted.
Result<EstimatorComparison> compareEstimators(const EstimatorComparisonConfig& config,
                                              const AnalysisControl& control, const StopWatch& now_s = {});

} // namespace halbench::app
