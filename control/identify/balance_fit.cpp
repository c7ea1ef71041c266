#include "control/identify/motion_fit.h"
#include "control/identify/scatter_fit.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

// Which columns the currents and directions allow.
struct Layout {
    int torque = -1;
    int forward = -1;
    int reverse = -1;
    int count = 0;
};

Result<Layout> layoutOf(const std::vector<SegmentBalance>& balances) {
    const auto [low, high] =
        std::minmax_element(balances.begin(), balances.end(),
                            [](const auto& a, const auto& b) { return a.current_A < b.current_A; });
    constexpr double SameCurrent_A = 1e-3;
    const bool hasTwoCurrents = high->current_A - low->current_A > SameCurrent_A;
    if (!hasTwoCurrents && std::fabs(high->current_A) > SameCurrent_A) {
        return failure(ErrorCode::Refused,
                       "all usable motion is at one current (coast-downs missing or too short): torque and "
                       "friction cannot be separated",
                       "use a higher speed before the coast-down, or add a second current");
    }
    Layout layout;
    layout.torque = hasTwoCurrents ? layout.count++ : -1;
    const auto has = [&](int direction) {
        return std::any_of(balances.begin(), balances.end(),
                           [direction](const auto& balance) { return balance.direction == direction; });
    };
    layout.forward = has(1) ? layout.count++ : -1;
    layout.reverse = has(-1) ? layout.count++ : -1;
    return layout;
}

// Rows: (a, f, k) as functions of the coefficients of the line.
Eigen::MatrixXd quantityMap(const Layout& layout) {
    Eigen::MatrixXd map = Eigen::MatrixXd::Zero(3, layout.count);
    const double share = layout.forward >= 0 && layout.reverse >= 0 ? 0.5 : 1.0;
    for (const int column : {layout.forward, layout.reverse}) {
        if (column >= 0) {
            map(1, column) = share;
        }
    }
    if (layout.torque >= 0) {
        map(2, layout.torque) = 1.0;
    }
    return map;
}

// Without a stretch to spare the line goes through every balance, and the wrong friction that it then shows
// is no measure of the scatter either: the largest balance bounds it as well.
double assumedScatter_rad_s2(const std::vector<SegmentBalance>& balances, const LinearFit& line,
                             const Layout& layout) {
    constexpr double Scatter_ratio = 0.033; // resources/help/htm-theory.md section 9
    double largest_rad_s2 = 0.0;
    for (const SegmentBalance& balance : balances) {
        largest_rad_s2 = std::max(largest_rad_s2, std::fabs(balance.balance_rad_s2));
    }
    for (const int column : {layout.forward, layout.reverse}) {
        if (column >= 0) {
            largest_rad_s2 = std::max(largest_rad_s2, std::fabs(line.coefficients(column)));
        }
    }
    return Scatter_ratio * largest_rad_s2;
}

void addDirections(BalanceFit& balance, const Layout& layout, const LinearFit& line) {
    if (layout.forward >= 0) {
        balance.frictionForward_rad_s2 = line.coefficients(layout.forward);
    }
    if (layout.reverse >= 0) {
        balance.frictionReverse_rad_s2 = line.coefficients(layout.reverse);
    }
    if (layout.forward < 0 || layout.reverse < 0) {
        return;
    }
    const double plus = *balance.frictionForward_rad_s2;
    const double minus = *balance.frictionReverse_rad_s2;
    const double sum = plus + minus;
    if (!(sum > 0.0)) {
        return;
    }
    balance.asymmetry = (plus - minus) / sum;
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(layout.count);
    gradient(layout.forward) = 2.0 * minus / (sum * sum);
    gradient(layout.reverse) = -2.0 * plus / (sum * sum);
    balance.asymmetryError = std::sqrt(gradient.dot(line.covariance * gradient));
}

} // namespace

Result<BalanceFit> fitBalance(const MotionFit& motion) {
    const auto layout = layoutOf(motion.balances);
    if (!layout) {
        return failure(layout.error());
    }
    const auto rows = static_cast<Eigen::Index>(motion.balances.size());
    BalanceFit balance;
    balance.design = Eigen::MatrixXd::Zero(rows, layout->count);
    balance.observed.resize(rows);
    Eigen::VectorXd variance(rows);
    Eigen::VectorXd slopes(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const SegmentBalance& segment = motion.balances[static_cast<std::size_t>(i)];
        if (layout->torque >= 0) {
            balance.design(i, layout->torque) = segment.current_A;
        }
        balance.design(i, segment.direction > 0 ? layout->forward : layout->reverse) = -1.0;
        balance.observed(i) = segment.balance_rad_s2;
        variance(i) = segment.error_rad_s2 * segment.error_rad_s2;
        slopes(i) = segment.slope_rad_s;
    }
    auto scatter = fitWithScatter(balance.design, balance.observed, variance);
    if (!scatter) {
        return failure(scatter.error());
    }
    if (scatter->fit.freedom == 0) {
        balance.isScatterAssumed = true;
        const double assumed = assumedScatter_rad_s2(motion.balances, scatter->fit, *layout);
        variance.array() += assumed * assumed;
        scatter = fitWithScatter(balance.design, balance.observed, variance);
        if (!scatter) {
            return failure(scatter.error());
        }
        scatter->commonVariance = assumed * assumed;
        scatter->fit.covariance = scatter->fit.unscaled;
    }
    const LinearFit& line = scatter->fit;
    balance.weights = scatter->weights;
    balance.residuals = line.residuals;
    balance.freedom = line.freedom;
    balance.scatter_rad_s2 = std::sqrt(scatter->commonVariance);
    const Eigen::MatrixXd map = quantityMap(*layout);
    const Eigen::VectorXd values = map * line.coefficients;
    balance.friction_rad_s2 = values(1);
    if (layout->torque >= 0) {
        balance.torque_rad_s2_A = values(2);
    }
    balance.scatterCovariance = map * line.covariance * map.transpose();
    // How the line moves when a moves: the same projection applied to the slopes.
    const Eigen::VectorXd shift =
        line.unscaled * (balance.design.transpose() * balance.weights.cwiseProduct(slopes));
    Eigen::Vector3d byDamping = map * shift;
    byDamping(0) = 1.0;
    balance.dampingCovariance =
        motion.dampingError_per_s * motion.dampingError_per_s * byDamping * byDamping.transpose();
    for (const SharedError& error : motion.sharedErrors) {
        const Eigen::Map<const Eigen::VectorXd> moved(error.balances_rad_s2.data(), rows);
        const Eigen::VectorXd along =
            line.unscaled * (balance.design.transpose() * balance.weights.cwiseProduct(moved));
        Eigen::Vector3d shared = map * along;
        shared(0) = error.damping_per_s;
        balance.dampingCovariance += shared * shared.transpose();
    }
    addDirections(balance, *layout, line);
    return balance;
}

} // namespace halbench::control
