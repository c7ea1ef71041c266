#pragma once

#include "control/base/page_store.h"
#include "control/base/result.h"
#include "devices/history/page_disk.h"

#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <thread>
#include <unordered_map>

namespace halbench::devices {

struct PageFileConfig {
    std::string folder;                                         ///< made when the first page comes
    std::uint64_t limit_bytes = std::uint64_t{12} * 1000000000; ///< on the disk, and waiting to go there
    std::uint64_t spare_bytes = std::uint64_t{4} << 30;         ///< of the disk, which stay free for others
    std::uint64_t segment_bytes = std::uint64_t{128} << 20;
    std::size_t waiting_bytes = std::size_t{64} << 20; ///< in memory, to be written
};

/// Pages in files without a name, which go when the program ends, however it ends. A file is as long as a
/// segment and goes when all of its pages are released, so that room comes back in the order of time. Each
/// part has a checksum: what reads back otherwise than it was written is no answer.
///
/// The disk being full, or the limit reached, is ordinary: room() says so until pages are released. Any other
/// failure ends writing for good; what was written can still be read.
///
/// Threads: one for the owner, who puts, reads and releases; writing and fetching run on one of their own
/// each.
class PageFile final : public PageStore {
public:
    explicit PageFile(PageFileConfig config, PageDisk disk = realPageDisk());
    ~PageFile() override; ///< what waits is not written any more

    PageRoom room(std::size_t bytes) const override;
    Page put(PageContent content) override;
    PageState state(Page page) const override;
    bool read(Page page, std::size_t part, std::span<std::byte> octets) override;
    bool fetch(Page page, std::size_t part, std::size_t bytes) override;
    std::vector<FetchedPart> fetched() override;
    void release(Page page) override;

    /// From now on. Above a smaller one there is no room until pages are released; what is written stays
    /// readable.
    void setLimit_bytes(std::uint64_t limit_bytes);
    std::uint64_t limit_bytes() const;
    /// On the disk, released or not.
    std::uint64_t bytes() const;
    /// What the user should know: writing or reading failed, or the disk is full before the limit is reached.
    /// The first of it stays. Errors: FileSystem.
    std::optional<Error> trouble() const;
    /// Until everything that waits is written, lost or has no room.
    void waitUntilIdle();
    /// Until everything that is being fetched is there.
    void waitUntilFetched();

private:
    struct Segment {
        int handle = -1;
        std::uint64_t length = 0; ///< written
        std::size_t pages = 0;    ///< not released
        std::size_t readers = 0;  ///< fetches that are at it
    };
    struct Place {
        std::shared_ptr<Segment> segment; ///< none: waiting or lost
        std::uint64_t offset = 0;
        std::vector<std::uint32_t> ends; ///< of the parts, within the page
        bool isLost = false;
    };
    struct Order {
        Page page = 0;
        PageContent content;
        std::size_t bytes = 0;
    };
    struct Stretch { ///< a part with its checksum, in a file
        std::shared_ptr<Segment> segment;
        std::uint64_t offset = 0;
    };

    void run();
    void serveFetches();
    void fetchNext(std::unique_lock<std::mutex>& lock);
    std::optional<Stretch> stretchOf(Page page, std::size_t part, std::size_t bytes) const;
    bool readPart(const Stretch& stretch, const FetchedPart& part, std::vector<std::byte>& text);
    void reportUnread(int cause);
    bool canWrite() const;
    void writeNext(std::unique_lock<std::mutex>& lock);
    bool openSegment(std::unique_lock<std::mutex>& lock, std::size_t bytes);
    void onWriteFailure(int cause);
    void closeUnused();
    void report(std::string message, std::string hint);

    const PageFileConfig m_config; ///< limit and segments: at first
    const PageDisk m_disk;
    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    std::unordered_map<Page, Place> m_places;
    std::deque<Order> m_orders;
    std::vector<std::shared_ptr<Segment>> m_segments; ///< the last is written to
    Page m_nextPage = 0;
    std::size_t m_waiting_bytes = 0;
    std::uint64_t m_written_bytes = 0;
    std::uint64_t m_limit_bytes;
    std::uint64_t m_segment_bytes;
    bool m_isWriting = false;
    bool m_isDiskFull = false; ///< until a segment goes
    bool m_hasFailed = false;
    bool m_isEnding = false;
    std::optional<Error> m_trouble;
    std::deque<FetchedPart> m_fetches; ///< asked for, the latest last
    std::vector<FetchedPart> m_fetched;
    bool m_isFetching = false;
    std::condition_variable m_fetchChanged;
    std::vector<std::byte> m_read; ///< of the owner: a part with its checksum
    std::thread m_writer;          ///< the last two: they use the others
    std::thread m_reader;
};

} // namespace halbench::devices
