#include "control/identify/scatter_fit.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

Eigen::VectorXd weightsFor(double common, const Eigen::VectorXd& measuring) {
    return (measuring.array() + common).inverse();
}

double weightedSum(const LinearFit& fit, const Eigen::VectorXd& weights) {
    return (weights.array() * fit.residuals.array().square()).sum();
}

// Bisection on the common variance: the weighted sum of squares falls as it grows.
Result<double> findCommon(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed,
                          const Eigen::VectorXd& measuring, double ordinaryVariance) {
    double low = 0.0;
    double high = 4.0 * ordinaryVariance + measuring.maxCoeff();
    for (int i = 0; i < 60 && high - low > 1e-9 * high; ++i) {
        const double middle = 0.5 * (low + high);
        const Eigen::VectorXd weights = weightsFor(middle, measuring);
        const auto fit = fitLinear(design, observed, weights);
        if (!fit) {
            return failure(fit.error());
        }
        (weightedSum(*fit, weights) > fit->freedom ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace

Result<ScatterFit> fitWithScatter(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed,
                                  const Eigen::VectorXd& measuringVariance) {
    const auto ordinary = fitLinear(design, observed);
    if (!ordinary) {
        return failure(ordinary.error());
    }
    ScatterFit result;
    // Exact data (no noise given): all weights alike.
    const double smallest = 1e-18 * (1.0 + observed.squaredNorm() / static_cast<double>(observed.size()));
    const Eigen::VectorXd measuring = measuringVariance.array() + smallest;
    if (ordinary->freedom > 0) {
        const auto common = findCommon(design, observed, measuring, ordinary->residualVariance);
        if (!common) {
            return failure(common.error());
        }
        result.commonVariance = *common;
    }
    result.weights = weightsFor(result.commonVariance, measuring);
    auto fit = fitLinear(design, observed, result.weights);
    if (!fit) {
        return failure(fit.error());
    }
    result.fit = std::move(*fit);
    return result;
}

} // namespace halbench::control
