#include "control/identify/resampling.h"

#include "control/base/assert.h"
#include "control/base/random.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace halbench::control {
namespace {

// The resample as multiplicities of the rows: the fit is the same with weights times multiplicity. Normal
// equations of scaled columns are enough for 2000 small fits whose parent passed the QR.
std::optional<Eigen::VectorXd> solveQuickly(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed,
                                            const Eigen::VectorXd& weights) {
    const Eigen::MatrixXd normal = design.transpose() * weights.asDiagonal() * design;
    const Eigen::LDLT<Eigen::MatrixXd> factor(normal);
    constexpr double RankTolerance = 1e-12;
    const Eigen::VectorXd pivots = factor.vectorD();
    if (pivots.minCoeff() <= RankTolerance * pivots.maxCoeff()) {
        return std::nullopt;
    }
    return factor.solve(design.transpose() * weights.cwiseProduct(observed));
}

double percentile(std::vector<double>& sorted, double probability) {
    const double place = probability * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

} // namespace

Result<BootstrapResult> bootstrapPairs(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed,
                                       const Eigen::VectorXd& weights, const FitQuantity& quantity,
                                       std::uint64_t seed, int resamples) {
    HB_ASSERT(resamples > 0 && design.rows() > 0);
    const Eigen::VectorXd scales = design.colwise().norm().transpose().array() + 1e-300;
    const Eigen::MatrixXd scaled = design * scales.cwiseInverse().asDiagonal();
    Random random(seed);
    const auto rows = static_cast<std::uint64_t>(design.rows());
    std::vector<std::vector<double>> drawn;
    BootstrapResult result;
    for (int i = 0; i < resamples; ++i) {
        Eigen::VectorXd count = Eigen::VectorXd::Zero(design.rows());
        for (std::uint64_t row = 0; row < rows; ++row) {
            count(static_cast<Eigen::Index>(random.below(rows))) += 1.0;
        }
        const auto solution = solveQuickly(scaled, observed, weights.cwiseProduct(count));
        if (!solution) {
            ++result.refused;
            continue;
        }
        const Eigen::VectorXd value = quantity(solution->cwiseQuotient(scales));
        drawn.resize(static_cast<std::size_t>(value.size()));
        for (std::size_t k = 0; k < drawn.size(); ++k) {
            drawn[k].push_back(value(static_cast<Eigen::Index>(k)));
        }
        ++result.draws;
    }
    if (result.refused * 10 > resamples) {
        return failure(ErrorCode::Refused, "the fit depends on single points", "measure more points");
    }
    for (std::size_t k = 0; k < drawn.size(); ++k) {
        std::sort(drawn[k].begin(), drawn[k].end());
        result.interval95.emplace_back(percentile(drawn[k], 0.025), percentile(drawn[k], 0.975));
    }
    return result;
}

Eigen::MatrixXd leaveOneOut(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed,
                            const Eigen::VectorXd& weights, const FitQuantity& quantity,
                            const Eigen::VectorXd& standardError) {
    Eigen::MatrixXd influence = Eigen::MatrixXd::Zero(design.rows(), standardError.size());
    const auto all = fitLinear(design, observed, weights);
    HB_ASSERT(all.has_value());
    const Eigen::VectorXd centre = quantity(all->coefficients);
    for (Eigen::Index row = 0; row < design.rows(); ++row) {
        if (weights(row) == 0.0) {
            continue;
        }
        Eigen::VectorXd without = weights;
        without(row) = 0.0;
        const auto fit = fitLinear(design, observed, without);
        if (!fit) {
            influence.row(row).setConstant(std::numeric_limits<double>::infinity());
            continue;
        }
        const Eigen::VectorXd change = quantity(fit->coefficients) - centre;
        for (Eigen::Index k = 0; k < standardError.size(); ++k) {
            influence(row, k) = standardError(k) > 0.0 ? change(k) / standardError(k) : 0.0;
        }
    }
    return influence;
}

} // namespace halbench::control
