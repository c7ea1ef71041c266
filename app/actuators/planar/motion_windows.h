#pragma once

#include "app/actuators/planar/platen_motion.h"

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

namespace halbench::app {

/// Functions of a window of 0.4 s: sin^2(pi s) times 1, cosine and sine of 2.5, 5 and 7.5 Hz.
inline constexpr int WindowHarmonics = 3;
inline constexpr int WindowFunctions = 1 + 2 * WindowHarmonics;
/// Harmonic of the window that a function belongs to, 0 ... WindowHarmonics.
inline int harmonicOf(int function) {
    return (function + 1) / 2;
}

/// Errors of the poses that are common to all of them: those of the calibration of the chips.
struct PoseErrors {
    std::function<PoseSensitivity(std::size_t row)> sensitivity; ///< empty: exact poses
    Eigen::MatrixXd covariance;                                  ///< of the unknowns of the calibration
};

/// Integrals of one window with one function: of each coordinate's acceleration, speed, value and sign of the
/// speed, of the function itself, and of the forces of each coil and their derivatives.
struct Moments {
    Eigen::Vector3d acceleration, speed, place, sign;
    double one = 0.0;
    Eigen::Matrix<double, 3, models::CoilCount> force, forceRate;
};

/// The same of the changes of the pose with the calibration.
struct ErrorMoments {
    PoseSensitivity acceleration = PoseSensitivity::Zero();
    PoseSensitivity speed = PoseSensitivity::Zero();
    PoseSensitivity place = PoseSensitivity::Zero();
};

/// One window of a motion.
struct Window {
    std::array<Moments, WindowFunctions> moments;
    std::vector<ErrorMoments> errors; ///< one a function; empty for exact poses
};

/// The whole windows of a motion in which current flows.
struct MotionWindows {
    std::vector<Window> windows;
    int leftOut = 0; ///< because rows are missing
};

/// Integrals of all windows. Positions are integrated by parts, so that they are never differentiated; forces
/// follow from the windings of the nominal geometry and the currents, which are held from row to row.
/// `poses`: one a row.
MotionWindows integrateWindows(const PlatenMotion& motion, const std::vector<models::PlanarPose>& poses,
                               const models::PlanarGeometry& geometry, const PoseErrors& errors);

} // namespace halbench::app
