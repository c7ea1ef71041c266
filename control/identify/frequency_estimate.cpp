#include "control/identify/frequency_estimate.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

constexpr double Alpha = 0.05;
constexpr std::size_t FewestPeriods = 4;
constexpr int TurnHarmonics = 12; // of sensors, magnets and bearing (help: htm-theory.md 4.3, 9)

std::size_t periodsOf(const ExcitedRows& rows) {
    return rows.reference.size() / rows.rowsPerPeriod;
}

Result<void> check(const ExcitedRows& rows) {
    const std::size_t count = rows.reference.size();
    if (rows.rowsPerPeriod < 2 || count != rows.input.size() || count != rows.output.size() ||
        count % rows.rowsPerPeriod != 0 || !(rows.period_s > 0.0) || rows.lines.empty()) {
        return failure(ErrorCode::InvalidInput, "the excited rows are not complete periods of three signals");
    }
    if (periodsOf(rows) < FewestPeriods) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{} periods are too few to estimate the scatter", periodsOf(rows)),
                       fmt::format("measure at least {}", FewestPeriods));
    }
    for (std::size_t i = 0; i < rows.lines.size(); ++i) {
        const bool isAscending = i == 0 || rows.lines[i] > rows.lines[i - 1];
        if (rows.lines[i] < 1 || 2 * static_cast<std::size_t>(rows.lines[i]) >= rows.rowsPerPeriod ||
            !isAscending) {
            return failure(ErrorCode::InvalidInput, "the excited lines do not ascend below half the rate");
        }
    }
    for (const auto& signal : {rows.reference, rows.input, rows.output}) {
        if (!std::all_of(signal.begin(), signal.end(), [](double value) { return std::isfinite(value); })) {
            return failure(ErrorCode::NotFinite, "an excited row contains a value that is not a number",
                           "check the recording for gaps or faults");
        }
    }
    return {};
}

/// Frequencies in lines of the base motion's harmonics. One that all periods together cannot tell from an
/// excited line is left where it is: it then counts as scatter.
std::vector<double> turnHarmonics(const ExcitedRows& rows) {
    std::vector<double> harmonics;
    const double perPeriod =
        std::abs(rows.turn_rad_s) / (2.0 * Pi) * rows.period_s * static_cast<double>(rows.rowsPerPeriod);
    const double resolution = 1.0 / static_cast<double>(periodsOf(rows));
    for (int n = 1; n <= TurnHarmonics && perPeriod > 0.0; ++n) {
        const double place = n * perPeriod;
        const bool isApart = std::abs(place - std::round(place)) >= resolution;
        if (isApart && place < 0.5 * static_cast<double>(rows.rowsPerPeriod)) {
            harmonics.push_back(place);
        }
    }
    return harmonics;
}

void setWave(Eigen::MatrixXd& basis, Eigen::Index column, double line, std::size_t rowsPerPeriod) {
    const double step_rad = 2.0 * Pi * line / static_cast<double>(rowsPerPeriod);
    for (Eigen::Index row = 0; row < basis.rows(); ++row) {
        basis(row, column) = std::cos(step_rad * static_cast<double>(row));
        basis(row, column + 1) = std::sin(step_rad * static_cast<double>(row));
    }
}

