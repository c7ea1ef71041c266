#include "control/identify/robust_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace halbench::control {
namespace {

constexpr double HuberTuning = 1.345;
constexpr double BisquareTuning = 4.685;
constexpr double NormalMedian = 0.6744897501960817; // median of |N(0,1)|
constexpr int MostIterations = 100;

double robustnessWeight(RobustLoss loss, double u) {
    const double size = std::fabs(u);
    if (loss == RobustLoss::Huber) {
        return size <= HuberTuning ? 1.0 : HuberTuning / size;
    }
    const double ratio = size / BisquareTuning;
    return ratio >= 1.0 ? 0.0 : (1.0 - ratio * ratio) * (1.0 - ratio * ratio);
}

// Residuals in units of an observation of weight 1, all with the same expected size.
Eigen::VectorXd standardised(const LinearFit& fit, const LinearFit& ordinary,
                             const Eigen::VectorXd& weights) {
    Eigen::VectorXd result(fit.residuals.size());
    for (Eigen::Index i = 0; i < result.size(); ++i) {
        const double spread = std::sqrt(std::max(1.0 - ordinary.leverage(i), 1e-3));
        result(i) = fit.residuals(i) * std::sqrt(weights(i)) / spread;
    }
    return result;
}

double medianScale(const Eigen::VectorXd& residuals, const Eigen::VectorXd& weights) {
    std::vector<double> sizes;
    for (Eigen::Index i = 0; i < residuals.size(); ++i) {
        if (weights(i) > 0.0) {
            sizes.push_back(std::fabs(residuals(i)));
        }
    }
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return *middle / NormalMedian;
}

// Huber's covariance: s^2 = sum (psi^2)/(n - p) / (mean psi')^2 instead of the weighted residual variance.
double huberVariance(const RobustFit& robust, const Eigen::VectorXd& standard, RobustLoss loss) {
    double squares = 0.0;
    double slopes = 0.0;
    int count = 0;
    constexpr double Step = 1e-4;
    for (Eigen::Index i = 0; i < standard.size(); ++i) {
        if (robust.ordinary.leverage(i) <= 0.0) {
            continue;
        }
        const double u = standard(i) / robust.scale;
        const double psi = u * robustnessWeight(loss, u);
        squares += psi * psi;
        slopes +=
            ((u + Step) * robustnessWeight(loss, u + Step) - (u - Step) * robustnessWeight(loss, u - Step)) /
            (2.0 * Step);
        ++count;
    }
    const double mean = std::max(slopes / count, 0.1);
    const int freedom = std::max(robust.ordinary.freedom, 1);
    return robust.scale * robust.scale * squares / freedom / (mean * mean);
}

Result<void> iterate(RobustFit& robust, const Eigen::MatrixXd& design, const Eigen::VectorXd& observed,
                     const Eigen::VectorXd& weights, RobustLoss loss) {
    for (int i = 0; i < MostIterations; ++i) {
        const Eigen::VectorXd standard = standardised(robust.fit, robust.ordinary, weights);
        robust.scale = medianScale(standard, weights);
        if (!(robust.scale > 1e-12 * (1.0 + observed.cwiseAbs().maxCoeff()))) {
            return {}; // exact data: nothing to weigh down
        }
        for (Eigen::Index row = 0; row < observed.size(); ++row) {
            robust.weights(row) = robustnessWeight(loss, standard(row) / robust.scale);
        }
        auto next = fitLinear(design, observed, weights.cwiseProduct(robust.weights));
        if (!next) {
            return failure(next.error());
        }
        const Eigen::VectorXd sigma = robust.ordinary.covariance.diagonal().cwiseSqrt();
        const double change =
            ((next->coefficients - robust.fit.coefficients).array().abs() / (sigma.array() + 1e-300))
                .maxCoeff();
        robust.fit = std::move(*next);
        if (change < 1e-6) {
            break;
        }
    }
    const Eigen::VectorXd standard = standardised(robust.fit, robust.ordinary, weights);
    robust.fit.residualVariance = huberVariance(robust, standard, loss);
    robust.fit.covariance = robust.fit.residualVariance * robust.ordinary.unscaled;
    return {};
}

} // namespace

Result<RobustFit> fitRobust(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed,
                            const Eigen::VectorXd& weights, RobustLoss loss) {
    auto ordinary = fitLinear(design, observed, weights);
    if (!ordinary) {
        return failure(ordinary.error());
    }
    RobustFit robust;
    robust.ordinary = *ordinary;
    robust.fit = std::move(*ordinary);
    robust.weights = Eigen::VectorXd::Ones(observed.size());
    if (robust.ordinary.freedom == 0) {
        return robust;
    }
    if (const auto done = iterate(robust, design, observed, weights, RobustLoss::Huber); !done) {
        return failure(done.error());
    }
    if (loss == RobustLoss::Bisquare) {
        if (const auto done = iterate(robust, design, observed, weights, loss); !done) {
            return failure(done.error());
        }
    }
    const Eigen::ArrayXd sigma = robust.ordinary.covariance.diagonal().array().sqrt();
    const Eigen::ArrayXd move = (robust.fit.coefficients - robust.ordinary.coefficients).array().abs();
    const Eigen::ArrayXd rounding = 1e-9 * robust.ordinary.coefficients.array().abs();
    robust.differsFromOrdinary = (move > sigma + rounding).any();
    return robust;
}

} // namespace halbench::control
