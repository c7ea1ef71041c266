#pragma once

#include "app/analyses/spherical/orientation_confidence.h"
#include "app/analyses/spherical/orientation_readings.h"
#include "app/analyses/spherical/placement_choice.h"
#include "app/procedures/base/procedure.h"
#include "models/spherical/any_estimator.h"
#include "models/spherical/orientation_uncertainty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace halbench::app {

/// A value that an estimator or a recording does not give.
constexpr double Missing = std::numeric_limits<double>::quiet_NaN();
/// Nearer to a wrong pose than this: an error of the branch, not of the noise.
constexpr double BranchLimit_rad = 0.17453292519943295;

/// One row of the result.
struct OrientedPose {
    models::OrientationEstimate estimate;
    bool hasUncertainty = false;
    models::UncertaintyGap gap = models::UncertaintyGap::None; ///< why an oriented one has none
    models::OrientationAngles angles;
    models::ShaftDirection shaft;
    models::AngleIntervals interval;
    double cone_rad = Missing;
    double misfit_ratio = Missing; ///< of an additive estimate: residuals over readings, both rms
    double error_rad = Missing;    ///< against the truth, modulo the symmetry of the rotor

    bool isOriented() const {
        return estimate.verdict == models::OrientationVerdict::Determined ||
               estimate.verdict == models::OrientationVerdict::Reduced;
    }
};

struct Orientation {
    models::EstimatorKind kind = models::EstimatorKind::Refined;
    PlacementChoice choice;
    models::SwarmConfig swarm; ///< of the estimator 'swarm'
    std::optional<OrientationConfidence> confidence;
    OrientationReadings readings;
    double tensorError_ratio = 0.0; ///< with a stray field as an unknown: rms along its weakest direction
    std::vector<OrientedPose> poses;

    bool isTensor() const { return kind <= models::EstimatorKind::LevenbergMarquardt; }
    std::size_t count(models::OrientationVerdict verdict) const {
        return static_cast<std::size_t>(
            std::count_if(poses.begin(), poses.end(),
                          [verdict](const OrientedPose& pose) { return pose.estimate.verdict == verdict; }));
    }
};

/// Values of the poses with an orientation, without those that are missing.
template <typename Value>
std::vector<double> ofPoses(const Orientation& work, Value value) {
    std::vector<double> values;
    for (const OrientedPose& pose : work.poses) {
        if (pose.isOriented() && std::isfinite(value(pose))) {
            values.push_back(value(pose));
        }
    }
    return values;
}

/// Missing without values.
double percentile(std::vector<double> values, double ratio);

/// Verdict and findings about the orientations: poses without one, channels left out, residuals and cones
/// that are too large, and what the known truth contradicts.
DataQuality qualityOf(const Orientation& work);

} // namespace halbench::app
