#include "app/workbench/signals/stream_time_offsets.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace halbench::app {

namespace {

constexpr double Rounding_s = 1e-9; ///< of times of days, and far below any period

} // namespace

void StreamTimeOffsets::note(double begin_s, double shift_s) {
    while (!m_stretches.empty() && m_stretches.back().first > begin_s) { // of a history that was cleared
        m_stretches.pop_back();
    }
    if (std::abs(shift_s - newest()) > Rounding_s || m_stretches.empty()) {
        m_stretches.emplace_back(begin_s, shift_s);
    }
}

/// Before the first row the clock was that of the first row.
double StreamTimeOffsets::at(double time_s) const {
    const auto after =
        std::upper_bound(m_stretches.begin(), m_stretches.end(), time_s + Rounding_s,
                         [](double time, const auto& stretch) { return time < stretch.first; });
    if (m_stretches.empty()) {
        return 0.0;
    }
    return after == m_stretches.begin() ? after->second : std::prev(after)->second;
}

} // namespace halbench::app
