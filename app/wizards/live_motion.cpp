#include "app/wizards/live_motion.h"

#include <cmath>

namespace halbench::app {

void LiveMotion::take(const SampleBlock& block) {
    if (block.layout->indexOf("field.0.r") < 0) {
        return;
    }
    const std::lock_guard lock(m_mutex);
    m_rows.append(block);
}

Recording LiveMotion::rows() const {
    const std::lock_guard lock(m_mutex);
    return m_rows;
}

double LiveMotion::elapsed_s() const {
    const std::lock_guard lock(m_mutex);
    return m_rows.rows() == 0 ? 0.0 : m_rows.time_s.back() - m_rows.time_s.front();
}

std::optional<double> LiveMotion::latest(const std::string& signal) const {
    const std::lock_guard lock(m_mutex);
    const int column = m_rows.rows() == 0 ? -1 : m_rows.layout->indexOf(signal);
    if (column < 0) {
        return std::nullopt;
    }
    const std::size_t width = m_rows.layout->columns.size();
    const double value = m_rows.values[(m_rows.rows() - 1) * width + static_cast<std::size_t>(column)];
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace halbench::app
