#include "control/history/page_cache.h"

#include <utility>

namespace halbench::control {
namespace {

/// However small the budget is: a question needs time, values and groups of two chunks at once.
constexpr std::size_t LeastEntries = 8;
constexpr PageStore::Page NoPage = ~PageStore::Page{0};

/// The first parts of a page are asked for in between those of its columns: they have places of their own.
std::size_t slotOf(std::size_t part) {
    return part < 4 ? part : 4 + part % 4;
}

} // namespace

PageCache::PageCache(std::shared_ptr<PageStore> store, std::size_t budget_bytes)
    : m_store(std::move(store)), m_budget_bytes(budget_bytes) {
    m_recent.fill({Key{NoPage, 0}, nullptr});
}

const std::byte* PageCache::part(PageStore::Page page, std::size_t part, std::size_t bytes) {
    const Key key{page, part};
    auto& recent = m_recent[slotOf(part)];
    if (recent.first == key) {
        return recent.second;
    }
    const std::byte* octets = load(key, bytes);
    if (m_asked.empty() || m_asked.count(key) == 0) {
        m_recent[slotOf(part)] = {key, octets};
    }
    return octets;
}

const std::byte* PageCache::load(const Key& key, std::size_t bytes) {
    if (const auto known = m_index.find(key); known != m_index.end()) {
        touch(known->second);
        return known->second->octets.get();
    }
    if (m_isGlancing && ask(key, bytes)) {
        return nullptr;
    }
    auto octets = std::make_unique_for_overwrite<std::byte[]>(bytes);
    if (!m_store->read(key.page, key.part, {octets.get(), bytes})) {
        octets.reset();
    }
    const std::byte* const first = insert(key, std::move(octets), bytes)->octets.get();
    keepBudget();
    return first;
}

PageCache::Entries::iterator PageCache::insert(const Key& key, std::unique_ptr<std::byte[]> octets,
                                               std::size_t bytes) {
    if (octets == nullptr) {
        ++m_damagedParts;
        bytes = 0;
    }
    m_bytes += sizeof(Entry) + bytes;
    m_entries.push_front({key, std::move(octets), bytes, m_round});
    m_index[key] = m_entries.begin();
    return m_entries.begin();
}

/// It is needed now.
void PageCache::touch(Entries::iterator entry) {
    m_entries.splice(m_entries.begin(), m_entries, entry);
    if (std::exchange(entry->round, m_round) != m_round) {
        m_round_bytes += sizeof(Entry) + entry->bytes;
    }
}

/// False: it must be waited for. A picture (all questions of a round) that needs more than there is room for
/// stays coarse: what came for it would drive out what came before, which would be asked for again, and so
/// on.
bool PageCache::ask(const Key& key, std::size_t bytes) {
    if (m_asked.count(key) == 0 && m_round_bytes + sizeof(Entry) + bytes <= mostPerRound_bytes()) {
        if (!m_store->fetch(key.page, key.part, bytes)) {
            return false;
        }
        m_asked.insert(key);
        m_round_bytes += sizeof(Entry) + bytes;
    }
    m_isGlanceWhole = false;
    return true;
}

bool PageCache::isAtHand(PageStore::Page page, std::size_t part, std::size_t bytes) {
    const Key key{page, part};
    if (!m_isGlancing || m_recent[slotOf(part)].first == key) {
        return true;
    }
    if (const auto known = m_index.find(key); known != m_index.end()) {
        touch(known->second);
        return true;
    }
    return !ask(key, bytes);
}

void PageCache::beginGlance() {
    m_isGlancing = true;
    m_isGlanceWhole = true;
}

bool PageCache::collect() {
    std::vector<FetchedPart> parts = m_store->fetched();
    for (FetchedPart& fetched : parts) {
        const Key key{fetched.page, fetched.part};
        const bool wasAsked = m_asked.erase(key) > 0; // not by a history that was cleared since
        if (wasAsked && !fetched.isDropped && m_index.count(key) == 0) {
            insert(key, std::move(fetched.octets), fetched.bytes);
        }
    }
    keepBudget();
    ++m_round;
    m_round_bytes = 0;
    m_recent.fill({Key{NoPage, 0}, nullptr}); // so that what is needed again is seen to be
    return !parts.empty();
}

/// What this round and the one before needed stays.
void PageCache::keepBudget() {
    while (m_bytes > m_budget_bytes && m_entries.size() > LeastEntries &&
           (m_entries.back().round + 1 < m_round || m_round == 0 || m_bytes > mostPerRound_bytes())) {
        drop(std::prev(m_entries.end()));
    }
}

void PageCache::drop(Entries::iterator entry) {
    auto& recent = m_recent[slotOf(entry->key.part)];
    if (recent.first == entry->key) {
        recent = {Key{NoPage, 0}, nullptr};
    }
    m_bytes -= sizeof(Entry) + entry->bytes;
    m_index.erase(entry->key);
    m_entries.erase(entry);
}

void PageCache::clear() {
    while (!m_entries.empty()) {
        drop(m_entries.begin());
    }
    m_asked.clear();
}

} // namespace halbench::control
