#include "control/identify/motion_fit.h"

#include "control/base/assert.h"
#include "control/base/units.h"
#include "control/identify/motion_shape.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

constexpr int LocalColumns = 3;
constexpr int RippleColumns = 6;

// One segment for one value of the damping, local unknowns projected out.
struct Projected {
    Eigen::MatrixXd local;      // n x 3
    Eigen::MatrixXd global;     // n x q as is
    Eigen::MatrixXd globalRest; // without the part the local unknowns explain
    Eigen::VectorXd angle;
    Eigen::VectorXd angleRest;
    Eigen::HouseholderQR<Eigen::MatrixXd> qr;
};

Eigen::MatrixXd withoutLocal(const Eigen::HouseholderQR<Eigen::MatrixXd>& qr, const Eigen::MatrixXd& what) {
    Eigen::MatrixXd turned = qr.householderQ().transpose() * what;
    turned.topRows(LocalColumns).setZero();
    return qr.householderQ() * turned;
}

struct Columns {
    int orders = 0;
    bool ripple = false;
    int count() const { return 2 * orders + (ripple ? RippleColumns : 0); }
};

Projected project(const MotionSegment& segment, double damping, const Columns& columns) {
    Projected part;
    part.local = localShape(segment, damping);
    part.angle = Eigen::Map<const Eigen::VectorXd>(segment.angle_rad.data(),
                                                   static_cast<Eigen::Index>(segment.angle_rad.size()));
    part.qr.compute(part.local);
    part.angleRest = withoutLocal(part.qr, part.angle);
    part.global.resize(part.angle.size(), columns.count());
    if (columns.orders > 0) {
        part.global.leftCols(2 * columns.orders) = angleErrorShape(segment, columns.orders);
    }
    if (columns.ripple) {
        part.global.rightCols(RippleColumns) = rippleShape(segment, damping);
    }
    part.globalRest = withoutLocal(part.qr, part.global);
    return part;
}

// All segments for one value of the damping, all linear unknowns solved.
struct Solution {
    std::vector<Projected> parts;
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> globalQr;
    Eigen::VectorXd global;
    Eigen::VectorXd rest; // stacked residual
    std::vector<Eigen::Vector3d> local;
    double squares = 0.0;
};

Eigen::VectorXd withoutGlobal(const Solution& solution, const Eigen::VectorXd& stacked) {
    if (solution.global.size() == 0) {
        return stacked;
    }
    Eigen::VectorXd turned = solution.globalQr.householderQ().transpose() * stacked;
    turned.head(solution.globalQr.rank()).setZero();
    return solution.globalQr.householderQ() * turned;
}

Solution solve(std::span<const MotionSegment> segments, double damping, const Columns& columns) {
    Solution solution;
    Eigen::Index rows = 0;
    for (const MotionSegment& segment : segments) {
        solution.parts.push_back(project(segment, damping, columns));
        rows += solution.parts.back().angle.size();
    }
    Eigen::MatrixXd stacked(rows, columns.count());
    solution.rest.resize(rows);
    Eigen::Index row = 0;
    for (const Projected& part : solution.parts) {
        stacked.middleRows(row, part.angle.size()) = part.globalRest;
        solution.rest.segment(row, part.angle.size()) = part.angleRest;
        row += part.angle.size();
    }
    if (columns.count() > 0) {
        solution.globalQr.setThreshold(1e-8);
        solution.globalQr.compute(stacked);
        solution.global = solution.globalQr.solve(solution.rest);
        solution.rest -= stacked * solution.global;
    }
    for (const Projected& part : solution.parts) {
        const Eigen::VectorXd corrected =
            columns.count() > 0 ? Eigen::VectorXd(part.angle - part.global * solution.global) : part.angle;
        solution.local.emplace_back(part.qr.solve(corrected));
    }
    solution.squares = solution.rest.squaredNorm();
    return solution;
}

// Derivative of the model by the damping, all linear unknowns projected out.
Eigen::VectorXd dampingColumn(std::span<const MotionSegment> segments, const Solution& solution,
                              double damping) {
    Eigen::VectorXd stacked(solution.rest.size());
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const Eigen::VectorXd column = solution.local[i](2) * dampingShape(segments[i], damping);
        stacked.segment(row, column.size()) = withoutLocal(solution.parts[i].qr, column);
        row += column.size();
    }
    return withoutGlobal(solution, stacked);
}

// Coarse search over the damping with the local unknowns only.
double startDamping(std::span<const MotionSegment> segments) {
    double best = 1.0;
    double bestSquares = -1.0;
    for (double damping = 0.02; damping < 60.0; damping *= 1.25) {
        double squares = 0.0;
        for (const MotionSegment& segment : segments) {
            squares += project(segment, damping, {}).angleRest.squaredNorm();
        }
        if (bestSquares < 0.0 || squares < bestSquares) {
            bestSquares = squares;
            best = damping;
        }
    }
    return best;
}

