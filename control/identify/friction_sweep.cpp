#include "control/identify/friction_sweep.h"

#include "control/identify/resampling.h"
#include "control/identify/robust_fit.h"
#include "control/identify/scatter_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace halbench::control {
namespace {

// Columns |I|, then one intercept per direction that was visited.
struct Problem {
    Eigen::MatrixXd design;
    Eigen::VectorXd speed;    // s omega
    Eigen::VectorXd variance; // of the measurement
    Eigen::MatrixXd shared;   // what one sigma of each shared error that there is does to s omega
    int forwardColumn = -1;
    int reverseColumn = -1;
};

Result<Problem> makeProblem(std::span<const SteadyPoint> points) {
    const auto isForward = [](const SteadyPoint& point) { return point.current_A > 0.0; };
    const auto forward = std::count_if(points.begin(), points.end(), isForward);
    const auto count = static_cast<Eigen::Index>(points.size());
    Problem problem;
    int columns = 1;
    problem.forwardColumn = forward > 0 ? columns++ : -1;
    problem.reverseColumn = forward < count ? columns++ : -1;
    problem.design = Eigen::MatrixXd::Zero(count, columns);
    problem.speed.resize(count);
    problem.variance.resize(count);
    problem.shared = Eigen::MatrixXd::Zero(count, 2);
    for (Eigen::Index i = 0; i < count; ++i) {
        const SteadyPoint& point = points[static_cast<std::size_t>(i)];
        const double sign = isForward(point) ? 1.0 : -1.0;
        if (!(sign * point.speed_rad_s > 0.0)) {
            return failure(ErrorCode::Refused,
                           "at one plateau the rotor stands still or turns against the current",
                           "exclude plateaus that come to rest from the fit");
        }
        problem.design(i, 0) = std::fabs(point.current_A);
        problem.design(i, isForward(point) ? problem.forwardColumn : problem.reverseColumn) = 1.0;
        problem.speed(i) = sign * point.speed_rad_s;
        problem.variance(i) = point.speedError_rad_s * point.speedError_rad_s;
        problem.shared(i, 0) = sign * point.sharedError_rad_s;
        problem.shared(i, 1) = sign * point.settingError_rad_s;
    }
    for (Eigen::Index k = problem.shared.cols() - 1; k >= 0; --k) {
        if (problem.shared.col(k).isZero(0.0)) {
            problem.shared.col(k) = problem.shared.rightCols(1).eval();
            problem.shared.conservativeResize(count, problem.shared.cols() - 1);
        }
    }
    return problem;
}

// (c/phi, K_f/phi) from slope and intercepts.
Eigen::VectorXd quantities(const Eigen::VectorXd& coefficients) {
    const double slope = coefficients(0);
    const Eigen::Index directions = coefficients.size() - 1;
    const double intercept = coefficients.tail(directions).mean();
    Eigen::VectorXd result(2);
    result << 1.0 / slope, -intercept / slope;
    return result;
}

// Delta method: derivatives of the quantities by slope b and intercepts d.
Eigen::MatrixXd quantityJacobian(const Eigen::VectorXd& coefficients) {
    const double slope = coefficients(0);
    const Eigen::Index directions = coefficients.size() - 1;
    const double intercept = coefficients.tail(directions).mean();
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(2, coefficients.size());
    jacobian(0, 0) = -1.0 / (slope * slope);
    jacobian(1, 0) = intercept / (slope * slope);
    jacobian.row(1).tail(directions).setConstant(-1.0 / (slope * static_cast<double>(directions)));
    return jacobian;
}

// The fit of slope and intercepts. A shared error is one more unknown, whose prior N(0, 1) is one more row;
// it is taken off the speeds, and what is left of the fit is that of the points.
Result<ScatterFit> fitPoints(Problem& problem) {
    const Eigen::Index errors = problem.shared.cols();
    if (errors == 0) {
        return fitWithScatter(problem.design, problem.speed, problem.variance);
    }
    const Eigen::Index rows = problem.design.rows();
    const Eigen::Index columns = problem.design.cols();
    constexpr double PriorScale = 1e3; // the points' scatter, which joins every row, is nothing beside it
    Eigen::MatrixXd design = Eigen::MatrixXd::Zero(rows + errors, columns + errors);
    design.topLeftCorner(rows, columns) = problem.design;
    design.topRightCorner(rows, errors) = problem.shared;
    design.bottomRightCorner(errors, errors).diagonal().setConstant(PriorScale);
    Eigen::VectorXd speed = Eigen::VectorXd::Zero(rows + errors);
    speed.head(rows) = problem.speed;
    Eigen::VectorXd variance(rows + errors);
    variance << problem.variance, Eigen::VectorXd::Constant(errors, PriorScale * PriorScale);
    auto scatter = fitWithScatter(design, speed, variance);
    if (scatter) {
        LinearFit& fit = scatter->fit;
        problem.speed -= problem.shared * fit.coefficients.tail(errors);
        fit.coefficients.conservativeResize(columns);
        fit.covariance.conservativeResize(columns, columns);
        fit.unscaled.conservativeResize(columns, columns);
        fit.residuals.conservativeResize(rows);
        fit.leverage.conservativeResize(rows);
        scatter->weights.conservativeResize(rows);
    }
    return scatter;
}

void addDirections(FrictionSweep& sweep, const Problem& problem, const LinearFit& fit) {
    const double slope = fit.coefficients(0);
    if (problem.forwardColumn > 0) {
        sweep.frictionForward_A = -fit.coefficients(problem.forwardColumn) / slope;
    }
    if (problem.reverseColumn > 0) {
        sweep.frictionReverse_A = -fit.coefficients(problem.reverseColumn) / slope;
    }
    if (!sweep.frictionForward_A || !sweep.frictionReverse_A) {
        return;
    }
    const double plus = fit.coefficients(problem.forwardColumn);
    const double minus = fit.coefficients(problem.reverseColumn);
    const double sum = plus + minus;
    if (sum == 0.0) {
        return;
    }
    sweep.asymmetry = (plus - minus) / sum;
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(fit.coefficients.size());
    gradient(problem.forwardColumn) = 2.0 * minus / (sum * sum);
    gradient(problem.reverseColumn) = -2.0 * plus / (sum * sum);
    sweep.asymmetryError = std::sqrt(gradient.dot(fit.covariance * gradient));
}

void addAdequacy(FrictionSweep& sweep, std::span<const SteadyPoint> points, int parameters) {
    std::vector<double> levels;
    levels.reserve(points.size());
    for (const SteadyPoint& point : points) {
        levels.push_back(point.current_A);
    }
    if (const auto test = testLackOfFit(levels, sweep.residuals_rad_s, parameters)) {
        sweep.lackOfFit = *test;
    }
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [points](std::size_t a, std::size_t b) {
        return std::fabs(points[a].speed_rad_s) < std::fabs(points[b].speed_rad_s);
    });
    std::vector<double> bySpeed;
    bySpeed.reserve(order.size());
    for (const std::size_t i : order) {
        bySpeed.push_back(sweep.residuals_rad_s[i]);
    }
    sweep.runs = testRuns(bySpeed);
}

