#pragma once

#include "control/base/sample_block.h"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace halbench::devices {

/// Hands blocks from the connection's thread to the window's: `push` on the one, `take` once per frame on the
/// other. Never makes the connection wait: when the window does not come to take them, blocks are left out of
/// the display and counted; the recorder has its own way and is not concerned.
class DisplayInbox {
public:
    explicit DisplayInbox(std::size_t capacity_rows) : m_capacity_rows(capacity_rows) {}

    void push(TimedBlock block);
    /// Everything since the last call, in order.
    std::vector<TimedBlock> take();
    /// Rows that were left out because the inbox was full.
    std::uint64_t skippedRows() const;

private:
    const std::size_t m_capacity_rows;
    mutable std::mutex m_mutex;
    std::vector<TimedBlock> m_blocks;
    std::size_t m_rows = 0;
    std::uint64_t m_skippedRows = 0;
};

} // namespace halbench::devices
