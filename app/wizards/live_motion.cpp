#include "app/wizards/live_motion.h"

#include <Eigen/Geometry>
#include <array>

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

std::optional<Eigen::Matrix3d> LiveMotion::orientation() const {
    const std::lock_guard lock(m_mutex);
    if (m_rows.rows() == 0) {
        return std::nullopt;
    }
    constexpr std::array Names = {"orientation.w", "orientation.x", "orientation.y", "orientation.z"};
    std::array<double, 4> q{};
    const std::size_t width = m_rows.layout->columns.size();
    for (std::size_t i = 0; i < q.size(); ++i) {
        const int column = m_rows.layout->indexOf(Names[i]);
        if (column < 0) {
            return std::nullopt;
        }
        q[i] = m_rows.values[(m_rows.rows() - 1) * width + static_cast<std::size_t>(column)];
    }
    return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

} // namespace halbench::app
