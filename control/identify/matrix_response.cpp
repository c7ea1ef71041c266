#include "control/identify/matrix_response.h"

#include "control/base/units.h"
#include "control/identify/frequency_estimate.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;
using Series = std::vector<double>;

constexpr double Alpha = 0.05;
constexpr std::size_t FewestPeriods = 4;

Result<void> checkSeries(const MatrixRows& rows, const std::vector<Series>& all, std::size_t count) {
    for (const Series& series : all) {
        if (series.size() != count || count % rows.rowsPerPeriod != 0) {
            return failure(ErrorCode::InvalidInput, "the excited rows are not whole periods of all signals");
        }
        if (!std::all_of(series.begin(), series.end(), [](double value) { return std::isfinite(value); })) {
            return failure(ErrorCode::NotFinite, "an excited row contains a value that is not a number",
                           "check the recording for gaps or faults");
        }
    }
    return {};
}

Result<void> check(const MatrixRows& rows) {
    if (rows.rowsPerPeriod < 2 || !(rows.period_s > 0.0) || rows.lines.empty() || rows.experiments.empty() ||
        rows.experiments.front().inputs.empty() || rows.experiments.front().outputs.empty()) {
        return failure(ErrorCode::InvalidInput, "there is no excited row of any axis");
    }
    const MatrixExperiment& first = rows.experiments.front();
    const std::size_t count = first.inputs.front().size();
    if (count / rows.rowsPerPeriod < FewestPeriods) {
        return failure(
            ErrorCode::InvalidInput,
            fmt::format("{} periods are too few to estimate the scatter", count / rows.rowsPerPeriod),
            fmt::format("measure at least {}", FewestPeriods));
    }
    if (rows.experiments.size() != first.inputs.size()) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{} experiments do not decide {} inputs", rows.experiments.size(),
                                   first.inputs.size()),
                       "measure as many as there are inputs");
    }
    for (std::size_t i = 0; i < rows.lines.size(); ++i) {
        const bool isAscending = i == 0 || rows.lines[i] > rows.lines[i - 1];
        if (rows.lines[i] < 1 || 2 * static_cast<std::size_t>(rows.lines[i]) >= rows.rowsPerPeriod ||
            !isAscending) {
            return failure(ErrorCode::InvalidInput, "the excited lines do not ascend below half the rate");
        }
    }
    for (const MatrixExperiment& experiment : rows.experiments) {
        if (experiment.inputs.size() != first.inputs.size() ||
            experiment.outputs.size() != first.outputs.size()) {
            return failure(ErrorCode::InvalidInput, "the experiments do not have the same axes");
        }
        for (const auto* all : {&experiment.inputs, &experiment.outputs}) {
            if (auto valid = checkSeries(rows, *all, count); !valid) {
                return valid;
            }
        }
    }
    return {};
}

/// Slope per row of the means of the periods, which hold nothing of the excitation.
double driftOf(const Series& series, std::size_t rowsPerPeriod) {
    const std::size_t periods = series.size() / rowsPerPeriod;
    double covariance = 0.0;
    double variance = 0.0;
    for (std::size_t p = 0; p < periods; ++p) {
        const double place = static_cast<double>(p) - 0.5 * static_cast<double>(periods - 1);
        double sum = 0.0;
        for (std::size_t n = 0; n < rowsPerPeriod; ++n) {
            sum += series[p * rowsPerPeriod + n] - series.front();
        }
        covariance += place * sum / static_cast<double>(rowsPerPeriod);
        variance += place * place;
    }
    return covariance / (variance * static_cast<double>(rowsPerPeriod));
}

/// e^(-2 pi j n/M), n = 0 ... M - 1.
std::vector<Complex> unitWave(std::size_t rowsPerPeriod) {
    std::vector<Complex> wave(rowsPerPeriod);
    for (std::size_t n = 0; n < rowsPerPeriod; ++n) {
        wave[n] = std::polar(1.0, -2.0 * Pi * static_cast<double>(n) / static_cast<double>(rowsPerPeriod));
    }
    return wave;
}

/// One coefficient a period (rows) and series (columns).
Eigen::MatrixXcd coefficients(const std::vector<Series>& all, const std::vector<Complex>& wave, int line) {
    const std::size_t M = wave.size();
    const std::size_t periods = all.front().size() / M;
    Eigen::MatrixXcd result(static_cast<Eigen::Index>(periods), static_cast<Eigen::Index>(all.size()));
    for (std::size_t column = 0; column < all.size(); ++column) {
        const Series& series = all[column];
        const double drift = driftOf(series, M);
        for (std::size_t p = 0; p < periods; ++p) {
            Complex sum = 0.0;
            std::size_t turn = 0;
            for (std::size_t n = 0; n < M; ++n) {
                const double value =
                    series[p * M + n] - series.front() - drift * static_cast<double>(p * M + n);
                sum += value * wave[turn];
                turn = (turn + static_cast<std::size_t>(line)) % M;
            }
            result(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(column)) =
                2.0 / static_cast<double>(M) * sum;
        }
    }
    return result;
}

