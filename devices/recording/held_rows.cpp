#include "devices/recording/held_rows.h"

#include <algorithm>
#include <utility>

namespace halbench::devices {

namespace {

std::size_t bytesOf(const SampleBlock& block) {
    return (block.time_s.size() + block.values.size()) * sizeof(double);
}

/// The rows of a block from one on.
SampleBlockPtr cutAt(const SampleBlock& block, std::size_t row) {
    auto rest = std::make_shared<SampleBlock>();
    const auto columns = static_cast<std::ptrdiff_t>(block.layout->columns.size());
    const auto first = static_cast<std::ptrdiff_t>(row);
    rest->layout = block.layout;
    rest->time_s.assign(block.time_s.begin() + first, block.time_s.end());
    rest->values.assign(block.values.begin() + first * columns, block.values.end());
    rest->hostArrival_s = block.hostArrival_s;
    return rest;
}

} // namespace

void HeldRows::add(TimedBlock block) {
    if (block.rows() == 0) {
        m_lostBefore += block.block->lostRows;
        return;
    }
    if (m_lostBefore > 0) {
        auto later = std::make_shared<SampleBlock>(*block.block);
        later->lostRows += std::exchange(m_lostBefore, 0);
        block.block = std::move(later);
    }
    if (newest_s() && block.begin_s() <= *newest_s()) {
        clear();
    }
    // An event in this block may lie right behind the row before it.
    const double needed_s = newest_s().value_or(block.begin_s()) - m_length_s;
    m_rows += block.rows();
    m_bytes += bytesOf(*block.block);
    m_blocks.push_back(std::move(block));
    while (m_blocks.size() > 1 && (m_blocks.front().end_s() < needed_s || m_bytes > m_budget_bytes)) {
        dropOldest();
    }
}

void HeldRows::dropOldest() {
    m_rows -= m_blocks.front().rows();
    m_bytes -= bytesOf(*m_blocks.front().block);
    m_blocks.pop_front();
}

void HeldRows::clear() {
    m_blocks.clear();
    m_rows = 0;
    m_bytes = 0;
    m_lostBefore = 0;
}

std::vector<TimedBlock> HeldRows::from(double begin_s) const {
    std::vector<TimedBlock> blocks;
    for (const TimedBlock& block : m_blocks) {
        if (block.end_s() < begin_s) {
            continue;
        }
        if (!blocks.empty()) {
            blocks.push_back(block);
            continue;
        }
        const auto& times_s = block.block->time_s;
        const auto first = std::partition_point(
            times_s.begin(), times_s.end(), [&](double time_s) { return time_s + block.shift_s < begin_s; });
        blocks.push_back(
            {cutAt(*block.block, static_cast<std::size_t>(first - times_s.begin())), block.shift_s});
    }
    return blocks;
}

std::optional<double> HeldRows::oldest_s() const {
    return m_blocks.empty() ? std::nullopt : std::optional(m_blocks.front().begin_s());
}

std::optional<double> HeldRows::newest_s() const {
    return m_blocks.empty() ? std::nullopt : std::optional(m_blocks.back().end_s());
}

} // namespace halbench::devices
