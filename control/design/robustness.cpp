#include "control/design/robustness.h"

#include "control/base/assert.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

namespace halbench::control {

namespace {

/// Matrix M with M M^T = covariance, through the eigenvalues of the correlation (units differ by decades).
Result<Eigen::MatrixXd> factor(const Eigen::MatrixXd& covariance) {
    if (covariance.size() == 0) {
        return covariance; // a motor known exactly
    }
    const Eigen::VectorXd deviation = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    const Eigen::VectorXd inverse = deviation.unaryExpr([](double s) { return s > 0.0 ? 1.0 / s : 0.0; });
    const Eigen::MatrixXd correlation = inverse.asDiagonal() * covariance * inverse.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(correlation);
    constexpr double Rounding = 1e-6; // a covariance that went through a text file
    const bool isSymmetric = (correlation - correlation.transpose()).cwiseAbs().maxCoeff() < Rounding;
    const Eigen::MatrixXd rest = covariance - deviation.asDiagonal() * correlation * deviation.asDiagonal();
    const bool isBounded = (rest.array().abs() <= Rounding * covariance.cwiseAbs().maxCoeff()).all();
    if (covariance.diagonal().minCoeff() < 0.0 || !isSymmetric || !isBounded ||
        solver.eigenvalues().minCoeff() < -Rounding) {
        return failure(ErrorCode::InvalidInput, "the covariance of the model is not a covariance",
                       "it must be symmetric and positive semi-definite: identify the motor again");
    }
    const Eigen::VectorXd scale = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    return Eigen::MatrixXd(deviation.asDiagonal() * solver.eigenvectors() * scale.asDiagonal());
}

Result<void> check(const UncertainPlant& plant, int draws) {
    constexpr int LeastDraws = 1000;
    constexpr int MostDraws = 1000000;
    if (draws < LeastDraws || draws > MostDraws) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("{} draws are not between {} and {}", draws, LeastDraws, MostDraws));
    }
    if (plant.covariance.rows() != plant.mean.size() || plant.covariance.cols() != plant.mean.size()) {
        return failure(ErrorCode::InvalidInput, "the covariance does not have the size of the parameters");
    }
    if (!plant.mean.allFinite() || !plant.covariance.allFinite()) {
        return failure(ErrorCode::NotFinite, "the model or its covariance holds a value that is not finite");
    }
    return {};
}

struct Draw {
    bool isStable = false;
    double gainMargin_ratio = 0.0;
    double phaseMargin_deg = 0.0;
};

/// Damping below zero is taken as none: a draw beyond the edge of what a motor can be, not a negative brake.
Draw judge(PositionPlant plant, const PidGains& gains, const LoopTiming& timing) {
    plant.dampingRate_1_s = std::max(plant.dampingRate_1_s, 0.0);
    plant.breakawayCurrent_A = std::max(plant.breakawayCurrent_A, 0.0);
    const auto loop = sampledOpenLoop(plant, gains, timing);
    if (!loop) {
        return {};
    }
    const StabilityMargins margins = smallestMargins(*loop);
    if (poleRadius(*loop) < 1.0) {
        return {true, margins.gainMargin_ratio, margins.phaseMargin_deg};
    }
    return {false, std::min(margins.gainMargin_ratio, 1.0), std::min(margins.phaseMargin_deg, 0.0)};
}

/// Nearest rank: the value that 5 % of the draws do not exceed.
double fifthPercentile(std::vector<double> values) {
    const auto rank = static_cast<std::size_t>(std::ceil(0.05 * static_cast<double>(values.size()))) - 1;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
    return values[rank];
}

} // namespace

Result<Robustness> assessRobustness(const UncertainPlant& plant, const PidGains& gains,
                                    const LoopTiming& timing, int draws, Random random) {
    HB_ASSERT(plant.toPlant != nullptr);
    if (const auto valid = check(plant, draws); !valid) {
        return failure(valid.error());
    }
    const auto root = factor(plant.covariance);
    if (!root) {
        return failure(root.error());
    }
    std::vector<double> gainMargins;
    std::vector<double> phaseMargins;
    int unstable = 0;
    Eigen::VectorXd normal(plant.mean.size());
    for (int i = 0; i < draws; ++i) {
        for (double& value : normal) {
            value = random.gaussian();
        }
        const Draw draw = judge(plant.toPlant(plant.mean + *root * normal), gains, timing);
        gainMargins.push_back(draw.gainMargin_ratio);
        phaseMargins.push_back(draw.phaseMargin_deg);
        unstable += draw.isStable ? 0 : 1;
    }
    return Robustness{draws, fifthPercentile(std::move(gainMargins)),
                      fifthPercentile(std::move(phaseMargins)),
                      static_cast<double>(unstable) / static_cast<double>(draws)};
}

} // namespace halbench::control
