#include "control/identify/swept_estimate.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

constexpr double Alpha = 0.05;
constexpr std::size_t FewestSweeps = 4;
constexpr int TurnHarmonics = 12; // of sensors, magnets and bearing (help: htm-theory.md 4.3, 9)
constexpr int DriftPowers = 3;    // the law's integral creeps for minutes

Result<void> check(const SweptRows& rows) {
    const std::size_t count = rows.reference.size();
    const bool isOrdered = std::adjacent_find(rows.starts.begin(), rows.starts.end(),
                                              [&rows](std::size_t left, std::size_t right) {
                                                  return right < left + rows.rowsPerSweep;
                                              }) == rows.starts.end();
    const bool isBand = rows.lowest_rad_s > 0.0 && rows.highest_rad_s > rows.lowest_rad_s &&
                        rows.highest_rad_s * rows.period_s < Pi && rows.points > 0;
    constexpr std::size_t FewestRestRows = 50; // enough of each rest for all that is fitted there
    if (rows.restRows < FewestRestRows || rows.restRows >= rows.rowsPerSweep || count != rows.input.size() ||
        count != rows.output.size() || !isOrdered || !isBand || rows.starts.empty() ||
        rows.starts.back() + rows.rowsPerSweep > count) {
        return failure(ErrorCode::InvalidInput, "the swept rows are not complete sweeps of three signals");
    }
    if (rows.starts.size() < FewestSweeps) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{} sweeps are too few to estimate the scatter", rows.starts.size()),
                       fmt::format("measure at least {}", FewestSweeps));
    }
    for (const auto& signal : {rows.reference, rows.input, rows.output}) {
        if (!std::all_of(signal.begin(), signal.end(), [](double value) { return std::isfinite(value); })) {
            return failure(ErrorCode::NotFinite, "a swept row contains a value that is not a number",
                           "check the recording for gaps or faults");
        }
    }
    return {};
}

/// What is there without the sweeps: drift, and what repeats with the place of the rotor.
Eigen::RowVectorXd disturbance(const SweptRows& rows, std::size_t row) {
    Eigen::RowVectorXd basis(1 + DriftPowers + 2 * TurnHarmonics);
    const double whole = static_cast<double>(rows.reference.size());
    const double place = 2.0 * static_cast<double>(row) / whole - 1.0;
    double power = 1.0;
    Eigen::Index column = 0;
    for (; column <= DriftPowers; power *= place) {
        basis(column++) = power;
    }
    for (int n = 1; n <= TurnHarmonics; ++n) {
        basis(column++) = std::cos(n * rows.reference[row]);
        basis(column++) = std::sin(n * rows.reference[row]);
    }
    return basis;
}

/// u and e = r - y of a row; the error, and not y itself, because it comes back to where it was.
Eigen::RowVector2d signalsOf(const SweptRows& rows, std::size_t row) {
    return {rows.input[row], rows.reference[row] - rows.output[row]};
}

/// Both from the first sweep to the end of the last, without what is there without the sweeps.
Eigen::MatrixXd undisturbed(const SweptRows& rows) {
    const auto rests = static_cast<Eigen::Index>(rows.starts.size() * rows.restRows);
    Eigen::MatrixXd basis(rests, 1 + DriftPowers + 2 * TurnHarmonics);
    Eigen::MatrixXd atRest(rests, 2);
    Eigen::Index at = 0;
    for (const std::size_t start : rows.starts) {
        const std::size_t end = start + rows.rowsPerSweep;
        for (std::size_t row = end - rows.restRows; row < end; ++row, ++at) {
            basis.row(at) = disturbance(rows, row);
            atRest.row(at) = signalsOf(rows, row);
        }
    }
    const Eigen::MatrixXd coefficients = basis.colPivHouseholderQr().solve(atRest);
    const std::size_t first = rows.starts.front();
    const std::size_t count = rows.starts.back() + rows.rowsPerSweep - first;
    Eigen::MatrixXd signals(static_cast<Eigen::Index>(count), 2);
    for (std::size_t row = 0; row < count; ++row) {
        signals.row(static_cast<Eigen::Index>(row)) =
            signalsOf(rows, first + row) - disturbance(rows, first + row) * coefficients;
    }
    return signals;
}

/// What a free inertia under held current makes of it, but for a factor.
Complex inertia(Complex z) {
    return (z + 1.0) / ((z - 1.0) * (z - 1.0));
}

/// Coefficients of one line, one of each sweep, y already brought to the frequency of its point.
struct Line {
    Eigen::VectorXcd R, U, Y;
};

class Sweeps {
public:
    explicit Sweeps(const SweptRows& rows) : m_rows(rows), m_signals(undisturbed(rows)) {}

    double lineOf(double frequency_rad_s) const {
        return frequency_rad_s * m_rows.period_s * static_cast<double>(m_rows.rowsPerSweep) / (2.0 * Pi);
    }
    double frequency_rad_s(int line) const { return line / lineOf(1.0); }