double iterateDamping(std::span<const MotionSegment> segments, double damping, const Columns& columns) {
    constexpr int MostIterations = 40;
    for (int i = 0; i < MostIterations; ++i) {
        const Solution solution = solve(segments, damping, columns);
        const Eigen::VectorXd column = dampingColumn(segments, solution, damping);
        const double size = column.squaredNorm();
        if (!(size > 0.0)) {
            return damping;
        }
        const double limit = 0.3 * std::fabs(damping) + 0.05;
        const double step = std::clamp(column.dot(solution.rest) / size, -limit, limit);
        damping += step;
        if (std::fabs(step) <= 1e-12 * (1.0 + std::fabs(damping))) {
            break;
        }
    }
    return damping;
}

// Sandwich over segments, never below the independent-noise variance while there are few of them.
void dampingSpread(MotionFit& fit, const Solution& solution, const Eigen::VectorXd& column,
                   std::span<const MotionSegment> segments, int unknowns) {
    const double size = column.squaredNorm();
    const auto count = static_cast<double>(segments.size());
    const auto rows = static_cast<double>(column.size());
    double meat = 0.0;
    Eigen::Index row = 0;
    for (const Projected& part : solution.parts) {
        const Eigen::Index n = part.angle.size();
        const double score = column.segment(row, n).dot(solution.rest.segment(row, n));
        meat += score * score;
        row += n;
    }
    const double noise = solution.squares / std::max(rows - unknowns, 1.0) / size;
    constexpr double EnoughClusters = 10.0;
    if (count < EnoughClusters) {
        const double sandwich = count > 1.0 ? meat / (size * size) * count / (count - 1.0) : 0.0;
        fit.dampingError_per_s = std::sqrt(std::max(noise, sandwich));
        fit.dampingFreedom = std::max(static_cast<int>(rows) - unknowns, 1);
    } else {
        fit.dampingError_per_s = std::sqrt(meat / (size * size) * count / (count - 1.0));
        fit.dampingFreedom = static_cast<int>(count) - 1;
    }
}

double balanceOf(const Eigen::Vector3d& local, int direction, double damping) {
    return direction * (local(2) + damping * local(1));
}

void addBalances(MotionFit& fit, std::span<const MotionSegment> segments, const Columns& columns,
                 const Solution& solution) {
    const double a = fit.damping_per_s;
    const double step = 1e-5 * (std::fabs(a) + 0.1);
    const Solution above = solve(segments, a + step, columns);
    const Solution below = solve(segments, a - step, columns);
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const Projected& part = solution.parts[i];
        const Eigen::Index n = part.angle.size();
        const int s = segments[i].direction;
        SegmentBalance balance;
        balance.direction = s;
        balance.current_A = s * segments[i].current_A;
        balance.balance_rad_s2 = balanceOf(solution.local[i], s, a);
        balance.slope_rad_s =
            (balanceOf(above.local[i], s, a + step) - balanceOf(below.local[i], s, a - step)) / (2.0 * step);
        const Eigen::VectorXd rest = solution.rest.segment(row, n);
        balance.residualRms_rad = std::sqrt(rest.squaredNorm() / static_cast<double>(n));
        const Eigen::Vector3d gradient(0.0, a, 1.0);
        const Eigen::Matrix3d normal = part.local.transpose() * part.local;
        balance.error_rad_s2 = fit.residualRms_rad * std::sqrt(gradient.dot(normal.ldlt().solve(gradient)));
        fit.balances.push_back(balance);
        row += n;
    }
}

Columns affordableColumns(std::span<const MotionSegment> segments, const MotionFitConfig& config) {
    double travel = 0.0;
    std::size_t rows = 0;
    for (const MotionSegment& segment : segments) {
        travel += std::fabs(segment.angle_rad.back() - segment.angle_rad.front());
        rows += segment.angle_rad.size();
    }
    // An angle error can be told from motion only when every angle was passed at many different times.
    constexpr double EnoughTurns = 20.0;
    constexpr std::size_t EnoughRows = 600;
    Columns columns;
    if (travel > EnoughTurns * 2.0 * Pi && rows > EnoughRows) {
        columns.orders = config.angleOrders;
        columns.ripple = config.fitsRipple;
    }
    return columns;
}

