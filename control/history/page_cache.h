#pragma once

#include "control/base/page_store.h"

#include <array>
#include <cstdint>
#include <list>
#include <memory>
#include <unordered_map>
#include <unordered_set>

namespace halbench::control {

/// Parts of pages that were read back, the latest ones: bounded in memory.
class PageCache {
public:
    PageCache(std::shared_ptr<PageStore> store, std::size_t budget_bytes);

    PageStore& store() { return *m_store; }
    /// A part of `bytes` octets; nullptr when the store cannot give it as it was written. Valid until the
    /// next call.
    const std::byte* part(PageStore::Page page, std::size_t part, std::size_t bytes);
    /// Whether part() answers without waiting. In a glance what is not here is asked for, and false; outside
    /// of one it is always true, because part() waits.
    bool isAtHand(PageStore::Page page, std::size_t part, std::size_t bytes);
    /// What was read of pages that are released stays until there is no room, or until this.
    void clear();

    /// From now on nothing is waited for (control/history/sample_history.h, Glance).
    void beginGlance();
    void endGlance() { m_isGlancing = false; }
    bool isGlancing() const { return m_isGlancing; }
    /// Whether everything that was needed since beginGlance() was at hand.
    bool isGlanceWhole() const { return m_isGlanceWhole; }
    /// Takes over what was asked for and has come. Whether there was anything. Ends a round: of one frame,
    /// all of whose questions must be answered from the cache together.
    bool collect();

    std::size_t bytes() const { return m_bytes; }
    /// Parts that could not be read back; each is asked for once.
    std::uint64_t damagedParts() const { return m_damagedParts; }

private:
    struct Key {
        PageStore::Page page;
        std::size_t part;
        bool operator==(const Key&) const = default;
    };
    struct Hash {
        std::size_t operator()(const Key& key) const {
            return static_cast<std::size_t>((key.page * 0x9E3779B97F4A7C15U) ^
                                            (key.part * 0xC2B2AE3D27D4EB4FU));
        }
    };
    struct Entry {
        Key key;
        std::unique_ptr<std::byte[]> octets; ///< none: damaged
        std::size_t bytes = 0;
        std::uint64_t round = 0; ///< the last that needed it
    };
    using Entries = std::list<Entry>; ///< the latest first

    const std::byte* load(const Key& key, std::size_t bytes);
    Entries::iterator insert(const Key& key, std::unique_ptr<std::byte[]> octets, std::size_t bytes);
    void touch(Entries::iterator entry);
    bool ask(const Key& key, std::size_t bytes);
    std::size_t mostPerRound_bytes() const { return 2 * m_budget_bytes; }
    void keepBudget();
    void drop(Entries::iterator entry);

    std::shared_ptr<PageStore> m_store;
    std::size_t m_budget_bytes;
    std::size_t m_bytes = 0;
    std::uint64_t m_damagedParts = 0;
    Entries m_entries;
    std::unordered_map<Key, Entries::iterator, Hash> m_index;
    std::unordered_set<Key, Hash> m_asked; ///< on their way
    std::uint64_t m_round = 0;             ///< number of collect()
    std::size_t m_round_bytes = 0;         ///< needed in it so far
    bool m_isGlancing = false;
    bool m_isGlanceWhole = true;
    /// What was asked for last: a curve asks for the same few parts many times in a row.
    std::array<std::pair<Key, const std::byte*>, 8> m_recent;
};

} // namespace halbench::control
