// Stability and margins of many loops at once.
#include "control/analysis/frequency_scan.h"
#include "control/base/units.h"
#include "control/law/filtered_delta.h"
#include "control/robustness/loop_batch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace halbench::control {

namespace {

using Complex = std::complex<double>;

/// The scan of one loop with fewer points: these loops turn slowly. Where the scan is closer, around lightly
/// damped zeros, every point stays.
std::vector<double> thinned(const std::vector<double>& scan) {
    constexpr double Usual_log = 2.302585 / 200.0; // between two points of a scan
    constexpr double Step_log = 0.05;
    std::vector<double> grid;
    for (std::size_t i = 0; i < scan.size(); ++i) {
        const bool isClose = i > 0 && std::log(scan[i] / scan[i - 1]) < 0.8 * Usual_log;
        const bool isEnd = i + 2 >= scan.size(); // the Nyquist frequency and the point before
        if (grid.empty() || isClose || isEnd || std::log(scan[i] / grid.back()) >= Step_log) {
            grid.push_back(scan[i]);
        }
    }
    return grid;
}

/// Zero of a function whose values at the ends have opposite signs, in the logarithm of the frequency:
/// regula falsi that halves the end that stays (Illinois).
template <typename Function>
double zeroBetween(Function function, double low_log, double lowValue, double high_log, double highValue) {
    constexpr int MostRounds = 60;
    double at_log = high_log;
    int stayed = 0;
    for (int i = 0; i < MostRounds && std::abs(high_log - low_log) > 4e-16 * std::abs(high_log) + 1e-15;
         ++i) {
        const double before_log = at_log;
        at_log = (low_log * highValue - high_log * lowValue) / (highValue - lowValue);
        if (!(at_log > low_log && at_log < high_log)) {
            at_log = 0.5 * (low_log + high_log);
        }
        const double value = function(at_log);
        if (value == 0.0 || (i > 0 && std::abs(at_log - before_log) < 1e-13)) {
            break;
        }
        if ((value < 0.0) == (lowValue < 0.0)) {
            low_log = at_log;
            lowValue = value;
            highValue *= stayed == 1 ? 0.5 : 1.0;
            stayed = 1;
        } else {
            high_log = at_log;
            highValue = value;
            lowValue *= stayed == -1 ? 0.5 : 1.0;
            stayed = -1;
        }
    }
    return at_log;
}

/// Smallest value near three points whose middle one is the least: the vertex of their parabola, again and
/// again. A minimum is known to the square of its place.
template <typename Function>
double leastBetween(Function function, std::array<double, 3> x, std::array<double, 3> y) {
    for (int i = 0; i < 12; ++i) {
        const double left = (x[1] - x[0]) * (y[1] - y[2]);
        const double right = (x[1] - x[2]) * (y[1] - y[0]);
        const double vertex = x[1] - 0.5 * ((x[1] - x[0]) * left - (x[1] - x[2]) * right) / (left - right);
        if (!(vertex > x[0] && vertex < x[2]) || std::abs(vertex - x[1]) < 1e-7) {
            break;
        }
        const double value = function(vertex);
        const bool isLeft = vertex < x[1];
        if (value < y[1]) {
            (isLeft ? x[2] : x[0]) = x[1];
            (isLeft ? y[2] : y[0]) = y[1];
            x[1] = vertex;
            y[1] = value;
        } else {
            (isLeft ? x[0] : x[2]) = vertex;
            (isLeft ? y[0] : y[2]) = value;
        }
    }
    return y[1];
}

bool changesSign(double first, double second) {
    return (first < 0.0 && second >= 0.0) || (first > 0.0 && second <= 0.0);
}

/// All lanes over one grid.
class BatchScan {
public:
    explicit BatchScan(const LoopBatch& batch) : m_batch(batch), m_verdicts(batch.size()) {
        m_leastAt.assign(batch.size(), 0);
        m_least.assign(batch.size(), HUGE_VAL);
        m_isFar.assign(batch.size(), false);
    }

    std::vector<BatchVerdict> run() {
        const auto first = *sampledOpenLoop(m_batch.plant(0), m_batch.gains(), m_batch.timing());
        m_grid = thinned(frequencyScan(firstByRoots()).frequency_rad_s);
        for (std::size_t j = 0; j < m_grid.size(); ++j) {
            look(j);
        }
        const bool isFirstStable = poleRadius(first) < 1.0;
        for (std::size_t lane = 0; lane < m_batch.size(); ++lane) {
            m_verdicts[lane].margins.modulusMargin = std::sqrt(refinedLeast(lane));
            m_verdicts[lane].isStable = isLikeFirst(lane) ? isFirstStable : isStable(lane);
        }
        return std::move(m_verdicts);
    }

private:
    /// Coefficients of z would leave low frequencies out.
    DeltaSystem firstByRoots() const {
        FilteredLaw law;
        law.gains = m_batch.gains();
        return *deltaOpenLoop(m_batch.plant(0), law, m_batch.timing());
    }

