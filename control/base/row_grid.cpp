#include "control/base/row_grid.h"

#include <algorithm>
#include <cmath>

namespace halbench {

namespace {

constexpr std::uint64_t RowsOfPhase = 8; // until then the grid is not known well
constexpr double UnknownLongStep_ratio = 1.5;
constexpr double LongStep_ratio = 1.25;   // shorter steps lose nothing, whatever the grid says
constexpr double Exact_ratio = 0.02;      // so near to whole periods only a loss comes
constexpr double MostJitter_ratio = 0.75; // of one step
constexpr double LeastGain = 0.125;       // of the phase: eight rows back
constexpr double MostMissing = 1e15; // a gap beyond this is a broken clock; keeps the count a whole number

} // namespace

bool RowGrid::isLongStep(double time_s) const {
    const double long_ratio = m_rows < RowsOfPhase ? UnknownLongStep_ratio : LongStep_ratio;
    return m_rows > 0 && m_period_s > 0.0 && time_s - m_last_s > long_ratio * m_period_s;
}

std::uint64_t RowGrid::missingBefore(std::span<const double> next_s) const {
    if (next_s.empty() || !isLongStep(next_s.front())) {
        return 0;
    }
    const double step = (next_s.front() - m_last_s) / m_period_s;
    double missing = std::floor(step - 1.0 + MostJitter_ratio);
    const std::size_t known = std::min(next_s.size(), LookAhead + 1);
    for (std::size_t i = 0; i < known; ++i) {
        missing = std::min(missing, std::round(placesAhead(next_s[i])) - 1.0 - static_cast<double>(i));
    }
    return static_cast<std::uint64_t>(std::clamp(missing, 0.0, MostMissing));
}

bool RowGrid::isInDoubt(double time_s) const {
    const double ahead = isLongStep(time_s) ? placesAhead(time_s) : 1.0;
    return std::round(ahead) > 1.0 && std::abs(ahead - std::round(ahead)) > Exact_ratio;
}

void RowGrid::take(double time_s, std::uint64_t missing) {
    const double place_s =
        m_rows == 0 ? time_s : m_place_s + (static_cast<double>(missing) + 1.0) * m_period_s;
    ++m_rows;
    const double gain = std::max(LeastGain, 1.0 / static_cast<double>(m_rows));
    const double most_s = std::max(m_period_s, 0.0);
    m_place_s = place_s + gain * std::clamp(time_s - place_s, -most_s, most_s);
    m_last_s = time_s;
}

} // namespace halbench
