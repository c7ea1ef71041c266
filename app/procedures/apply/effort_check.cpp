#include "app/procedures/apply/effort_check.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

namespace halbench::app {
namespace {

constexpr double Unmodelled_ratio = 0.25;
constexpr double Sigmas = 2.0;
constexpr double Most_ratio = 0.25; // half and twice the mass stay outside

/// 1 sigma of the first unknown relative to it. Neighbouring rows are alike (Newey and West); no less than of
/// independent rows.
double deviation_ratio(const Eigen::MatrixXd& columns, const Eigen::VectorXd& solution,
                       const Eigen::VectorXd& rest) {
    const Eigen::Index rows = columns.rows();
    const Eigen::Index reach = rows / 4;
    const Eigen::MatrixXd others = columns.rightCols(columns.cols() - 1);
    const Eigen::VectorXd own = columns.col(0) - others * others.colPivHouseholderQr().solve(columns.col(0));
    const Eigen::VectorXd score = own.cwiseProduct(rest);
    double sum = score.squaredNorm();
    for (Eigen::Index lag = 1; lag < reach; ++lag) {
        const double weight = 1.0 - static_cast<double>(lag) / static_cast<double>(reach);
        sum += 2.0 * weight * score.head(rows - lag).dot(score.tail(rows - lag));
    }
    const double white = rest.squaredNorm() / static_cast<double>(rows - columns.cols()) * own.squaredNorm();
    return std::sqrt(std::max(sum, white)) / (own.squaredNorm() * std::fabs(solution[0]));
}

/// x'' = a - c x' from rest, one row after the other.
class Motion {
public:
    explicit Motion(double damping_1_s) : m_damping_1_s(damping_1_s) {}
    double step(double acceleration, double step_s) {
        const double net = acceleration - m_damping_1_s * m_speed;
        m_way += step_s * (m_speed + 0.5 * step_s * net);
        m_speed += step_s * net;
        return m_way;
    }

private:
    double m_damping_1_s;
    double m_speed = 0.0;
    double m_way = 0.0;
};

} // namespace

std::optional<EffortAgreement> effortAgreement(const Recording& move, const EffortColumns& columns,
                                               const control::PositionPlant& plant,
                                               double gainDeviation_ratio, double until_s) {
    constexpr Eigen::Index Unknowns = 5; // alpha, p, s, speed and place at the start
    constexpr Eigen::Index LeastRows = 20;
    const std::vector<double> position = move.column(columns.position);
    const std::vector<double> effort = move.column(columns.effort);
    Eigen::Index rows = 0;
    while (static_cast<std::size_t>(rows) < position.size() &&
           move.time_s[static_cast<std::size_t>(rows)] <= until_s) {
        ++rows;
    }
    if (effort.size() != position.size() || rows < LeastRows) {
        return std::nullopt;
    }
    Eigen::MatrixXd regressors = Eigen::MatrixXd::Zero(rows, Unknowns);
    Eigen::VectorXd way = Eigen::VectorXd::Zero(rows);
    Motion driven(plant.dampingRate_1_s);
    Motion pushed(plant.dampingRate_1_s);
    Motion sprung(plant.dampingRate_1_s);
    regressors(0, 4) = 1.0;
    for (Eigen::Index i = 1; i < rows; ++i) {
        const auto row = static_cast<std::size_t>(i);
        const double step_s = move.time_s[row] - move.time_s[row - 1];
        way[i] = position[row] - position.front();
        // The effort of a row is the one that acted until then.
        regressors(i, 0) = driven.step(plant.accelerationGain_rad_s2_A * effort[row], step_s);
        regressors(i, 1) = pushed.step(1.0, step_s);
        regressors(i, 2) = sprung.step(way[i - 1], step_s);
        regressors(i, 3) = move.time_s[row] - move.time_s.front();
        regressors(i, 4) = 1.0;
    }
    const Eigen::RowVectorXd scale = regressors.colwise().norm();
    if (!(scale.minCoeff() > 0.0)) {
        return std::nullopt;
    }
    const Eigen::MatrixXd scaled = regressors.array().rowwise() / scale.array();
    const Eigen::VectorXd solution = scaled.colPivHouseholderQr().solve(way);
    const double alpha = solution[0] / scale[0];
    const double ofFit_ratio = deviation_ratio(scaled, solution, way - scaled * solution);
    // A fit that says nothing must not allow everything.
    const double allowed_ratio =
        1.0 + Unmodelled_ratio + std::min(Sigmas * std::hypot(gainDeviation_ratio, ofFit_ratio), Most_ratio);
    // A motion the other way took no effort of this kind: outside of every band.
    return EffortAgreement{alpha > 0.0 ? 1.0 / alpha : 0.0, 1.0 / allowed_ratio, allowed_ratio};
}

} // namespace halbench::app
