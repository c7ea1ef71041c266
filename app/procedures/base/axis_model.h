#pragma once

#include "app/procedures/base/measured_timing.h"
#include "app/procedures/base/procedure.h"
#include "control/identify/joint_estimate.h"

#include <string>
#include <vector>

namespace halbench::app {

/// One identified axis under an effort u (force, torque or current), in SI of the axis:
///     q'' + a q' = k (u - u_f sgn q').
/// An estimate that was not identifiable has no value; a breakaway effort without one counts as 0.
struct IdentifiedAxis {
    std::string axis;                   ///< `AxisSpec::id`
    std::string positionUnit = "rad";   ///< "rad" or "m"
    std::string effortUnit = "A";       ///< "A", "N", "N*m"
    control::Estimate dampingRate;      ///< a in 1/s
    control::Estimate accelerationGain; ///< k in position unit/(s^2 effort unit)
    control::Estimate breakawayEffort;  ///< u_f in the effort unit
    MeasuredTiming timing = {};         ///< of the loop that it was measured with
};

/// The identified axes of an actuator with their joint uncertainty. Names of the covariance are
/// "x.damping_rate", "x.acceleration_gain", "x.breakaway_effort"; what it does not name is taken as exact.
struct AxisModel {
    std::vector<IdentifiedAxis> axes;
    std::vector<std::string> covarianceNames;
    std::vector<std::vector<double>> covariance;
    std::vector<Finding> doubts = {}; ///< of its measurement (doubtsOfModel)

    const IdentifiedAxis* find(const std::string& axis) const;
};

/// Unit of k: "m/(s^2*N)".
std::string accelerationGainUnit(const IdentifiedAxis& axis);

/// The one place where a model is judged. Errors: InvalidInput (no axis, one named twice, another unit, a
/// covariance that does not fit its names or names what is not there), NotFinite, OutOfRange (gain not
/// positive, damping or friction negative), Refused (an axis without damping rate or gain), each naming the
/// axis.
Result<void> checkAxisModel(const AxisModel& model);

} // namespace halbench::app
