#pragma once

#include "control/base/page_store.h"

#include <cstring>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace halbench::control {

/// A store in memory: keeps at once, or when it is told to; fails as it is told; fetches when it is told.
class MemoryPages final : public PageStore {
public:
    PageRoom room(std::size_t bytes) const override {
        if (hasFailed) {
            return PageRoom::None;
        }
        return bytesKept() + bytes > capacity_bytes ? PageRoom::Full : PageRoom::Free;
    }
    Page put(PageContent content) override {
        const Page page = m_next++;
        m_pages[page].first = std::move(content);
        if (keepsAtOnce) {
            keepAll();
        }
        return page;
    }
    PageState state(Page page) const override {
        if (lost.count(page) > 0) {
            return PageState::Lost;
        }
        return m_pages.at(page).second.empty() ? PageState::Waiting : PageState::Kept;
    }
    bool read(Page page, std::size_t part, std::span<std::byte> octets) override {
        ++reads;
        const std::vector<std::byte>& kept = m_pages.at(page).second.at(part);
        if (damaged.count(page) > 0 || kept.size() != octets.size()) {
            return false;
        }
        std::memcpy(octets.data(), kept.data(), kept.size());
        return true;
    }
    bool fetch(Page page, std::size_t part, std::size_t bytes) override {
        if (canFetch) {
            FetchedPart wanted;
            wanted.page = page;
            wanted.part = part;
            wanted.bytes = bytes;
            m_asked.push_back(std::move(wanted));
        }
        return canFetch;
    }
    std::vector<FetchedPart> fetched() override { return std::exchange(m_fetched, {}); }
    void release(Page page) override { m_pages.erase(page); }

    /// What was asked for is there, or given up.
    void deliver(bool isDropped = false) {
        for (FetchedPart& part : m_asked) {
            auto octets = std::make_unique<std::byte[]>(part.bytes);
            part.isDropped = isDropped || m_pages.count(part.page) == 0;
            if (!part.isDropped && read(part.page, part.part, {octets.get(), part.bytes})) {
                part.octets = std::move(octets);
            }
            m_fetched.push_back(std::move(part));
        }
        m_asked.clear();
    }
    std::size_t asked() const { return m_asked.size(); }

    /// Everything that waits becomes kept; its owner is let go.
    void keepAll() {
        for (auto& [page, kept] : m_pages) {
            if (kept.second.empty() && lost.count(page) == 0) {
                for (const auto& part : kept.first.parts) {
                    kept.second.emplace_back(part.begin(), part.end());
                }
                kept.first = {};
            }
        }
    }
    std::size_t bytesKept() const {
        std::size_t sum = 0;
        for (const auto& [page, kept] : m_pages) {
            for (const auto& part : kept.second) {
                sum += part.size();
            }
        }
        return sum;
    }
    std::size_t pages() const { return m_pages.size(); }

    bool keepsAtOnce = true;
    bool hasFailed = false;
    std::size_t capacity_bytes = ~std::size_t{0};
    std::set<Page> lost;
    std::set<Page> damaged;
    std::size_t reads = 0;
    bool canFetch = false;

private:
    Page m_next = 0;
    std::vector<FetchedPart> m_asked;
    std::vector<FetchedPart> m_fetched;
    std::map<Page, std::pair<PageContent, std::vector<std::vector<std::byte>>>> m_pages;
};

} // namespace halbench::control
