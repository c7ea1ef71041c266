#pragma once

#include "control/base/sample_block.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace halbench::devices {

/// The newest rows of a stream in memory, so that a recording can begin before the moment in which it is
/// started. Bounded in time and in octets, the oldest blocks go first; a clock that starts again leaves only
/// what came since. What the link lost inside stays a gap. Belongs to one thread.
class HeldRows {
public:
    static constexpr std::size_t UsualBudget_bytes = std::size_t{256} << 20U;

    /// At least `length_s` of rows before the newest block, where so many came and the budget has room.
    explicit HeldRows(double length_s, std::size_t budget_bytes = UsualBudget_bytes)
        : m_length_s(length_s), m_budget_bytes(budget_bytes) {}

    void add(TimedBlock block);
    void clear();

    /// The rows from a time on, in order. Before the first of them nothing is missing.
    std::vector<TimedBlock> from(double begin_s) const;
    std::optional<double> oldest_s() const;
    std::optional<double> newest_s() const;
    std::size_t rows() const { return m_rows; }
    std::size_t bytes() const { return m_bytes; }

private:
    void dropOldest();

    double m_length_s;
    std::size_t m_budget_bytes;
    std::deque<TimedBlock> m_blocks; ///< none of them without rows
    std::size_t m_rows = 0;
    std::size_t m_bytes = 0;
    std::uint64_t m_lostBefore = 0; ///< told by blocks without rows since the last one
};

} // namespace halbench::devices