Result<void> checkSegments(std::span<const MotionSegment> segments) {
    if (segments.empty()) {
        return failure(ErrorCode::Refused, "the recording holds no stretch of motion under constant current",
                       "hold each current for a second or more, well above the breakaway current");
    }
    for (const MotionSegment& segment : segments) {
        HB_ASSERT(segment.time_s.size() == segment.angle_rad.size());
        HB_ASSERT(segment.direction == 1 || segment.direction == -1);
        if (segment.time_s.size() <= LocalColumns) {
            return failure(ErrorCode::Refused, "a stretch of motion has too few samples", "record faster");
        }
        for (const double angle : segment.angle_rad) {
            if (!std::isfinite(angle)) {
                return failure(ErrorCode::NotFinite, "an angle of the recording is not a number",
                               "cut the damaged rows out");
            }
        }
    }
    return {};
}

Result<MotionFit> fitOnce(std::span<const MotionSegment> segments, double start_per_s,
                          const Columns& columns) {
    MotionFit fit;
    fit.damping_per_s = iterateDamping(segments, start_per_s, columns);
    if (!std::isfinite(fit.damping_per_s)) {
        return failure(ErrorCode::Refused, "the damping of the motion cannot be decided",
                       "record run-ups and coast-downs over a wider range of speed");
    }
    const Solution solution = solve(segments, fit.damping_per_s, columns);
    const Eigen::VectorXd column = dampingColumn(segments, solution, fit.damping_per_s);
    const auto rows = static_cast<double>(solution.rest.size());
    const int unknowns = LocalColumns * static_cast<int>(segments.size()) + columns.count() + 1;
    if (!(column.squaredNorm() > 0.0) || rows <= unknowns) {
        return failure(ErrorCode::Refused, "the segments do not bend: the damping is undecided",
                       "record run-ups and coast-downs, not only steady motion");
    }
    fit.angleOrders = columns.orders;
    const auto angleErrors = solution.global.head(2 * columns.orders);
    fit.angleError_rad.assign(angleErrors.begin(), angleErrors.end());
    fit.residualRms_rad = std::sqrt(solution.squares / (rows - unknowns));
    dampingSpread(fit, solution, column, segments, unknowns);
    addBalances(fit, segments, columns, solution);
    return fit;
}

// How well the loss of torque at speed is known, 1 sigma: it goes with the square of the lag, of which the
// amplifier's share, 0.3 of 0.8 ms, is known to 5 % from the tolerances of its parts.
constexpr double LossError_ratio = 0.04;

// The segments as they would be without the loss of torque at speed, to first order of the loss.
std::vector<MotionSegment> withoutTorqueLoss(std::span<const MotionSegment> segments, const MotionFit& fit,
                                             const Columns& columns, double loss_s2) {
    const auto balance = fitBalance(fit);
    const double torque = balance ? balance->torque_rad_s2_A.value_or(0.0) : 0.0;
    const Solution solution = solve(segments, fit.damping_per_s, columns);
    std::vector<MotionSegment> corrected(segments.begin(), segments.end());
    for (std::size_t i = 0; i < corrected.size(); ++i) {
        const Eigen::VectorXd response =
            lossShape(segments[i], fit.damping_per_s, solution.local[i](1), solution.local[i](2));
        for (std::size_t row = 0; row < corrected[i].angle_rad.size(); ++row) {
            corrected[i].angle_rad[row] +=
                loss_s2 * torque * segments[i].current_A * response(static_cast<Eigen::Index>(row));
        }
    }
    return corrected;
}

} // namespace

Result<MotionFit> fitMotion(std::span<const MotionSegment> segments, const MotionFitConfig& config) {
    if (const auto checked = checkSegments(segments); !checked) {
        return failure(checked.error());
    }
    const Columns columns = affordableColumns(segments, config);
    auto fit = fitOnce(segments, startDamping(segments), columns);
    if (!fit || config.torqueLoss_s2 == 0.0) {
        return fit;
    }
    const auto corrected = withoutTorqueLoss(segments, *fit, columns, config.torqueLoss_s2);
    auto final = fitOnce(corrected, fit->damping_per_s, columns);
    if (final) {
        const double shift = final->damping_per_s - fit->damping_per_s;
        final->dampingError_per_s = std::hypot(final->dampingError_per_s, LossError_ratio * shift);
    }
    return final;
}

std::vector<double> correctedAngle_rad(const MotionFit& fit, std::span<const double> angle_rad) {
    std::vector<double> corrected(angle_rad.begin(), angle_rad.end());
    for (double& angle : corrected) {
        const double measured = angle;
        for (int order = 1; order <= fit.angleOrders; ++order) {
            const std::size_t place = 2 * (static_cast<std::size_t>(order) - 1);
            angle -= fit.angleError_rad[place] * std::cos(order * measured) +
                     fit.angleError_rad[place + 1] * std::sin(order * measured);
        }
    }
    return corrected;
}

} // namespace halbench::control
