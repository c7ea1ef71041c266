#include "control/history/sample_history.h"

#include <algorithm>

namespace halbench::control {
namespace {

/// From this share of the memory on rows go to the store; the rest is for those that wait there, while the
/// disk is slow.
constexpr double PutShare = 0.75;
/// Share of the memory for what was read back.
constexpr double CacheShare = 0.125;
/// Share of the memory for what stays there of rows that are in the store; beyond it the oldest are dropped.
constexpr double PagedShare = 0.5;

std::size_t shareOf(std::size_t bytes, double share) {
    return static_cast<std::size_t>(share * static_cast<double>(bytes));
}

} // namespace

void SampleHistory::setStore(std::shared_ptr<PageStore> store) {
    clear(); // chunks release their pages
    m_pages =
        store ? std::make_shared<PageCache>(std::move(store), shareOf(m_budget_bytes, CacheShare)) : nullptr;
}

std::size_t SampleHistory::bytes() const {
    std::size_t sum = m_pages ? m_pages->bytes() : 0;
    for (const auto& [number, stream] : m_streams) {
        sum += stream.track.bytes();
    }
    return sum;
}

std::size_t SampleHistory::pagedMemory() const {
    std::size_t sum = 0;
    for (const auto& [number, stream] : m_streams) {
        sum += stream.track.pagedChunks() * SampleChunk::pagedBytesFor(stream.layout->columns.size());
    }
    return sum;
}

std::uint64_t SampleHistory::pagedBytes() const {
    std::uint64_t sum = 0;
    for (const auto& [number, stream] : m_streams) {
        sum += stream.track.pagedChunks() * SampleChunk::Rows * sizeof(double) *
               (1 + stream.layout->columns.size());
    }
    return sum;
}

void SampleHistory::settle() {
    if (m_pages && m_pages->collect()) {
        ++m_revision;
    }
    keepBudget();
}

bool SampleHistory::isBusy() const {
    return m_pages && bytes() > shareOf(m_budget_bytes, 0.5 * (1.0 + PutShare)) &&
           std::any_of(m_streams.begin(), m_streams.end(),
                       [](const auto& entry) { return entry.second.track.waitingChunks() > 0; });
}

void SampleHistory::keepBudget() {
    if (m_pages) {
        for (auto& [number, stream] : m_streams) {
            stream.track.settle();
        }
        putOldest();
    }
    while (bytes() > m_budget_bytes || (m_pages && pagedMemory() > shareOf(m_budget_bytes, PagedShare))) {
        if (!dropOldest(false)) {
            return; // the newest chunk always stays
        }
    }
}

/// As much as is above the limit, without what waits in the store already.
void SampleHistory::putOldest() {
    std::size_t left = bytes();
    for (const auto& [number, stream] : m_streams) {
        left -= stream.track.waitingChunks() * SampleChunk::bytesFor(stream.layout->columns.size());
    }
    while (left > shareOf(m_budget_bytes, PutShare)) {
        Stream* oldest = nullptr;
        for (auto& [number, stream] : m_streams) {
            const auto own_s = stream.track.nextToPut_s();
            if (own_s && (oldest == nullptr || *own_s < *oldest->track.nextToPut_s())) {
                oldest = &stream;
            }
        }
        if (oldest == nullptr) {
            return;
        }
        const std::size_t columns = oldest->layout->columns.size();
        const std::size_t page = SampleChunk::detailBytesFor(columns);
        while (m_pages->store().room(page) == PageRoom::Full && dropOldest(true)) {
        }
        if (m_pages->store().room(page) != PageRoom::Free) {
            return;
        }
        oldest->track.putNext(m_pages);
        oldest->track.settle(); // a store may have it at once
        left -= SampleChunk::bytesFor(columns) - SampleChunk::pagedBytesFor(columns);
    }
}

/// Whether there was one to drop; `isPagedOnly`: one that takes room in the store.
bool SampleHistory::dropOldest(bool isPagedOnly) {
    auto oldest = m_streams.end();
    for (auto it = m_streams.begin(); it != m_streams.end(); ++it) {
        const SampleTrack& track = it->second.track;
        const bool isInUse = it == std::prev(m_streams.end()) && track.chunks() == 1;
        if (!isInUse && (oldest == m_streams.end() || track.begin_s() < oldest->second.track.begin_s())) {
            oldest = it;
        }
    }
    if (oldest == m_streams.end() || (isPagedOnly && oldest->second.track.pagedChunks() == 0)) {
        return false;
    }
    oldest->second.track.dropOldestChunk();
    if (oldest->second.track.isEmpty()) {
        for (auto& [name, places] : m_places) {
            std::erase_if(places, [&](const Place& place) { return place.stream == oldest->first; });
        }
        m_streams.erase(oldest);
    }
    return true;
}

} // namespace halbench::control