    Line line(int k, double centre_rad_s) const {
        const auto N = static_cast<Eigen::Index>(m_rows.rowsPerSweep);
        const double step_rad = frequency_rad_s(k) * m_rows.period_s;
        Eigen::VectorXcd wave(N);
        for (Eigen::Index n = 0; n < N; ++n) {
            wave(n) = std::polar(1.0, -step_rad * static_cast<double>(n));
        }
        const Complex z = std::polar(1.0, step_rad);
        const Complex shape = inertia(std::polar(1.0, centre_rad_s * m_rows.period_s)) / inertia(z);
        const auto sweeps = static_cast<Eigen::Index>(m_rows.starts.size());
        Line result{Eigen::VectorXcd(sweeps), Eigen::VectorXcd(sweeps), Eigen::VectorXcd(sweeps)};
        for (Eigen::Index p = 0; p < sweeps; ++p) {
            const std::size_t start = m_rows.starts[static_cast<std::size_t>(p)];
            const auto row = static_cast<Eigen::Index>(start - m_rows.starts.front());
            const Eigen::VectorXd swept = departure(start);
            const Complex shift = departureAfter(start) / (1.0 - 1.0 / z);
            result.R(p) = wave.cwiseProduct(swept.cast<Complex>()).sum() + shift;
            result.U(p) = wave.cwiseProduct(m_signals.col(0).segment(row, N).cast<Complex>()).sum();
            const Complex E = wave.cwiseProduct(m_signals.col(1).segment(row, N).cast<Complex>()).sum();
            result.Y(p) = shape * (result.R(p) - E);
        }
        return result;
    }

private:
    /// r of a sweep over the steady motion, from zero.
    double departureAt(std::size_t start, std::size_t n) const {
        return m_rows.reference[start + n] - m_rows.reference[start] -
               m_rows.turn_rad_s * m_rows.period_s * static_cast<double>(n);
    }
    Eigen::VectorXd departure(std::size_t start) const {
        Eigen::VectorXd values(static_cast<Eigen::Index>(m_rows.rowsPerSweep));
        for (std::size_t n = 0; n < m_rows.rowsPerSweep; ++n) {
            values(static_cast<Eigen::Index>(n)) = departureAt(start, n);
        }
        return values;
    }
    double departureAfter(std::size_t start) const { return departureAt(start, m_rows.rowsPerSweep - 1); }

    const SweptRows& m_rows;
    Eigen::MatrixXd m_signals;
};

/// Sums over the lines of one point.
struct Sums {
    Complex Syr = 0.0, Sur = 0.0;
    double R2 = 0.0, U2 = 0.0, Y2 = 0.0;
    double coherentU = 0.0, coherentY = 0.0; ///< part of U2 and Y2 that r explains line by line

    void add(const Line& line) {
        const Complex yr = line.R.dot(line.Y); // dot() conjugates its left side
        const Complex ur = line.R.dot(line.U);
        const double power = line.R.squaredNorm();
        Syr += yr;
        Sur += ur;
        R2 += power;
        U2 += line.U.squaredNorm();
        Y2 += line.Y.squaredNorm();
        coherentU += power > 0.0 ? std::norm(ur) / power : 0.0;
        coherentY += power > 0.0 ? std::norm(yr) / power : 0.0;
    }
    double coherence() const {
        return U2 > 0.0 && Y2 > 0.0 ? std::min({coherentU / U2, coherentY / Y2, 1.0}) : 0.0;
    }
};

Result<PlantPoint> pointOf(const Sweeps& sweeps, int first, int last) {
    PlantPoint point;
    point.frequency_rad_s = 0.5 * (sweeps.frequency_rad_s(first) + sweeps.frequency_rad_s(last));
    std::vector<Line> lines;
    Sums sums;
    for (int k = first; k <= last; ++k) {
        lines.push_back(sweeps.line(k, point.frequency_rad_s));
        sums.add(lines.back());
    }
    if (sums.Sur == 0.0) {
        return failure(ErrorCode::Refused, "the excitation did not reach the plant",
                       "check that the reference generator was running");
    }
    point.value = sums.Syr / sums.Sur;
    point.coherence = sums.coherence();
    point.averages = static_cast<int>(lines.size()) * static_cast<int>(lines.front().R.size());
    double scatter = 0.0;
    for (const Line& line : lines) {
        scatter += (line.Y - point.value * line.U).squaredNorm();
    }
    scatter /= point.averages - 1.0;
    const double variance = scatter * sums.R2 / std::norm(sums.Sur);
    point.radius = std::sqrt(variance * fisherQuantileOfTwo(Alpha, 2.0 * (point.averages - 1)));
    return point;
}

} // namespace

Result<std::vector<PlantPoint>> estimateSweptPlant(const SweptRows& rows) {
    if (auto checked = check(rows); !checked) {
        return failure(checked.error());
    }
    const Sweeps sweeps(rows);
    const int from = std::max(1, static_cast<int>(std::ceil(sweeps.lineOf(rows.lowest_rad_s))));
    const int to = static_cast<int>(std::floor(sweeps.lineOf(rows.highest_rad_s)));
    if (to < from) {
        return failure(ErrorCode::InvalidInput, "a sweep is too short to resolve its frequencies");
    }
    const int count = to - from + 1;
    const int points = std::min(rows.points, count);
    std::vector<PlantPoint> result;
    for (int i = 0; i < points; ++i) {
        const int first = from + count * i / points;
        const auto point = pointOf(sweeps, first, from + count * (i + 1) / points - 1);
        if (!point) {
            return failure(point.error());
        }
        result.push_back(*point);
    }
    return result;
}

} // namespace halbench::control
