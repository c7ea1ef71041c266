#include "control/identify/extra_force_problem.h"

#include "control/base/distributions.h"
#include "control/identify/torque_loss.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {

double extraForce_rad_s2(const ExtraForceTerm& term, double speed_rad_s, double current_A, double time) {
    switch (term.force) {
    case ExtraForce::QuadraticDrag:
        return -speed_rad_s * std::fabs(speed_rad_s);
    case ExtraForce::Stribeck: {
        const double ratio = speed_rad_s / term.stribeckSpeed_rad_s;
        return -std::copysign(std::exp(-ratio * ratio), speed_rad_s);
    }
    case ExtraForce::DampingByDirection:
        return -std::fabs(speed_rad_s);
    case ExtraForce::DampingByCurrent:
        return -current_A * current_A * speed_rad_s;
    case ExtraForce::DampingDrift:
        break;
    }
    return -time * speed_rad_s;
}

ExtraForceProblem::ExtraForceProblem(std::span<const MotionSegment> segments, const MotionFit& fit,
                                     const MotionFitConfig& config)
    : m_segments(segments.begin(), segments.end()), m_fit(fit) {
    MotionColumns columns = affordableColumns(segments, config.angleOrders, config.fitsRipple);
    if (config.torqueLoss_s2 > 0.0) {
        auto response = torqueLossResponse(segments, fit, columns);
        if (fit.isTorqueLossFitted) {
            for (Eigen::VectorXd& one : response) {
                columns.loss.emplace_back(config.torqueLoss_s2 * one);
            }
        } else {
            m_segments = withoutTorqueLoss(segments, response, fit.torqueLoss_s2);
        }
    }
    m_solution = solveMotion(m_segments, fit.damping_per_s, columns);
    for (std::size_t i = 0; i < m_segments.size(); ++i) {
        m_courses.push_back(plainCourse(i, m_solution.local[i]));
    }
    const double begin_s = m_segments.front().time_s.front();
    m_middle_s = 0.5 * (begin_s + m_segments.back().time_s.back());
    m_half_s = std::max(m_segments.back().time_s.back() - m_middle_s, 1e-9);
}

std::vector<ForceResponse> ExtraForceProblem::dampingResponse() const {
    std::vector<ForceResponse> all;
    for (std::size_t i = 0; i < m_segments.size(); ++i) {
        all.push_back(forceResponse(m_segments[i], m_fit.damping_per_s, -m_courses[i]));
    }
    return all;
}

std::vector<ForceResponse> ExtraForceProblem::responseTo(const ExtraForceTerm& term) const {
    std::vector<ForceResponse> all;
    for (std::size_t i = 0; i < m_segments.size(); ++i) {
        Eigen::VectorXd force(m_courses[i].size());
        for (Eigen::Index row = 0; row < force.size(); ++row) {
            const double t_s = m_segments[i].time_s[static_cast<std::size_t>(row)];
            force(row) = extraForce_rad_s2(term, m_courses[i](row), m_segments[i].current_A,
                                           (t_s - m_middle_s) / m_half_s);
        }
        all.push_back(forceResponse(m_segments[i], m_fit.damping_per_s, force));
    }
    return all;
}

Eigen::VectorXd ExtraForceProblem::column(const std::vector<ForceResponse>& response) const {
    return withoutGlobal(m_solution, stacked(response));
}

std::vector<Eigen::Vector3d>
ExtraForceProblem::locals(const std::vector<std::vector<ForceResponse>>& responses,
                          const Eigen::VectorXd& values) const {
    Eigen::VectorXd global = m_solution.global;
    std::vector<Eigen::Vector3d> all;
    if (global.size() > 0) {
        for (std::size_t k = 0; k < responses.size(); ++k) {
            global -= values(static_cast<Eigen::Index>(k)) * m_solution.globalQr.solve(stacked(responses[k]));
        }
    }
    for (std::size_t i = 0; i < m_segments.size(); ++i) {
        const ProjectedSegment& part = m_solution.parts[i];
        Eigen::VectorXd rest = part.angle;
        if (global.size() > 0) {
            rest -= part.global * global;
        }
        for (std::size_t k = 0; k < responses.size(); ++k) {
            rest -= values(static_cast<Eigen::Index>(k)) * responses[k][i].angle;
        }
        all.emplace_back(part.qr.solve(rest));
    }
    return all;
}

std::vector<double> ExtraForceProblem::balances(const std::vector<std::vector<ForceResponse>>& responses,
                                                const Eigen::VectorXd& values) const {
    const auto starts = locals(responses, values);
    std::vector<double> all;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        all.push_back(m_segments[i].direction * (starts[i](2) + m_fit.damping_per_s * starts[i](1)));
    }
    return all;
}

void ExtraForceProblem::correctCourses(const std::vector<std::vector<ForceResponse>>& responses,
                                       const Eigen::VectorXd& values) {
    const auto starts = locals(responses, values);
    for (std::size_t i = 0; i < m_segments.size(); ++i) {
        m_courses[i] = plainCourse(i, starts[i]);
        for (std::size_t k = 0; k < responses.size(); ++k) {
            m_courses[i] += values(static_cast<Eigen::Index>(k)) * responses[k][i].speed;
        }
    }
}

