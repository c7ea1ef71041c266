#include "control/identify/motion_projection.h"

#include "control/base/units.h"
#include "control/identify/motion_shape.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

constexpr int RippleColumns = 6;

Eigen::MatrixXd reduced(const Eigen::HouseholderQR<Eigen::MatrixXd>& qr, const Eigen::MatrixXd& what) {
    Eigen::MatrixXd turned = qr.householderQ().transpose() * what;
    turned.topRows(MotionLocalColumns).setZero();
    return qr.householderQ() * turned;
}

} // namespace

int MotionColumns::count() const {
    return 2 * orders + (ripple ? RippleColumns : 0) + (loss.empty() ? 0 : 1);
}

MotionColumns affordableColumns(std::span<const MotionSegment> segments, int orders, bool hasRipple) {
    double travel = 0.0;
    std::size_t rows = 0;
    for (const MotionSegment& segment : segments) {
        travel += std::fabs(segment.angle_rad.back() - segment.angle_rad.front());
        rows += segment.angle_rad.size();
    }
    // An angle error can be told from motion only when every angle was passed at many different times.
    constexpr double EnoughTurns = 20.0;
    constexpr std::size_t EnoughRows = 600;
    MotionColumns columns;
    if (travel > EnoughTurns * 2.0 * Pi && rows > EnoughRows) {
        columns.orders = orders;
        columns.ripple = hasRipple;
    }
    return columns;
}

ProjectedSegment projectSegment(std::span<const MotionSegment> segments, std::size_t which, double damping,
                                const MotionColumns& columns) {
    const MotionSegment& segment = segments[which];
    ProjectedSegment part;
    part.local = localShape(segment, damping);
    part.angle = Eigen::Map<const Eigen::VectorXd>(segment.angle_rad.data(),
                                                   static_cast<Eigen::Index>(segment.angle_rad.size()));
    part.qr.compute(part.local);
    part.angleRest = reduced(part.qr, part.angle);
    part.global.resize(part.angle.size(), columns.count());
    if (columns.orders > 0) {
        part.global.leftCols(2 * columns.orders) = angleErrorShape(segment, columns.orders);
    }
    if (columns.ripple) {
        part.global.middleCols(2 * columns.orders, RippleColumns) = rippleShape(segment, damping);
    }
    if (!columns.loss.empty()) {
        part.global.rightCols(1) = columns.loss[which];
    }
    part.globalRest = reduced(part.qr, part.global);
    return part;
}

MotionSolution solveMotion(std::span<const MotionSegment> segments, double damping,
                           const MotionColumns& columns) {
    MotionSolution solution;
    Eigen::Index rows = 0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        solution.parts.push_back(projectSegment(segments, i, damping, columns));
        rows += solution.parts.back().angle.size();
    }
    solution.columns.resize(rows, columns.count());
    solution.rest.resize(rows);
    Eigen::Index row = 0;
    for (const ProjectedSegment& part : solution.parts) {
        solution.columns.middleRows(row, part.angle.size()) = part.globalRest;
        solution.rest.segment(row, part.angle.size()) = part.angleRest;
        row += part.angle.size();
    }
    if (columns.count() > 0) {
        solution.globalQr.setThreshold(1e-8);
        solution.globalQr.compute(solution.columns);
        solution.global = solution.globalQr.solve(solution.rest);
        solution.rest -= solution.columns * solution.global;
    }
    for (const ProjectedSegment& part : solution.parts) {
        const Eigen::VectorXd corrected =
            columns.count() > 0 ? Eigen::VectorXd(part.angle - part.global * solution.global) : part.angle;
        solution.local.emplace_back(part.qr.solve(corrected));
    }
    solution.squares = solution.rest.squaredNorm();
    return solution;
}

Eigen::VectorXd withoutLocal(const MotionSolution& solution, std::span<const Eigen::VectorXd> columns) {
    Eigen::VectorXd stacked(solution.rest.size());
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        stacked.segment(row, columns[i].size()) = reduced(solution.parts[i].qr, columns[i]);
        row += columns[i].size();
    }
    return stacked;
}

Eigen::VectorXd withoutGlobal(const MotionSolution& solution, const Eigen::VectorXd& stacked) {
    if (solution.global.size() == 0) {
        return stacked;
    }
    Eigen::VectorXd turned = solution.globalQr.householderQ().transpose() * stacked;
    turned.head(solution.globalQr.rank()).setZero();
    return solution.globalQr.householderQ() * turned;
}