    void look(std::size_t j) {
        const Complex common = m_batch.common(m_grid[j]);
        m_batch.rest(m_grid[j], m_real, m_imaginary);
        std::swap(m_level, m_levelBefore);
        std::swap(m_height, m_heightBefore);
        m_along = common.real() * m_real - common.imag() * m_imaginary;
        m_height = common.real() * m_imaginary + common.imag() * m_real;
        m_level = m_along * m_along + m_height * m_height - 1.0;
        m_distance = m_level + 2.0 + 2.0 * m_along; // |1 + L|^2
        const double along0 = m_along[0];
        const double height0 = m_height[0];
        m_apart = (m_along - along0).square() + (m_height - height0).square();
        const double near = 0.5 * m_distance[0]; // 0.7 of the way to -1
        const bool isNyquist = j + 1 == m_grid.size();
        for (std::size_t lane = 0; lane < m_batch.size(); ++lane) {
            const auto i = static_cast<Eigen::Index>(lane);
            if (m_distance[i] < m_least[lane]) {
                m_least[lane] = m_distance[i];
                m_leastAt[lane] = j;
            }
            m_isFar[lane] = m_isFar[lane] || m_apart[i] > near;
            if (j > 0 && changesSign(m_levelBefore[i], m_level[i])) {
                addGainCrossing(lane, j);
            }
            if (j > 0 && !isNyquist && changesSign(m_heightBefore[i], m_height[i])) {
                addPhaseCrossing(lane, j);
            }
            if (isNyquist && m_along[i] < 0.0) {
                take(lane, std::hypot(m_along[i], m_height[i]), m_grid[j]);
            }
        }
    }

    double log(std::size_t j) const { return std::log(m_grid[j]); }

    void addGainCrossing(std::size_t lane, std::size_t j) {
        const auto i = static_cast<Eigen::Index>(lane);
        const auto level = [&](double at_log) {
            return std::log(std::norm(m_batch.loop(lane, std::exp(at_log))));
        };
        const double frequency_rad_s = std::exp(
            zeroBetween(level, log(j - 1), std::log1p(m_levelBefore[i]), log(j), std::log1p(m_level[i])));
        const double margin_rad = std::arg(-m_batch.loop(lane, frequency_rad_s));
        StabilityMargins& margins = m_verdicts[lane].margins;
        if (std::abs(radiansToDegrees(margin_rad)) < std::abs(margins.phaseMargin_deg)) {
            margins.phaseMargin_deg = radiansToDegrees(margin_rad);
            margins.gainCrossover_rad_s = frequency_rad_s;
        }
        const double turn_rad = margin_rad < 0.0 ? margin_rad + 2.0 * Pi : margin_rad;
        margins.delayMargin_s = std::min(margins.delayMargin_s, turn_rad / frequency_rad_s);
    }

    void addPhaseCrossing(std::size_t lane, std::size_t j) {
        const auto i = static_cast<Eigen::Index>(lane);
        const auto height = [&](double at_log) { return m_batch.loop(lane, std::exp(at_log)).imag(); };
        const double frequency_rad_s =
            std::exp(zeroBetween(height, log(j - 1), m_heightBefore[i], log(j), m_height[i]));
        const Complex value = m_batch.loop(lane, frequency_rad_s);
        if (value.real() < 0.0 && std::abs(value.imag()) < 1e-3 * std::abs(value)) {
            take(lane, std::abs(value), frequency_rad_s);
        }
    }

    void take(std::size_t lane, double magnitude_ratio, double frequency_rad_s) {
        StabilityMargins& margins = m_verdicts[lane].margins;
        if (std::abs(std::log(magnitude_ratio)) < std::abs(std::log(margins.gainMargin_ratio))) {
            margins.gainMargin_ratio = 1.0 / magnitude_ratio;
            margins.phaseCrossover_rad_s = frequency_rad_s;
        }
    }

    double refinedLeast(std::size_t lane) const {
        const std::size_t at = m_leastAt[lane];
        if (at == 0 || at + 1 == m_grid.size()) {
            return m_least[lane];
        }
        const auto distance = [&](double at_log) {
            return std::norm(1.0 + m_batch.loop(lane, std::exp(at_log)));
        };
        const std::array x = {log(at - 1), log(at), log(at + 1)};
        return leastBetween(distance, x, {distance(x[0]), m_least[lane], distance(x[2])});
    }

    /// Where this loop stays nearer to that of the first lane than that is to -1, both turn around -1 alike
    /// (Rouche), and both are stable or none; as long as none has another pole on the circle, which a motor
    /// without damping has. That is seen at the points of the grid: between them a loop moves by some
    /// hundredths, so that neither may come as near to -1.
    bool isLikeFirst(std::size_t lane) const {
        constexpr double LeastModulus = 0.15;
        return !m_isFar[lane] && m_batch.plant(lane).dampingRate_1_s > 0.0 &&
               m_batch.plant(0).dampingRate_1_s > 0.0 && m_verdicts[0].margins.modulusMargin > LeastModulus &&
               m_verdicts[lane].margins.modulusMargin > LeastModulus;
    }

    /// What the poles say.
    bool isStable(std::size_t lane) const {
        return poleRadius(*sampledOpenLoop(m_batch.plant(lane), m_batch.gains(), m_batch.timing())) < 1.0;
    }

    const LoopBatch& m_batch;
    std::vector<double> m_grid;
    std::vector<BatchVerdict> m_verdicts;
    std::vector<std::size_t> m_leastAt;
    std::vector<double> m_least;
    std::vector<bool> m_isFar;
    Eigen::ArrayXd m_real, m_imaginary, m_along, m_apart, m_distance;
    Eigen::ArrayXd m_level, m_levelBefore; ///< |L|^2 - 1
    Eigen::ArrayXd m_height, m_heightBefore;
};

} // namespace

std::vector<BatchVerdict> judgeBatch(const LoopBatch& batch) {
    return BatchScan(batch).run();
}

} // namespace halbench::control
