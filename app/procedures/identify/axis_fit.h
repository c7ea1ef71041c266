#pragma once

#include "control/base/result.h"

#include <Eigen/Core>
#include <vector>

namespace halbench::app {

/// Motion of an axis: the position of each row, and the effort that is held from it to the next.
struct AxisRows {
    std::vector<double> time_s;
    std::vector<double> position;
    std::vector<double> effort;
};

/// q'' + a q' = k (u - u_f sgn q') + o of one axis under an effort u that acts late, in SI of the axis.
struct AxisFit {
    double dampingRate_1_s = 0.0;
    double accelerationGain = 0.0;
    double breakawayEffort = 0.0;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< of these three, in this order
    double offset = 0.0;                                  ///< o, a constant acceleration
    double delay_s = 0.0;                                 ///< of the effort behind its row
    double freedom = 0.0;                                 ///< of Student's t
    double unexplained_ratio = 0.0;                       ///< of the acceleration, rms
    double drag_t =
        0.0;         ///< Student's t of a further term d q'|q'|: what a damping that grows with the speed has
    int windows = 0; ///< of the motion that were used
    int leftOut = 0; ///< because rows were missing
};

/// Weak form: the equation is multiplied by smooth functions of windows of 0.25 s and integrated by parts, so
/// that positions are never differentiated. Only windows count in which the axis moves one way, faster than
/// `slowest`, so that friction has one sign. The covariance takes the windows as independent clusters
/// (jackknife) and assumes nothing about the noise within; to it comes what the rows do not show of the way
/// in which the effort is held between them.
///
/// Errors: Refused (fewer than 20 whole windows, motion one way only, an effort that shows no effect or acts
/// later than 8 rows), NotFinite.
Result<AxisFit> fitAxis(const AxisRows& rows, double slowest);

} // namespace halbench::app
