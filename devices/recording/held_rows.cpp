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

void HeldRows::add(SampleBlockPtr block) {
    if (block->rows() == 0) {
        m_lostBefore += block->lostRows;
        return;
    }
    if (m_lostBefore > 0) {
        auto later = std::make_shared<SampleBlock>(*block);
        later->lostRows += std::exchange(m_lostBefore, 0);
        block = std::move(later);
    }
    if (newest_s() && block->time_s.front() <= *newest_s()) {
        clear();
    }
    // An event in this block may lie right behind the row before it.
    const double needed_s = newest_s().value_or(block->time_s.front()) - m_length_s;
    m_rows += block->rows();
    m_bytes += bytesOf(*block);
    m_blocks.push_back(std::move(block));
    while (m_blocks.size() > 1 && (m_blocks.front()->time_s.back() < needed_s || m_bytes > m_budget_bytes)) {
        dropOldest();
    }
}

void HeldRows::dropOldest() {
    m_rows -= m_blocks.front()->rows();
    m_bytes -= bytesOf(*m_blocks.front());
    m_blocks.pop_front();
}

void HeldRows::clear() {
    m_blocks.clear();
    m_rows = 0;
    m_bytes = 0;
    m_lostBefore = 0;
}

std::vector<SampleBlockPtr> HeldRows::from(double begin_s) const {
    std::vector<SampleBlockPtr> blocks;
    for (const SampleBlockPtr& block : m_blocks) {
        if (block->time_s.back() < begin_s) {
            continue;
        }
        if (!blocks.empty()) {
            blocks.push_back(block);
            continue;
        }
        const auto first = std::lower_bound(block->time_s.begin(), block->time_s.end(), begin_s);
        blocks.push_back(cutAt(*block, static_cast<std::size_t>(first - block->time_s.begin())));
    }
    return blocks;
}

std::optional<double> HeldRows::oldest_s() const {
    return m_blocks.empty() ? std::nullopt : std::optional(m_blocks.front()->time_s.front());
}

std::optional<double> HeldRows::newest_s() const {
    return m_blocks.empty() ? std::nullopt : std::optional(m_blocks.back()->time_s.back());
}

} // namespace halbench::devices
