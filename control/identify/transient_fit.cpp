#include "control/identify/transient_fit.h"

#include "control/base/assert.h"
#include "control/identify/least_squares.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

// (e^-x - 1 + x)/x^2, smooth through zero.
double bend(double x) {
    return std::fabs(x) < 1e-3 ? 0.5 - x / 6.0 + x * x / 24.0 : (std::expm1(-x) + x) / (x * x);
}

// Where each unknown stands in the parameter vector.
struct Layout {
    bool hasTorque = false;
    std::vector<Eigen::Index> start; // psi0 of each record; omega0 follows unless it starts at rest
    Eigen::Index count = 0;

    Eigen::Index shared() const { return hasTorque ? 3 : 2; }
};

Layout layoutOf(std::span<const TransientRecord> records) {
    Layout layout;
    layout.hasTorque = std::any_of(records.begin(), records.end(),
                                   [](const TransientRecord& record) { return record.current_A != 0.0; });
    layout.count = layout.shared();
    for (const TransientRecord& record : records) {
        layout.start.push_back(layout.count);
        layout.count += record.startsAtRest ? 1 : 2;
    }
    return layout;
}

double angleAt(const TransientRecord& record, const Layout& layout, std::size_t index,
               const Eigen::VectorXd& p, double t) {
    const double a = p(0);
    const Eigen::Index place = layout.start[index];
    const double speed = record.startsAtRest ? 0.0 : p(place + 1);
    const double drive = layout.hasTorque ? p(2) * record.current_A : 0.0;
    const double acceleration = drive - record.direction * p(1) - a * speed;
    double until = t;
    const double fall = -speed / acceleration; // > 0 when it comes to rest
    if (fall > 0.0 && 1.0 - a * fall > 0.0) {
        const double rest = std::fabs(a * fall) < 1e-9 ? fall : -std::log1p(-a * fall) / a;
        until = std::min(t, rest);
    }
    return p(place) + speed * until + acceleration * until * until * bend(a * until);
}

Eigen::VectorXd predict(std::span<const TransientRecord> records, const Layout& layout,
                        const Eigen::VectorXd& p, Eigen::Index rows) {
    Eigen::VectorXd angle(rows);
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < records.size(); ++i) {
        for (const double t : records[i].time_s) {
            angle(row++) = angleAt(records[i], layout, i, p, t - records[i].time_s.front());
        }
    }
    return angle;
}

Eigen::MatrixXd jacobian(std::span<const TransientRecord> records, const Layout& layout,
                         const Eigen::VectorXd& p, Eigen::Index rows) {
    Eigen::MatrixXd result(rows, layout.count);
    for (Eigen::Index i = 0; i < layout.count; ++i) {
        const double step = 1e-6 * (std::fabs(p(i)) + 1e-2);
        Eigen::VectorXd moved = p;
        moved(i) = p(i) + step;
        const Eigen::VectorXd above = predict(records, layout, moved, rows);
        moved(i) = p(i) - step;
        result.col(i) = (above - predict(records, layout, moved, rows)) / (2.0 * step);
    }
    return result;
}

// Samples of a record that surely belong to the motion: the first nine tenths of its travel.
std::size_t movingSamples(const TransientRecord& record) {
    const double travel = record.angle_rad.back() - record.angle_rad.front();
    std::size_t count = 0;
    while (count < record.angle_rad.size() &&
           std::fabs(record.angle_rad[count] - record.angle_rad.front()) < 0.9 * std::fabs(travel)) {
        ++count;
    }
    return std::max<std::size_t>(count, 4);
}

// Starting point for one damping: while it moves, the angle is linear in all other unknowns.
std::optional<Eigen::VectorXd> startValues(std::span<const TransientRecord> records, const Layout& layout,
                                           double damping) {
    std::vector<Eigen::RowVectorXd> rows;
    std::vector<double> angles;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const TransientRecord& record = records[i];
        for (std::size_t sample = 0; sample < movingSamples(record); ++sample) {
            const double t = record.time_s[sample] - record.time_s.front();
            const double curve = t * t * bend(damping * t);
            Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(layout.count - 1); // all but the damping
            row(0) = -record.direction * curve;
            if (layout.hasTorque) {
                row(1) = record.current_A * curve;
            }
            row(layout.start[i] - 1) = 1.0;
            if (!record.startsAtRest) {
                row(layout.start[i]) = t - damping * curve;
            }
            rows.push_back(row);
            angles.push_back(record.angle_rad[sample]);
        }
    }
    Eigen::MatrixXd design(static_cast<Eigen::Index>(rows.size()), layout.count - 1);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        design.row(static_cast<Eigen::Index>(i)) = rows[i];
    }
    const auto fit = fitLinear(
        design, Eigen::Map<const Eigen::VectorXd>(angles.data(), static_cast<Eigen::Index>(angles.size())));
    if (!fit) {
        return std::nullopt;
    }
    Eigen::VectorXd p(layout.count);
    p << damping, fit->coefficients;
    return p;
}

