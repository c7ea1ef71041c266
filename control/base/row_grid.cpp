#include "control/base/row_grid.h"

#include <algorithm>
#include <cmath>

namespace halbench {

namespace {

constexpr std::uint64_t RowsOfPhase = 8; // until then the grid is not known well
constexpr double UnknownLongStep_ratio = 1.5;
constexpr double LongStep_ratio = 1.25; // shorter steps lose nothing, whatever the grid says
constexpr double Exact_ratio = 0.02;    // so near to whole periods only a loss comes ...
constexpr double ExactScatter_ratio =
    0.005; // ... where the board's timer stamps, and no task of a busy machine
constexpr double ScatterFading_ratio = 0.98; // fifty rows
constexpr double MostJitter_ratio = 0.75;    // of one step
constexpr double Jitter_ratio = 0.45;        // of a stamp, around its place
constexpr double CaughtUp_ratio = 0.9;       // late rows follow each other faster
constexpr double LeastGain = 0.125;          // of the phase: eight rows back
// Never a tie: stamps are whole numbers of some decimal unit.
constexpr double HalfPeriod_ratio = 0.5 + 1.0 / 3000.0;
constexpr double MostMissing = 1e15; // a gap beyond this is a broken clock; keeps the count a whole number

} // namespace

std::uint64_t rowsMissingAtChange(double step_s, double period_s) {
    if (!(period_s > 0.0) || !(step_s > 0.0)) {
        return 0;
    }
    const double places = std::ceil(step_s / period_s - HalfPeriod_ratio);
    return static_cast<std::uint64_t>(std::clamp(places - 1.0, 0.0, MostMissing));
}

bool RowGrid::isLongStep(double time_s) const {
    const double long_ratio = m_rows < RowsOfPhase ? UnknownLongStep_ratio : LongStep_ratio;
    return m_rows > 0 && m_period_s > 0.0 && time_s - m_last_s > long_ratio * m_period_s;
}

bool RowGrid::isExactLoss(double time_s) const {
    const double ahead = placesAhead(time_s);
    return m_scatter_ratio <= ExactScatter_ratio && std::abs(ahead - std::round(ahead)) <= Exact_ratio;
}

/// Rows that follow each other faster than a period catch up: they do not confirm the shift they have.
RowGrid::Shift RowGrid::leastShift(std::span<const double> next_s, std::size_t lookAhead) const {
    const double step = (next_s.front() - m_last_s) / m_period_s;
    Shift least{std::floor(step - 1.0 + MostJitter_ratio), 0};
    const std::size_t known = std::min(next_s.size(), MostAhead);
    for (std::size_t i = 0; i < known && least.rowsBehind < lookAhead && least.missing > 0.0; ++i) {
        const double missing = std::round(placesAhead(next_s[i])) - 1.0 - static_cast<double>(i);
        const bool isCatchingUp = i > 0 && next_s[i] - next_s[i - 1] < CaughtUp_ratio * m_period_s;
        if (missing < least.missing) {
            least.rowsBehind = 0;
        } else if (i > 0 && !isCatchingUp) {
            ++least.rowsBehind;
        }
        least.missing = std::min(missing, least.missing);
    }
    return least;
}

std::uint64_t RowGrid::missingBefore(std::span<const double> next_s, bool isLossSure) const {
    if (next_s.empty() || !isLongStep(next_s.front())) {
        return 0;
    }
    const Shift least = leastShift(next_s, LookAhead);
    if (!isLossSure && !isExactLoss(next_s.front()) && least.rowsBehind == 0) {
        return 0;
    }
    return static_cast<std::uint64_t>(std::clamp(least.missing, 0.0, MostMissing));
}

bool RowGrid::isInDoubt(std::span<const double> next_s, std::size_t lookAhead) const {
    if (next_s.empty() || !isLongStep(next_s.front()) || isExactLoss(next_s.front())) {
        return false;
    }
    const Shift least = leastShift(next_s, lookAhead);
    return least.missing > 0.0 && least.rowsBehind < lookAhead && next_s.size() < MostAhead;
}

void RowGrid::take(double time_s, std::uint64_t missing) {
    if (missing > 0) {
        m_isLate = false;
    } else if (isLongStep(time_s) && placesAhead(time_s) - 1.0 > Jitter_ratio) {
        m_isLate = true;
    } else if (time_s - m_last_s > CaughtUp_ratio * m_period_s) {
        m_isLate = false;
    }
    const double place_s =
        m_rows == 0 ? time_s : m_place_s + (static_cast<double>(missing) + 1.0) * m_period_s;
    ++m_rows;
    if (m_period_s > 0.0 && !m_isLate) {
        m_scatter_ratio =
            std::max(ScatterFading_ratio * m_scatter_ratio, std::abs(time_s - place_s) / m_period_s);
    }
    const double gain = m_isLate ? 0.0 : std::max(LeastGain, 1.0 / static_cast<double>(m_rows));
    const double most_s = std::max(m_period_s, 0.0);
    m_place_s = place_s + gain * std::clamp(time_s - place_s, -most_s, most_s);
    m_last_s = time_s;
}

} // namespace halbench
