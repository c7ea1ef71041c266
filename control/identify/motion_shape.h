#pragma once

#include "control/identify/motion_segments.h"

#include <Eigen/Core>
#include <functional>

namespace halbench::control {

/// Columns of the model that fitMotion() solves for one segment; t counts from the segment's start.

/// 1, t, (e^{-a t} - 1 + a t)/a^2: start angle, start speed, start acceleration. Smooth through a = 0.
Eigen::MatrixXd localShape(const MotionSegment& segment, double damping_per_s);

/// Derivative of the third column by a.
Eigen::VectorXd dampingShape(const MotionSegment& segment, double damping_per_s);

/// cos k theta, sin k theta for k = 1 ... orders, of the measured angle.
Eigen::MatrixXd angleErrorShape(const MotionSegment& segment, int orders);

/// Response of delta'' + a delta' to unit ripple: torque cos theta, sin theta (offset of a phase current),
/// friction s cos theta, s sin theta, torque I cos 2 theta, I sin 2 theta (unequal phase gains). Trapezoidal
/// from rest; the free start of the segment takes up the homogeneous part.
Eigen::MatrixXd rippleShape(const MotionSegment& segment, double damping_per_s);

/// Speed and acceleration at the start of a segment, which relaxes from there with the damping.
struct SpeedCourse {
    double speed_rad_s = 0.0;
    double acceleration_rad_s2 = 0.0;
};

/// Response of delta'' + a delta' to force(omega(t)), an acceleration that depends on the speed.
Eigen::VectorXd forceShape(const MotionSegment& segment, double damping_per_s, const SpeedCourse& course,
                           const std::function<double(double)>& force_rad_s2);

/// Angle and speed of delta'' + a delta' = force, from rest; one value of the force for each row.
struct ForceResponse {
    Eigen::VectorXd angle;
    Eigen::VectorXd speed;
};
ForceResponse forceResponse(const MotionSegment& segment, double damping_per_s,
                            const Eigen::VectorXd& force_rad_s2);

} // namespace halbench::control