Eigen::VectorXd dampingColumn(std::span<const MotionSegment> segments, const MotionSolution& solution,
                              double damping) {
    std::vector<Eigen::VectorXd> columns;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        columns.emplace_back(solution.local[i](2) * dampingShape(segments[i], damping));
    }
    return withoutLocal(solution, columns);
}

Result<ClusterFit> fitClusters(const MotionSolution& solution, const Eigen::MatrixXd& columns) {
    const Eigen::Index count = columns.cols();
    const Eigen::VectorXd scale = columns.colwise().norm().transpose();
    // A force that has faded at the speeds of the motion: its square, and all that follows, is no number.
    constexpr double Faded_ratio = 1e-12;
    if (!(scale.minCoeff() > Faded_ratio * scale.maxCoeff())) {
        return failure(ErrorCode::Refused, "the motion does not separate the forces",
                       "record run-ups and coast-downs over a wider range of speed");
    }
    const Eigen::MatrixXd scaled = columns * scale.cwiseInverse().asDiagonal();
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(scaled);
    const Eigen::MatrixXd R = qr.matrixQR().topRows(count).triangularView<Eigen::Upper>();
    constexpr double SmallestRest = 1e-4; // of a column, that the others do not explain
    if (!(R.diagonal().cwiseAbs().minCoeff() > SmallestRest)) {
        return failure(ErrorCode::Refused, "the motion does not separate the forces",
                       "record run-ups and coast-downs over a wider range of speed");
    }
    const Eigen::MatrixXd Q = qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), count);
    const Eigen::MatrixXd toValues =
        scale.cwiseInverse().asDiagonal() *
        R.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(count, count)).eval();
    const Eigen::VectorXd whitened = Q.transpose() * solution.rest;
    ClusterFit fit;
    fit.values = toValues * whitened;
    fit.rest = solution.rest - Q * whitened;
    const Eigen::MatrixXd directions = toValues.rowwise().normalized();
    Eigen::MatrixXd meat = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(count);
    Eigen::Index row = 0;
    for (const ProjectedSegment& part : solution.parts) {
        const auto here = Q.middleRows(row, part.angle.size());
        const Eigen::MatrixXd leverage = here.transpose() * here;
        constexpr double LargestLeverage = 0.99; // a segment alone says nothing of its own error
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(leverage);
        const Eigen::VectorXd factors =
            (1.0 - eigen.eigenvalues().array().min(LargestLeverage)).sqrt().inverse();
        const Eigen::VectorXd score = eigen.eigenvectors() * factors.asDiagonal() *
                                      eigen.eigenvectors().transpose() * here.transpose() *
                                      fit.rest.segment(row, part.angle.size());
        meat += score * score.transpose();
        squares += (directions * leverage * directions.transpose()).diagonal().cwiseAbs2();
        row += part.angle.size();
    }
    fit.covariance = toValues * meat * toValues.transpose();
    fit.freedom = (squares.cwiseInverse().array() - 1.0).max(1.0);
    return fit;
}

Eigen::MatrixXd clusterMeat(const MotionSolution& solution, const Eigen::MatrixXd& columns) {
    Eigen::MatrixXd meat = Eigen::MatrixXd::Zero(columns.cols(), columns.cols());
    Eigen::Index row = 0;
    for (const ProjectedSegment& part : solution.parts) {
        const Eigen::Index n = part.angle.size();
        const Eigen::VectorXd score = columns.middleRows(row, n).transpose() * solution.rest.segment(row, n);
        meat += score * score.transpose();
        row += n;
    }
    return meat;
}

Eigen::MatrixXd sandwichCovariance(const MotionSolution& solution, const Eigen::VectorXd& damping) {
    Eigen::MatrixXd all(damping.size(), solution.columns.cols() + 1);
    all << solution.columns, damping;
    const Eigen::VectorXd scale = all.colwise().norm().cwiseMax(1e-300).cwiseInverse().transpose();
    all = all * scale.asDiagonal();
    const auto count = static_cast<double>(solution.parts.size());
    const Eigen::MatrixXd meat = clusterMeat(solution, all) * (count / (count - 1.0));
    // In one direction only, ripple of torque and of friction look the same: the pseudo-inverse.
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> normal;
    normal.setThreshold(1e-12);
    normal.compute(all.transpose() * all);
    const Eigen::MatrixXd bread = normal.pseudoInverse();
    return scale.asDiagonal() * bread * meat * bread * scale.asDiagonal();
}

} // namespace halbench::control
