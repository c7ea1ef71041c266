#include "devices/acquisition/display_inbox.h"

#include <utility>

namespace halbench::devices {

void DisplayInbox::push(TimedBlock block) {
    const std::lock_guard lock(m_mutex);
    if (m_rows + block.rows() > m_capacity_rows) {
        m_skippedRows += block.rows();
        return;
    }
    m_rows += block.rows();
    m_blocks.push_back(std::move(block));
}

std::vector<TimedBlock> DisplayInbox::take() {
    const std::lock_guard lock(m_mutex);
    m_rows = 0;
    return std::exchange(m_blocks, {});
}

std::uint64_t DisplayInbox::skippedRows() const {
    const std::lock_guard lock(m_mutex);
    return m_skippedRows;
}

} // namespace halbench::devices
