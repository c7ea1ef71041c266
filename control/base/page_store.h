#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace halbench {

/// What is to be kept: parts that are read back one by one.
struct PageContent {
    std::vector<std::span<const std::byte>> parts;
    std::shared_ptr<const void> owner; ///< keeps the parts alive and unchanged until the page is kept or lost

    std::size_t bytes() const {
        std::size_t sum = 0;
        for (const auto& part : parts) {
            sum += part.size();
        }
        return sum;
    }
};

enum class PageState {
    Waiting, ///< taken, not written yet: its owner is still needed
    Kept,    ///< can be read back
    Lost     ///< could not be written
};

enum class PageRoom {
    Free,
    Busy, ///< more waits to be written than it should; ask again later
    Full, ///< release old pages
    None  ///< it failed and takes no more
};

/// A part that was read beside the thread that asked for it.
struct FetchedPart {
    std::uint64_t page = 0;
    std::size_t part = 0;
    std::size_t bytes = 0;
    std::unique_ptr<std::byte[]> octets; ///< none: it cannot be had as it was written, or
    bool isDropped = false;              ///< it was not read, because too much was asked for after it
};

/// A place outside of memory for what is rarely needed (devices/history/page_file.h: a file). Belongs to
/// the thread that puts; what it does on others is its own affair.
class PageStore {
public:
    using Page = std::uint64_t;

    virtual ~PageStore() = default;

    /// Whether put() takes a page of this size.
    virtual PageRoom room(std::size_t bytes) const = 0;
    /// Precondition: room() is free. Returns at once. The number of a page is never used again.
    virtual Page put(PageContent content) = 0;
    virtual PageState state(Page page) const = 0;
    /// All of one part of a page that is kept. False when it cannot be had as it was written.
    virtual bool read(Page page, std::size_t part, std::span<std::byte> octets) = 0;
    /// Begins to read such a part and returns at once; fetched() tells when it is there. False: this store
    /// cannot, use read().
    virtual bool fetch(Page, std::size_t /*part*/, std::size_t /*bytes*/) { return false; }
    /// What was fetched since the last call.
    virtual std::vector<FetchedPart> fetched() { return {}; }
    /// The page is not needed any more, in whatever state it is.
    virtual void release(Page page) = 0;
};

} // namespace halbench
