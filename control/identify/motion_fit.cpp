#include "control/identify/motion_fit.h"

#include "control/base/assert.h"
#include "control/base/units.h"
#include "control/identify/motion_projection.h"
#include "control/identify/torque_loss.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

using AbortCheck = std::function<Result<void>()>;

Result<void> askedToEnd(const AbortCheck& check) {
    return check ? check() : Result<void>();
}

// Coarse search over the damping with the local unknowns only.
Result<double> startDamping(std::span<const MotionSegment> segments, const AbortCheck& check) {
    double best = 1.0;
    double bestSquares = -1.0;
    for (double damping = 0.02; damping < 60.0; damping *= 1.25) {
        double squares = 0.0;
        for (std::size_t i = 0; i < segments.size(); ++i) {
            if (auto goesOn = askedToEnd(check); !goesOn) {
                return failure(goesOn.error());
            }
            squares += projectSegment(segments, i, damping, {}).angleRest.squaredNorm();
        }
        if (bestSquares < 0.0 || squares < bestSquares) {
            bestSquares = squares;
            best = damping;
        }
    }
    return best;
}

Result<double> iterateDamping(std::span<const MotionSegment> segments, double damping,
                              const MotionColumns& columns, const AbortCheck& check) {
    constexpr int MostIterations = 40;
    for (int i = 0; i < MostIterations; ++i) {
        if (auto goesOn = askedToEnd(check); !goesOn) {
            return failure(goesOn.error());
        }
        const MotionSolution solution = solveMotion(segments, damping, columns);
        const Eigen::VectorXd column = withoutGlobal(solution, dampingColumn(segments, solution, damping));
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

// CR2 over segments, never below the independent-noise variance while there are few of them. Few long
// run-ups may carry most of what is known: the degrees of freedom count them and not the segments.
void dampingSpread(MotionFit& fit, const MotionSolution& solution, const Eigen::VectorXd& column,
                   std::span<const MotionSegment> segments, int unknowns) {
    constexpr std::size_t EnoughClusters = 10;
    const double rows = std::max(static_cast<double>(column.size()) - unknowns, 1.0);
    const double noise = solution.squares / rows / column.squaredNorm();
    const auto clusters = fitClusters(solution, column);
    const double spread = clusters ? clusters->covariance(0, 0) : 0.0;
    if (segments.size() < EnoughClusters) {
        fit.dampingError_per_s = std::sqrt(std::max(noise, spread));
        fit.dampingFreedom = rows;
    } else {
        fit.dampingError_per_s = std::sqrt(spread);
        fit.dampingFreedom = clusters ? clusters->freedom(0) : 1.0;
    }
}

double balanceOf(const Eigen::Vector3d& local, int direction, double damping) {
    return direction * (local(2) + damping * local(1));
}

void addBalances(MotionFit& fit, std::span<const MotionSegment> segments, const MotionColumns& columns,
                 const MotionSolution& solution) {
    const double a = fit.damping_per_s;
    const double step = 1e-5 * (std::fabs(a) + 0.1);
    const MotionSolution above = solveMotion(segments, a + step, columns);
    const MotionSolution below = solveMotion(segments, a - step, columns);
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const ProjectedSegment& part = solution.parts[i];
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

Result<void> checkSegments(std::span<const MotionSegment> segments) {
    if (segments.empty()) {
        return failure(ErrorCode::Refused, "the recording has no motion under constant current",
                       "hold each current for a second or more, well above the breakaway current");
    }
    for (const MotionSegment& segment : segments) {
        HB_ASSERT(segment.time_s.size() == segment.angle_rad.size());
        HB_ASSERT(segment.direction == 1 || segment.direction == -1);
        if (segment.time_s.size() <= MotionLocalColumns) {
            return failure(ErrorCode::Refused, "a segment of the motion has too few samples",
                           "record at a higher rate");
        }
        for (const double angle : segment.angle_rad) {
            if (!std::isfinite(angle)) {
                return failure(ErrorCode::NotFinite, "an angle of the recording is not a number",
                               "remove the damaged rows");
            }
        }
    }
    return {};
}

// Errors of the shared unknowns need many segments as clusters.
constexpr std::size_t EnoughClusters = 10;

void addClusterErrors(MotionFit& fit, const MotionColumns& columns, const MotionSolution& solution,
                      const Eigen::VectorXd& bend) {
    const Eigen::MatrixXd covariance = sandwichCovariance(solution, bend);
    for (Eigen::Index i = 0; i < 2 * columns.orders; ++i) {
        fit.angleErrorSpread_rad.push_back(std::sqrt(covariance(i, i)));
    }
    if (!columns.loss.empty()) {
        const Eigen::Index last = columns.count() - 1;
        fit.torqueLossError_s2 = std::sqrt(covariance(last, last));
    }
}

Result<MotionFit> fitOnce(std::span<const MotionSegment> segments, double start_per_s,
                          const MotionColumns& columns, const AbortCheck& check) {
    MotionFit fit;
    const Result<double> damping = iterateDamping(segments, start_per_s, columns, check);
    if (!damping) {
        return failure(damping.error());
    }
    fit.damping_per_s = *damping;
    if (!std::isfinite(fit.damping_per_s)) {
        return failure(ErrorCode::Refused, "the damping cannot be determined from the motion",
                       "record run-ups and coast-downs over a wider range of speed");
    }
    const MotionSolution solution = solveMotion(segments, fit.damping_per_s, columns);
    const Eigen::VectorXd bend = dampingColumn(segments, solution, fit.damping_per_s);
    const Eigen::VectorXd column = withoutGlobal(solution, bend);
    const auto rows = static_cast<double>(solution.rest.size());
    const int unknowns = MotionLocalColumns * static_cast<int>(segments.size()) + columns.count() + 1;
    if (!(column.squaredNorm() > 0.0) || rows <= unknowns) {
        return failure(ErrorCode::Refused, "the segments have no curvature: damping undetermined",
                       "record run-ups and coast-downs besides steady motion");
    }
    fit.angleOrders = columns.orders;
    const auto angleErrors = solution.global.head(2 * columns.orders);
    fit.angleError_rad.assign(angleErrors.begin(), angleErrors.end());
    fit.torqueLoss_s2 = columns.loss.empty() ? 0.0 : solution.global.tail(1).value();
    fit.residualRms_rad = std::sqrt(solution.squares / (rows - unknowns));
    dampingSpread(fit, solution, column, segments, unknowns);
    addBalances(fit, segments, columns, solution);
    if (segments.size() >= EnoughClusters) {
        addClusterErrors(fit, columns, solution, bend);
    }
    return fit;
}

// The loss as an unknown of the fit, in units of `scale_s2` so that all columns are of one size.
Result<MotionFit> fitWithLoss(std::span<const MotionSegment> segments, double start_per_s,
                              MotionColumns columns, const std::vector<Eigen::VectorXd>& response,
                              const MotionFitConfig& config) {
    const double scale_s2 = config.torqueLoss_s2;
    for (const Eigen::VectorXd& column : response) {
        columns.loss.emplace_back(scale_s2 * column);
    }
    auto fit = fitOnce(segments, start_per_s, columns, config.checkAbort);
    if (fit) {
        fit->torqueLoss_s2 *= scale_s2;
        fit->torqueLossError_s2 *= scale_s2;
        fit->isTorqueLossFitted = true;
    }
    return fit;
}

// The loss as assumed; what 1 sigma of the assumption changes is one error that all segments share.
Result<MotionFit> fitAssumingLoss(std::span<const MotionSegment> segments, const MotionFit& first,
                                  const MotionColumns& columns, const std::vector<Eigen::VectorXd>& response,
                                  const MotionFitConfig& config) {
    auto fit = fitOnce(withoutTorqueLoss(segments, response, config.torqueLoss_s2), first.damping_per_s,
                       columns, config.checkAbort);
    if (fit) {
        const double sigma = config.torqueLossError_s2 / config.torqueLoss_s2;
        SharedError error{sigma * (fit->damping_per_s - first.damping_per_s), {}};
        for (std::size_t i = 0; i < first.balances.size(); ++i) {
            error.balances_rad_s2.push_back(
                sigma * (fit->balances[i].balance_rad_s2 - first.balances[i].balance_rad_s2));
        }
        fit->sharedErrors.push_back(std::move(error));
        fit->torqueLoss_s2 = config.torqueLoss_s2;
        fit->torqueLossError_s2 = config.torqueLossError_s2;
    }
    return fit;
}

} // namespace

Result<MotionFit> fitMotion(std::span<const MotionSegment> segments, const MotionFitConfig& config) {
    if (const auto checked = checkSegments(segments); !checked) {
        return failure(checked.error());
    }
    const MotionColumns columns = affordableColumns(segments, config.angleOrders, config.fitsRipple);
    const Result<double> start_per_s = startDamping(segments, config.checkAbort);
    if (!start_per_s) {
        return failure(start_per_s.error());
    }
    auto fit = fitOnce(segments, *start_per_s, columns, config.checkAbort);
    if (!fit || config.torqueLoss_s2 == 0.0) {
        return fit;
    }
    const auto response = torqueLossResponse(segments, *fit, columns);
    if (segments.size() >= EnoughClusters && columns.count() > 0) {
        auto fitted = fitWithLoss(segments, fit->damping_per_s, columns, response, config);
        if (fitted && fitted->torqueLossError_s2 < config.torqueLossError_s2) {
            return fitted;
        }
    }
    if (auto goesOn = askedToEnd(config.checkAbort); !goesOn) {
        return failure(goesOn.error());
    }
    return fitAssumingLoss(segments, *fit, columns, response, config);
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
