#include "control/identify/least_squares.h"

#include "control/base/assert.h"

#include <fmt/format.h>

#include <Eigen/QR>

namespace halbench::control {
namespace {

constexpr double RankTolerance = 1e-10;

Eigen::Index usableRows(const Eigen::VectorXd& weights) {
    return (weights.array() > 0.0).count();
}

Result<void> checkProblem(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed,
                          const Eigen::VectorXd& weights) {
    HB_ASSERT(design.rows() == observed.size() && design.rows() == weights.size() && design.cols() > 0);
    if (!design.allFinite() || !observed.allFinite() || !weights.allFinite()) {
        return failure(ErrorCode::NotFinite, "a value of the fit is not a finite number",
                       "check the recording for gaps or faults");
    }
    HB_ASSERT(weights.size() == 0 || weights.minCoeff() >= 0.0);
    if (usableRows(weights) < design.cols()) {
        return failure(ErrorCode::Refused,
                       fmt::format("{} usable points cannot determine {} coefficients", usableRows(weights),
                                   design.cols()),
                       "measure more points");
    }
    return {};
}

Eigen::VectorXd columnScales(const Eigen::MatrixXd& weighted) {
    Eigen::VectorXd scales = weighted.colwise().norm().transpose();
    return (scales.array() > 0.0).select(scales, 1.0);
}

} // namespace

Result<LinearFit> fitLinear(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed,
                            const Eigen::VectorXd& weights) {
    if (const auto checked = checkProblem(design, observed, weights); !checked) {
        return failure(checked.error());
    }
    const Eigen::VectorXd root = weights.cwiseSqrt();
    Eigen::MatrixXd weighted = root.asDiagonal() * design;
    const Eigen::VectorXd scales = columnScales(weighted);
    weighted = weighted * scales.cwiseInverse().asDiagonal();
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(weighted);
    qr.setThreshold(RankTolerance);
    const Eigen::Index columns = design.cols();
    if (qr.rank() < columns) {
        return failure(ErrorCode::Refused, "the points do not separate the coefficients",
                       "use more different currents, speeds or directions");
    }
    LinearFit fit;
    fit.coefficients = scales.cwiseInverse().asDiagonal() * qr.solve(root.cwiseProduct(observed)).eval();
    fit.residuals = observed - design * fit.coefficients;
    fit.freedom = static_cast<int>(usableRows(weights) - columns);
    const double sum = (weights.array() * fit.residuals.array().square()).sum();
    fit.residualVariance = fit.freedom > 0 ? sum / fit.freedom : 0.0;

    // (X'WX)^-1 = P R^-1 R^-T P' in scaled columns
    const Eigen::MatrixXd inverseR = qr.matrixR()
                                         .topLeftCorner(columns, columns)
                                         .triangularView<Eigen::Upper>()
                                         .solve(Eigen::MatrixXd::Identity(columns, columns));
    const Eigen::MatrixXd half = scales.cwiseInverse().asDiagonal() * (qr.colsPermutation() * inverseR);
    fit.unscaled = half * half.transpose();
    fit.covariance = fit.residualVariance * fit.unscaled;
    fit.leverage = ((root.asDiagonal() * design) * half).rowwise().squaredNorm();
    return fit;
}

Result<LinearFit> fitLinear(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed) {
    return fitLinear(design, observed, Eigen::VectorXd::Ones(observed.size()));
}

double rSquared(const LinearFit& fit, const Eigen::VectorXd& observed, const Eigen::VectorXd& weights) {
    const double mean = weights.dot(observed) / weights.sum();
    const double total = (weights.array() * (observed.array() - mean).square()).sum();
    const double rest = (weights.array() * fit.residuals.array().square()).sum();
    return total > 0.0 ? 1.0 - rest / total : 1.0;
}

double mean(std::span<const double> values) {
    HB_ASSERT(!values.empty());
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    return sum / static_cast<double>(values.size());
}

} // namespace halbench::control
