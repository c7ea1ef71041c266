#pragma once

#include "control/identify/motion_segments.h"

#include <Eigen/Core>
#include <Eigen/QR>
#include <span>
#include <vector>

namespace halbench::control {

/// Unknowns of one segment: start angle, start speed, start acceleration.
inline constexpr int MotionLocalColumns = 3;

/// The linear unknowns that all segments share.
struct MotionColumns {
    int orders = 0;      ///< of the sensors' angle error
    bool ripple = false; ///< torque and friction once and twice per turn
    /// Response of each segment to the loss of torque at speed, the last column; empty: not fitted.
    std::vector<Eigen::VectorXd> loss;
    int count() const;
};

/// As many orders and the ripple as the travel and the rows of the segments can carry.
MotionColumns affordableColumns(std::span<const MotionSegment> segments, int orders, bool hasRipple);

/// Coefficients of one to three columns, without what local and global unknowns explain, each segment being
/// a cluster: CR2, the residuals of a segment raised by (1 - leverage)^-1/2 in the columns' own space.
struct ClusterFit {
    Eigen::VectorXd values;
    Eigen::MatrixXd covariance;
    Eigen::VectorXd
        freedom; ///< of Student's t: what the spread of the leverage leaves of the clusters, less one
    Eigen::VectorXd rest; ///< residual, stacked
};

/// One segment for one value of the damping, local unknowns projected out.
struct ProjectedSegment {
    Eigen::MatrixXd local;      ///< n x 3
    Eigen::MatrixXd global;     ///< n x q as is
    Eigen::MatrixXd globalRest; ///< without the part the local unknowns explain
    Eigen::VectorXd angle;
    Eigen::VectorXd angleRest;
    Eigen::HouseholderQR<Eigen::MatrixXd> qr;
};

ProjectedSegment projectSegment(std::span<const MotionSegment> segments, std::size_t which, double damping,
                                const MotionColumns& columns);

/// All segments for one value of the damping, all linear unknowns solved.
struct MotionSolution {
    std::vector<ProjectedSegment> parts;
    Eigen::MatrixXd columns; ///< global columns without the local ones, stacked
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> globalQr;
    Eigen::VectorXd global;
    Eigen::VectorXd rest; ///< stacked residual
    std::vector<Eigen::Vector3d> local;
    double squares = 0.0;
};

/// Cost: samples times q^2.
MotionSolution solveMotion(std::span<const MotionSegment> segments, double damping,
                           const MotionColumns& columns);

/// A column of each segment, stacked, without what the local unknowns explain.
Eigen::VectorXd withoutLocal(const MotionSolution& solution, std::span<const Eigen::VectorXd> columns);
/// The same without what the global unknowns explain.
Eigen::VectorXd withoutGlobal(const MotionSolution& solution, const Eigen::VectorXd& stacked);
/// Derivative of the model by the damping, local unknowns projected out.
Eigen::VectorXd dampingColumn(std::span<const MotionSegment> segments, const MotionSolution& solution,
                              double damping);

/// Errors: Refused (columns that do not tell each other apart, or less than two segments that carry them).
Result<ClusterFit> fitClusters(const MotionSolution& solution, const Eigen::MatrixXd& columns);

/// Sum over the segments of (column' residual)(column' residual)': what independent clusters make of the
/// variance of the columns' coefficients.
Eigen::MatrixXd clusterMeat(const MotionSolution& solution, const Eigen::MatrixXd& columns);

/// Covariance of the global unknowns and the damping (last) by the sandwich over segments.
Eigen::MatrixXd sandwichCovariance(const MotionSolution& solution, const Eigen::VectorXd& damping);

} // namespace halbench::control