/// r, u, y as columns without mean, drift and turn harmonics.
Eigen::MatrixXd undisturbed(const ExcitedRows& rows) {
    const auto count = static_cast<Eigen::Index>(rows.reference.size());
    Eigen::MatrixXd signals(count, 3);
    const std::span<const double> sources[] = {rows.reference, rows.input, rows.output};
    for (Eigen::Index column = 0; column < 3; ++column) {
        const auto& source = sources[column];
        for (Eigen::Index row = 0; row < count; ++row) {
            signals(row, column) = source[static_cast<std::size_t>(row)] - source.front();
        }
    }
    const std::vector<double> harmonics = turnHarmonics(rows);
    const auto disturbing = static_cast<Eigen::Index>(2 + 2 * harmonics.size());
    Eigen::MatrixXd basis(count, disturbing + static_cast<Eigen::Index>(2 * rows.lines.size()));
    basis.col(0).setOnes();
    basis.col(1) = Eigen::VectorXd::LinSpaced(count, -1.0, 1.0);
    Eigen::Index column = 2;
    for (const double line : harmonics) {
        setWave(basis, column, line, rows.rowsPerPeriod);
        column += 2;
    }
    for (const int line : rows.lines) {
        setWave(basis, column, line, rows.rowsPerPeriod);
        column += 2;
    }
    const Eigen::MatrixXd coefficients = basis.householderQr().solve(signals);
    return signals - basis.leftCols(disturbing) * coefficients.topRows(disturbing);
}

struct Coefficients {
    Eigen::VectorXcd R, U, Y; ///< one of each period
};

Coefficients transform(const Eigen::MatrixXd& signals, std::size_t rowsPerPeriod, int line) {
    const auto M = static_cast<Eigen::Index>(rowsPerPeriod);
    const Eigen::Index periods = signals.rows() / M;
    Eigen::VectorXcd wave(M);
    for (Eigen::Index n = 0; n < M; ++n) {
        wave(n) =
            std::polar(2.0 / static_cast<double>(M), -2.0 * Pi * static_cast<double>(line) *
                                                         static_cast<double>(n) / static_cast<double>(M));
    }
    Coefficients result{Eigen::VectorXcd(periods), Eigen::VectorXcd(periods), Eigen::VectorXcd(periods)};
    for (Eigen::Index p = 0; p < periods; ++p) {
        const Eigen::RowVector3cd sums = wave.transpose() * signals.middleRows(p * M, M).cast<Complex>();
        result.R(p) = sums(0);
        result.U(p) = sums(1);
        result.Y(p) = sums(2);
    }
    return result;
}

double coherenceOf(const Eigen::VectorXcd& x, const Eigen::VectorXcd& r) {
    const double power = x.squaredNorm() * r.squaredNorm();
    return power > 0.0 ? std::min(std::norm(r.dot(x)) / power, 1.0) : 0.0;
}

} // namespace

double fisherQuantileOfTwo(double alpha, double freedom) {
    return 0.5 * freedom * (std::pow(alpha, -2.0 / freedom) - 1.0);
}

Result<std::vector<PlantPoint>> estimatePlant(const ExcitedRows& rows) {
    if (auto checked = check(rows); !checked) {
        return failure(checked.error());
    }
    const Eigen::MatrixXd signals = undisturbed(rows);
    const double P = static_cast<double>(periodsOf(rows));
    std::vector<PlantPoint> points;
    for (const int line : rows.lines) {
        const Coefficients c = transform(signals, rows.rowsPerPeriod, line);
        const Complex Syr = c.R.dot(c.Y); // dot() conjugates its left side
        const Complex Sur = c.R.dot(c.U);
        if (Sur == 0.0) {
            return failure(ErrorCode::Refused, "the excitation did not reach the plant",
                           "check that the reference generator was running");
        }
        PlantPoint point;
        point.frequency_rad_s = 2.0 * Pi * line / (rows.period_s * static_cast<double>(rows.rowsPerPeriod));
        point.value = Syr / Sur;
        point.coherence = std::min(coherenceOf(c.U, c.R), coherenceOf(c.Y, c.R));
        point.averages = static_cast<int>(P);
        const double scatter = (c.Y - point.value * c.U).squaredNorm() / (P - 1.0);
        const double variance = scatter * c.R.squaredNorm() / std::norm(Sur);
        point.radius = std::sqrt(variance * fisherQuantileOfTwo(Alpha, 2.0 * (P - 1.0)));
        points.push_back(point);
    }
    return points;
}

} // namespace halbench::control