// Rank of the scaled columns; differences of the model carry errors of 1e-9, far below this threshold.
bool decidesAll(const Eigen::MatrixXd& slopes) {
    const Eigen::VectorXd scales = slopes.colwise().norm().transpose();
    if (!(scales.minCoeff() > 0.0)) {
        return false;
    }
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(slopes * scales.cwiseInverse().asDiagonal());
    qr.setThreshold(1e-6);
    return qr.rank() == slopes.cols();
}

// Levenberg and Marquardt with the diagonal of the normal matrix as scale.
double minimise(std::span<const TransientRecord> records, const Layout& layout,
                const Eigen::VectorXd& observed, Eigen::VectorXd& p) {
    constexpr int MostIterations = 100;
    double lambda = 1e-3;
    Eigen::VectorXd rest = observed - predict(records, layout, p, observed.size());
    double squares = rest.squaredNorm();
    for (int i = 0; i < MostIterations && lambda < 1e12; ++i) {
        const Eigen::MatrixXd slopes = jacobian(records, layout, p, observed.size());
        const Eigen::MatrixXd normal = slopes.transpose() * slopes;
        Eigen::MatrixXd damped = normal;
        damped.diagonal() += lambda * normal.diagonal();
        const Eigen::VectorXd step = damped.ldlt().solve(slopes.transpose() * rest);
        const Eigen::VectorXd tried = p + step;
        const Eigen::VectorXd newRest = observed - predict(records, layout, tried, observed.size());
        const double newSquares = newRest.squaredNorm();
        if (!(newSquares < squares)) {
            lambda *= 10.0;
            continue;
        }
        const bool isDone = (step.array().abs() <= 1e-12 * (p.array().abs() + 1e-6)).all();
        p = tried;
        rest = newRest;
        squares = newSquares;
        lambda *= 0.1;
        if (isDone) {
            break;
        }
    }
    return squares;
}

} // namespace

Result<TransientFit> fitTransients(std::span<const TransientRecord> records) {
    Eigen::Index rows = 0;
    for (const TransientRecord& record : records) {
        HB_ASSERT(record.time_s.size() == record.angle_rad.size());
        constexpr std::size_t FewestSamples = 4;
        if (record.time_s.size() < FewestSamples) {
            return failure(ErrorCode::Refused, "a record has too few samples",
                           "record at a higher rate or for a longer time");
        }
        rows += static_cast<Eigen::Index>(record.time_s.size());
    }
    if (records.empty()) {
        return failure(ErrorCode::Refused, "no run-up and no coast-down", "record run-ups or coast-downs");
    }
    Eigen::VectorXd observed(rows);
    Eigen::Index row = 0;
    for (const TransientRecord& record : records) {
        for (const double angle : record.angle_rad) {
            observed(row++) = angle;
        }
    }
    if (!observed.allFinite()) {
        return failure(ErrorCode::NotFinite, "an angle is not a number", "remove the damaged rows");
    }
    const Layout layout = layoutOf(records);
    Eigen::VectorXd best;
    double least = std::numeric_limits<double>::infinity();
    for (const double damping : {0.3, 2.0, 8.0}) {
        auto p = startValues(records, layout, damping);
        const double squares = p ? minimise(records, layout, observed, *p) : least;
        if (squares < least) {
            least = squares;
            best = *p;
        }
    }
    if (best.size() == 0 || !best.allFinite()) {
        return failure(ErrorCode::Refused, "the records do not separate torque, friction and damping",
                       "add a coast-down or a run-up at a second current");
    }
    const Eigen::MatrixXd slopes = jacobian(records, layout, best, rows);
    const auto local = fitLinear(slopes, observed - predict(records, layout, best, rows));
    if (!local || !decidesAll(slopes)) {
        return failure(ErrorCode::Refused, "the records do not separate torque, friction and damping",
                       "add a coast-down or a run-up at a second current");
    }
    TransientFit fit;
    fit.damping_per_s = best(0);
    fit.friction_rad_s2 = best(1);
    if (layout.hasTorque) {
        fit.torque_rad_s2_A = best(2);
    }
    fit.covariance = local->covariance.topLeftCorner(layout.shared(), layout.shared());
    fit.angleNoise_rad = std::sqrt(local->residualVariance);
    return fit;
}

} // namespace halbench::control
