#include "control/signals/page_cache.h"

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
    m_recent[slotOf(part)] = {key, octets};
    return octets;
}

const std::byte* PageCache::load(const Key& key, std::size_t bytes) {
    if (const auto known = m_index.find(key); known != m_index.end()) {
        m_entries.splice(m_entries.begin(), m_entries, known->second);
        return known->second->octets.get();
    }
    Entry entry{key, std::make_unique_for_overwrite<std::byte[]>(bytes), bytes};
    if (!m_store->read(key.page, key.part, {entry.octets.get(), bytes})) {
        entry.octets.reset();
        entry.bytes = 0;
        ++m_damagedParts;
    }
    m_bytes += sizeof(Entry) + entry.bytes;
    m_entries.push_front(std::move(entry));
    m_index[key] = m_entries.begin();
    keepBudget();
    return m_entries.front().octets.get();
}

void PageCache::keepBudget() {
    while (m_bytes > m_budget_bytes && m_entries.size() > LeastEntries) {
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
}

} // namespace halbench::control