Result<void> addSecondOpinions(FrictionSweep& sweep, const Problem& problem, const ScatterFit& scatter,
                               std::uint64_t seed) {
    const auto robust = fitRobust(problem.design, problem.speed, scatter.weights);
    if (!robust) {
        return failure(robust.error());
    }
    sweep.robustWeights.assign(robust->weights.begin(), robust->weights.end());
    sweep.isRobustDifferent = robust->differsFromOrdinary;
    const Eigen::VectorXd sigma = sweep.covariance.diagonal().cwiseSqrt();
    const Eigen::MatrixXd influence =
        leaveOneOut(problem.design, problem.speed, scatter.weights, quantities, sigma);
    sweep.largestInfluence = influence.cwiseAbs().maxCoeff();
    if (const auto bootstrap =
            bootstrapPairs(problem.design, problem.speed, scatter.weights, quantities, seed)) {
        sweep.bootstrap95 = bootstrap->interval95;
    }
    return {};
}

} // namespace

Result<FrictionSweep> fitFrictionSweep(std::span<const SteadyPoint> points, std::uint64_t seed) {
    if (points.empty()) {
        return failure(ErrorCode::Refused, "no usable plateau", "use currents above the breakaway current");
    }
    auto problem = makeProblem(points);
    if (!problem) {
        return failure(problem.error());
    }
    const auto scatter = fitPoints(*problem);
    if (!scatter) {
        return failure(scatter.error());
    }
    const LinearFit& fit = scatter->fit;
    if (fit.freedom < 1) {
        return failure(ErrorCode::Refused, "too few plateaus to estimate the scatter",
                       "use at least three currents in one direction, or four in both");
    }
    if (!(fit.coefficients(0) > 0.0)) {
        return failure(ErrorCode::Refused, "the speed does not increase with the current",
                       "check the sign of the current and that the plateaus are steady");
    }
    FrictionSweep sweep;
    const Eigen::VectorXd values = quantities(fit.coefficients);
    sweep.damping_A_s = values(0);
    sweep.friction_A = values(1);
    const Eigen::MatrixXd jacobian = quantityJacobian(fit.coefficients);
    sweep.covariance = jacobian * fit.covariance * jacobian.transpose();
    sweep.freedom = fit.freedom;
    sweep.rSquared = rSquared(fit, problem->speed, scatter->weights);
    sweep.residuals_rad_s.assign(fit.residuals.begin(), fit.residuals.end());
    sweep.residualRms_rad_s = std::sqrt(fit.residuals.squaredNorm() / fit.freedom);
    addDirections(sweep, *problem, fit);
    addAdequacy(sweep, points, static_cast<int>(fit.coefficients.size()));
    if (const auto added = addSecondOpinions(sweep, *problem, *scatter, seed); !added) {
        return failure(added.error());
    }
    return sweep;
}

} // namespace halbench::control