struct Coefficients {
    std::vector<Eigen::MatrixXcd> U, Y; ///< one an experiment, periods x axes
    Eigen::MatrixXcd meanU, meanY;      ///< axes x experiments
};

Coefficients transform(const MatrixRows& rows, const std::vector<Complex>& wave, int line) {
    Coefficients result;
    const auto experiments = static_cast<Eigen::Index>(rows.experiments.size());
    result.meanU.resize(static_cast<Eigen::Index>(rows.experiments.front().inputs.size()), experiments);
    result.meanY.resize(static_cast<Eigen::Index>(rows.experiments.front().outputs.size()), experiments);
    for (Eigen::Index e = 0; e < experiments; ++e) {
        const MatrixExperiment& experiment = rows.experiments[static_cast<std::size_t>(e)];
        result.U.push_back(coefficients(experiment.inputs, wave, line));
        result.Y.push_back(coefficients(experiment.outputs, wave, line));
        result.meanU.col(e) = result.U.back().colwise().mean().transpose();
        result.meanY.col(e) = result.Y.back().colwise().mean().transpose();
    }
    return result;
}

/// Inputs have units of their own, so that each is scaled by its largest coefficient before it is judged.
bool isDecided(const Eigen::MatrixXcd& meanU) {
    constexpr double Least_ratio = 1e-3;
    const Eigen::VectorXd size = meanU.cwiseAbs().rowwise().maxCoeff();
    if (!(size.minCoeff() > 0.0)) {
        return false;
    }
    const Eigen::MatrixXcd scaled = size.cwiseInverse().asDiagonal() * meanU;
    const Eigen::VectorXd singular = Eigen::JacobiSVD<Eigen::MatrixXcd>(scaled).singularValues();
    return singular.minCoeff() > Least_ratio * singular.maxCoeff();
}

MatrixPoint pointOf(const Coefficients& c) {
    MatrixPoint point;
    point.inverse = c.meanU.inverse();
    point.value = c.meanY * point.inverse;
    const double periods = static_cast<double>(c.U.front().rows());
    const double freedom = static_cast<double>(c.U.size()) * (periods - 1.0);
    const Eigen::Index outputs = c.meanY.rows();
    Eigen::MatrixXcd sum = Eigen::MatrixXcd::Zero(outputs, outputs);
    Eigen::VectorXd power = Eigen::VectorXd::Zero(outputs);
    for (std::size_t e = 0; e < c.U.size(); ++e) {
        const Eigen::MatrixXcd error = c.Y[e].transpose() - point.value * c.U[e].transpose();
        sum += error * error.adjoint();
        power += c.Y[e].cwiseAbs2().colwise().sum().transpose();
    }
    point.averages = static_cast<int>(periods);
    point.freedom = 2.0 * freedom;
    point.scatter = sum / (freedom * periods);
    point.coherence.resize(outputs);
    point.radius.resize(outputs, c.meanU.rows());
    for (Eigen::Index i = 0; i < outputs; ++i) {
        const double noise = sum(i, i).real() * periods / (periods - 1.0);
        point.coherence(i) = power(i) > 0.0 ? std::clamp(1.0 - noise / power(i), 0.0, 1.0) : 0.0;
        for (Eigen::Index j = 0; j < c.meanU.rows(); ++j) {
            point.radius(i, j) = scatterRadius(point, Eigen::VectorXcd::Unit(outputs, i),
                                               Eigen::VectorXcd::Unit(c.meanU.rows(), j));
        }
    }
    return point;
}

} // namespace

double scatterRadius(const MatrixPoint& point, const Eigen::VectorXcd& left, const Eigen::VectorXcd& right) {
    const double along = (left.transpose() * point.scatter * left.conjugate())(0, 0).real();
    const double variance = std::max(along, 0.0) * (point.inverse * right).squaredNorm();
    return std::sqrt(variance * fisherQuantileOfTwo(Alpha, point.freedom));
}

Result<std::vector<MatrixPoint>> estimateMatrix(const MatrixRows& rows) {
    if (auto checked = check(rows); !checked) {
        return failure(checked.error());
    }
    const std::vector<Complex> wave = unitWave(rows.rowsPerPeriod);
    std::vector<MatrixPoint> points;
    for (const int line : rows.lines) {
        const Coefficients c = transform(rows, wave, line);
        const double frequency_Hz =
            static_cast<double>(line) / (rows.period_s * static_cast<double>(rows.rowsPerPeriod));
        if (!isDecided(c.meanU)) {
            return failure(ErrorCode::Refused,
                           fmt::format("the excitation did not reach every axis at {:.4g} Hz", frequency_Hz),
                           "check that the excitation ran on all of them");
        }
        points.push_back(pointOf(c));
        points.back().frequency_rad_s = 2.0 * Pi * frequency_Hz;
    }
    return points;
}

} // namespace halbench::control
