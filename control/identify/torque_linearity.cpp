#include "control/identify/torque_linearity.h"

#include "control/base/distributions.h"
#include "control/identify/adequacy.h"
#include "control/identify/scatter_fit.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

constexpr double Significant = 1.0 / 300.0;
// Knees next to each other, and their share of one direction, are nearly one test.
constexpr double IndependentTests = 12.0;
constexpr double SameCurrent_A = 1e-3;
constexpr int FewestFreedom = 3;

struct Candidate {
    TorqueDeparture departure = TorqueDeparture::Unnamed;
    DepartureDirection direction = DepartureDirection::Both;
    double knee_A = 0.0;
};

bool hasDirection(DepartureDirection wanted, int direction) {
    return wanted == DepartureDirection::Both || (wanted == DepartureDirection::Forward) == (direction > 0);
}

// Amounts of the currents, each once.
std::vector<double> levelsOf(const MotionFit& motion) {
    std::vector<double> levels_A;
    for (const SegmentBalance& balance : motion.balances) {
        levels_A.push_back(std::fabs(balance.current_A));
    }
    std::sort(levels_A.begin(), levels_A.end());
    const auto end = std::unique(levels_A.begin(), levels_A.end(),
                                 [](double a, double b) { return b - a <= SameCurrent_A; });
    levels_A.erase(end, levels_A.end());
    return levels_A;
}

std::vector<Candidate> candidatesOf(const MotionFit& motion) {
    using enum TorqueDeparture;
    using enum DepartureDirection;
    std::vector<Candidate> all = {{GainByDirection}, {GainDrift}, {FrictionDrift}, {FrictionByLoad}};
    const std::vector<double> levels_A = levelsOf(motion);
    for (const DepartureDirection direction : {Both, Forward, Reverse}) {
        all.push_back({Offset, direction});
        for (std::size_t i = 1; i + 1 < levels_A.size(); ++i) {
            if (levels_A[i] > SameCurrent_A) {
                all.push_back({Saturation, direction, levels_A[i]});
            }
        }
    }
    return all;
}

Eigen::VectorXd columnOf(const Candidate& candidate, const MotionFit& motion) {
    const std::size_t count = motion.balances.size();
    Eigen::VectorXd column = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(count));
    for (std::size_t i = 0; i < count; ++i) {
        const SegmentBalance& balance = motion.balances[i];
        if (!hasDirection(candidate.direction, balance.direction)) {
            continue;
        }
        const double amount_A = std::fabs(balance.current_A);
        const double driven = amount_A > SameCurrent_A ? std::copysign(1.0, balance.current_A) : 0.0;
        const double time =
            count > 1 ? 2.0 * static_cast<double>(i) / static_cast<double>(count - 1) - 1.0 : 0.0;
        double value = 0.0;
        switch (candidate.departure) {
        case TorqueDeparture::Saturation:
            value = -driven * std::max(amount_A - candidate.knee_A, 0.0);
            break;
        case TorqueDeparture::Offset:
            value = -driven;
            break;
        case TorqueDeparture::GainByDirection:
            value = balance.direction * balance.current_A;
            break;
        case TorqueDeparture::GainDrift:
            value = time * balance.current_A;
            break;
        case TorqueDeparture::FrictionDrift:
            value = -time;
            break;
        case TorqueDeparture::FrictionByLoad:
            value = -amount_A;
            break;
        case TorqueDeparture::Unnamed:
            break;
        }
        column(static_cast<Eigen::Index>(i)) = value;
    }
    return column;
}

Eigen::VectorXd measuringVariance(const MotionFit& motion) {
    Eigen::VectorXd variance(static_cast<Eigen::Index>(motion.balances.size()));
    for (Eigen::Index i = 0; i < variance.size(); ++i) {
        const double error_rad_s2 = motion.balances[static_cast<std::size_t>(i)].error_rad_s2;
        variance(i) = error_rad_s2 * error_rad_s2;
    }
    return variance;
}

// Friction and torque of the line with the departure in it; its columns are s I, then one per direction.
Eigen::Vector3d changeOf(const ScatterFit& extended, const BalanceFit& fit) {
    const Eigen::VectorXd& values = extended.fit.coefficients;
    const Eigen::Index directions = values.size() - 2;
    return {0.0, values.segment(1, directions).mean() - *fit.friction_rad_s2,
            values(0) - *fit.torque_rad_s2_A};
}

// The variance of the change is what the further unknown adds to that of the line.
Eigen::Vector3d allowedOf(const Eigen::Vector3d& change, const ScatterFit& extended, const BalanceFit& fit) {
    const Eigen::MatrixXd& covariance = extended.fit.covariance;
    const Eigen::Index directions = extended.fit.coefficients.size() - 2;
    const auto count = static_cast<double>(directions);
    const Eigen::Vector3d variance(
        0.0, covariance.block(1, 1, directions, directions).sum() / (count * count), covariance(0, 0));
    Eigen::Vector3d allowed = change;
    for (const Eigen::Index i : {1, 2}) {
        const double added = std::sqrt(std::max(variance(i) - fit.scatterCovariance(i, i), 0.0));
        allowed(i) += std::copysign(added, change(i));
    }
    return allowed;
}

