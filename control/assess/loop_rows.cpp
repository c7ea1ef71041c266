#include "control/assess/loop_rows.h"

#include "control/base/assert.h"

#include <cmath>

namespace halbench::control {
namespace {

constexpr double Tick_s = 1e-3;

} // namespace

bool isWholeMilliseconds(double period_s) {
    constexpr double Rounding_ratio = 1e-12; // a period that went through text is as whole as it was
    const double whole_s = std::round(period_s / Tick_s) / 1000.0;
    return whole_s > 0.0 && std::fabs(period_s - whole_s) <= Rounding_ratio * whole_s;
}

LoopRows::LoopRows(double period_s) {
    HB_ASSERT(period_s > 0.0);
    m_isMilliseconds = isWholeMilliseconds(period_s);
    m_perPeriod =
        m_isMilliseconds ? std::lround(period_s / Tick_s) : static_cast<long>(std::ceil(period_s / Tick_s));
    m_period_s = period_s;
    m_interval_s = m_isMilliseconds ? Tick_s : period_s / static_cast<double>(m_perPeriod);
}

// Counted from the period before, so that no rounding grows over the rows.
double LoopRows::time_s(long row) const {
    return m_isMilliseconds ? static_cast<double>(row) / 1000.0
                            : static_cast<double>(row / m_perPeriod) * m_period_s +
                                  static_cast<double>(row % m_perPeriod) * m_interval_s;
}

} // namespace halbench::control