Eigen::VectorXd ExtraForceProblem::stacked(const std::vector<ForceResponse>& response) const {
    std::vector<Eigen::VectorXd> angles;
    for (const ForceResponse& one : response) {
        angles.push_back(one.angle);
    }
    return withoutLocal(m_solution, angles);
}

Eigen::VectorXd ExtraForceProblem::plainCourse(std::size_t which, const Eigen::Vector3d& local) const {
    const MotionSegment& segment = m_segments[which];
    const double a = m_fit.damping_per_s;
    Eigen::VectorXd course(static_cast<Eigen::Index>(segment.time_s.size()));
    for (Eigen::Index row = 0; row < course.size(); ++row) {
        const double t = segment.time_s[static_cast<std::size_t>(row)] - segment.time_s.front();
        const double lag = std::fabs(a * t) < 1e-9 ? t : -std::expm1(-a * t) / a;
        course(row) = local(1) + local(2) * lag;
    }
    return course;
}

namespace {

constexpr std::size_t EnoughClusters = 10;
// Neighbouring Stribeck speeds are nearly one test.
constexpr double IndependentTests = 7.0;

// Variance of the rows' sum of column times residual where neighbours are alike (Newey and West, a quarter of
// a second at 100 Hz), no less than of independent rows.
double rowVariance(const MotionSolution& solution, const Eigen::VectorXd& column, const Eigen::VectorXd& rest,
                   double unknowns) {
    constexpr Eigen::Index Reach = 25;
    const double size = column.squaredNorm();
    const auto rows = static_cast<double>(rest.size());
    const double white = rest.squaredNorm() / std::max(rows - unknowns, 1.0) * size;
    double sum = 0.0;
    Eigen::Index begin = 0;
    for (const ProjectedSegment& part : solution.parts) {
        const Eigen::Index n = part.angle.size();
        const Eigen::VectorXd score = column.segment(begin, n).cwiseProduct(rest.segment(begin, n));
        sum += score.squaredNorm();
        for (Eigen::Index lag = 1; lag < std::min(Reach, n); ++lag) {
            const double weight = 1.0 - static_cast<double>(lag) / static_cast<double>(Reach);
            sum += 2.0 * weight * score.head(n - lag).dot(score.tail(n - lag));
        }
        begin += n;
    }
    return std::max(white, sum) / (size * size);
}

// Few segments are no sample of clusters: then the rows decide as well.
void widenByRows(ClusterFit& fit, const MotionSolution& solution, const Eigen::MatrixXd& columns) {
    if (solution.parts.size() >= EnoughClusters) {
        return;
    }
    constexpr double RowsPerDegree = 25.0;
    const auto rows = static_cast<double>(fit.rest.size());
    const double unknowns = MotionLocalColumns * static_cast<double>(solution.parts.size()) +
                            static_cast<double>(solution.global.size());
    for (Eigen::Index k = 0; k < columns.cols(); ++k) {
        Eigen::MatrixXd others(columns.rows(), columns.cols() - 1);
        others << columns.leftCols(k), columns.rightCols(columns.cols() - 1 - k);
        Eigen::VectorXd own = columns.col(k);
        if (others.cols() > 0) {
            own -= others * others.householderQr().solve(own);
        }
        const double factor = rowVariance(solution, own, fit.rest, unknowns) / fit.covariance(k, k);
        if (factor > 1.0) {
            fit.covariance.row(k) *= std::sqrt(factor);
            fit.covariance.col(k) *= std::sqrt(factor);
        }
        fit.freedom(k) = std::max(fit.freedom(k), (rows - unknowns) / RowsPerDegree);
    }
}

} // namespace

Result<SolvedForces> solveForces(const ExtraForceProblem& problem, const std::vector<ExtraForceTerm>& terms) {
    SolvedForces tested;
    tested.responses.push_back(problem.dampingResponse());
    for (const ExtraForceTerm& term : terms) {
        tested.responses.push_back(problem.responseTo(term));
    }
    Eigen::MatrixXd columns(problem.solution().rest.size(),
                            static_cast<Eigen::Index>(tested.responses.size()));
    for (std::size_t k = 0; k < tested.responses.size(); ++k) {
        columns.col(static_cast<Eigen::Index>(k)) = problem.column(tested.responses[k]);
    }
    auto fit = fitClusters(problem.solution(), columns);
    if (!fit) {
        return failure(fit.error());
    }
    widenByRows(*fit, problem.solution(), columns);
    tested.fit = std::move(*fit);
    tested.values = tested.fit.values;
    for (std::size_t k = 0; k < terms.size(); ++k) {
        const auto place = static_cast<Eigen::Index>(k) + 1;
        ExtraForceTerm term = terms[k];
        term.value = tested.values(place);
        term.error = std::sqrt(tested.fit.covariance(place, place));
        term.freedom = tested.fit.freedom(place);
        term.probability =
            term.error > 0.0
                ? std::min(1.0, IndependentTests * studentTwoSided(term.value / term.error, term.freedom))
                : 1.0;
        tested.terms.push_back(term);
    }
    return tested;
}

} // namespace halbench::control