std::optional<TorqueLinearity> tryOne(const Candidate& candidate, const MotionFit& motion,
                                      const BalanceFit& fit, const Eigen::VectorXd& variance) {
    const Eigen::Index columns = fit.design.cols();
    Eigen::MatrixXd design(fit.design.rows(), columns + 1);
    design << fit.design, columnOf(candidate, motion);
    const auto extended = fitWithScatter(design, fit.observed, variance);
    if (!extended || extended->fit.freedom < FewestFreedom) {
        return std::nullopt;
    }
    const double value = extended->fit.coefficients(columns);
    const double error = std::sqrt(extended->fit.covariance(columns, columns));
    if (!(error > 0.0) || !std::isfinite(value)) {
        return std::nullopt;
    }
    // More torque above a knee is less current below it: an offset says that better.
    const bool isLoss =
        candidate.departure == TorqueDeparture::Saturation || candidate.departure == TorqueDeparture::Offset;
    if (isLoss && value < 0.0) {
        return std::nullopt;
    }
    TorqueLinearity tested;
    tested.departure = candidate.departure;
    tested.direction = candidate.direction;
    tested.knee_A = candidate.knee_A;
    tested.probability =
        std::min(1.0, IndependentTests * studentTwoSided(value / error, extended->fit.freedom));
    tested.change = changeOf(*extended, fit);
    const bool isFriction = candidate.departure == TorqueDeparture::FrictionDrift;
    const double scale = isFriction ? *fit.friction_rad_s2 : extended->fit.coefficients(0);
    tested.value_ratio = scale > 0.0 ? value / scale : 0.0;
    if (candidate.departure == TorqueDeparture::GainByDirection) {
        tested.change(2) = value; // each direction lies that far from the mean of both
    }
    tested.allowed = allowedOf(tested.change, *extended, fit);
    return tested;
}

// Balances of one current and direction against the line, each in units of its own error.
double lackOfFitProbability(const MotionFit& motion, const BalanceFit& fit) {
    std::vector<double> levels;
    std::vector<double> residuals;
    for (std::size_t i = 0; i < motion.balances.size(); ++i) {
        const SegmentBalance& balance = motion.balances[i];
        constexpr double BeyondCurrents_A = 1e4; // tells the two directions apart
        levels.push_back(std::round(balance.current_A / SameCurrent_A) * SameCurrent_A +
                         balance.direction * BeyondCurrents_A);
        const auto row = static_cast<Eigen::Index>(i);
        residuals.push_back(fit.residuals(row) * std::sqrt(fit.weights(row)));
    }
    const auto test = testLackOfFit(levels, residuals, static_cast<int>(fit.design.cols()));
    return test ? test->probability : 1.0;
}

double largestTorque_rad_s2(const MotionFit& motion) {
    double largest_rad_s2 = 0.0;
    for (const SegmentBalance& balance : motion.balances) {
        largest_rad_s2 = std::max(largest_rad_s2, std::fabs(balance.balance_rad_s2));
    }
    return largest_rad_s2;
}

// Of the largest torque: where friction does not scatter, currents that are known to 0.15 % would already be
// seen to differ from the line.
constexpr double Visible_ratio = 0.01;

// Constants further off than their own intervals reach, or 2 %; less than 0.3 % is what a motor without
// imperfections is good to (resources/help/htm-theory.md section 7.2).
bool areConstantsMoved(const TorqueLinearity& tested, const MotionFit& motion, const BalanceFit& fit) {
    constexpr double Notable_ratio = 0.02;
    constexpr double Small_ratio = 0.003;
    const Eigen::Vector3d values(0.0, *fit.friction_rad_s2, *fit.torque_rad_s2_A);
    const Eigen::Vector3d small(0.0, Small_ratio * largestTorque_rad_s2(motion),
                                Small_ratio * std::fabs(values(2)));
    for (const Eigen::Index i : {1, 2}) {
        const double interval = 2.0 * std::sqrt(fit.scatterCovariance(i, i) + fit.dampingCovariance(i, i));
        const double moved = std::fabs(tested.change(i));
        if (moved > std::max(std::min(interval, Notable_ratio * std::fabs(values(i))), small(i))) {
            return true;
        }
    }
    return false;
}

} // namespace

std::optional<TorqueLinearity> testTorqueLinearity(const MotionFit& motion, const BalanceFit& fit) {
    if (!fit.torque_rad_s2_A || !fit.friction_rad_s2 || fit.freedom < FewestFreedom) {
        return std::nullopt;
    }
    const Eigen::VectorXd variance = measuringVariance(motion);
    std::optional<TorqueLinearity> best;
    for (const Candidate& candidate : candidatesOf(motion)) {
        const auto tested = tryOne(candidate, motion, fit, variance);
        if (tested && (!best || tested->probability < best->probability)) {
            best = tested;
        }
    }
    if (!best) {
        return std::nullopt;
    }
    best->isSignificant = best->probability < Significant;
    best->isNotable = best->isSignificant && areConstantsMoved(*best, motion, fit);
    if (!best->isSignificant) {
        const double probability = lackOfFitProbability(motion, fit);
        if (probability < Significant) {
            best->departure = TorqueDeparture::Unnamed;
            best->probability = probability;
            best->isSignificant = true;
            best->isNotable = fit.scatter_rad_s2 > Visible_ratio * largestTorque_rad_s2(motion);
        }
    }
    return best;
}

} // namespace halbench::control
