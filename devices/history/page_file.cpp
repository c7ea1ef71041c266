#include "devices/history/page_file.h"

#include "control/base/assert.h"
#include "devices/history/page_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace halbench::devices {

namespace {

/// Checksum and octets of each part, one after the other.
std::vector<std::byte> textOf(const PageContent& content, PageStore::Page page) {
    std::vector<std::byte> text;
    text.reserve(content.bytes() + content.parts.size() * PartSumBytes);
    for (std::size_t part = 0; part < content.parts.size(); ++part) {
        const std::uint64_t sum = partSum(content.parts[part], page, part);
        const auto octets = std::as_bytes(std::span(&sum, 1));
        text.insert(text.end(), octets.begin(), octets.end());
        text.insert(text.end(), content.parts[part].begin(), content.parts[part].end());
    }
    return text;
}

std::vector<std::uint32_t> endsOf(const PageContent& content) {
    std::vector<std::uint32_t> ends;
    std::size_t end = 0;
    for (const auto& part : content.parts) {
        end += PartSumBytes + part.size();
        ends.push_back(static_cast<std::uint32_t>(end));
    }
    return ends;
}

/// Of a limit that is full, an eighth goes at once.
std::uint64_t segmentFor(const PageFileConfig& config, std::uint64_t limit_bytes) {
    return std::min(config.segment_bytes, limit_bytes / 8);
}

bool isFullDisk(int cause) {
    return cause == ENOSPC || cause == EDQUOT || cause == EFBIG;
}

} // namespace

PageFile::PageFile(PageFileConfig config, PageDisk disk)
    : m_config(std::move(config)), m_disk(std::move(disk)), m_limit_bytes(m_config.limit_bytes),
      m_segment_bytes(segmentFor(m_config, m_config.limit_bytes)), m_writer([this] { run(); }),
      m_reader([this] { serveFetches(); }) {}

PageFile::~PageFile() {
    {
        const std::lock_guard lock(m_mutex);
        m_isEnding = true;
    }
    m_changed.notify_all();
    m_fetchChanged.notify_all();
    m_writer.join();
    m_reader.join();
    for (const auto& segment : m_segments) {
        m_disk.close(segment->handle);
    }
}

PageRoom PageFile::room(std::size_t bytes) const {
    const std::lock_guard lock(m_mutex);
    if (m_hasFailed) {
        return PageRoom::None;
    }
    if (m_isDiskFull || m_written_bytes + m_waiting_bytes + bytes > m_limit_bytes) {
        return PageRoom::Full;
    }
    return m_waiting_bytes > 0 && m_waiting_bytes + bytes > m_config.waiting_bytes ? PageRoom::Busy
                                                                                   : PageRoom::Free;
}

PageFile::Page PageFile::put(PageContent content) {
    const std::lock_guard lock(m_mutex);
    const Page page = m_nextPage++;
    Place place;
    place.ends = endsOf(content);
    place.isLost = m_hasFailed;
    const std::size_t bytes = content.bytes();
    m_places.emplace(page, std::move(place));
    if (!m_hasFailed) {
        m_waiting_bytes += bytes;
        m_orders.push_back({page, std::move(content), bytes});
        m_changed.notify_all();
    }
    return page;
}

PageState PageFile::state(Page page) const {
    const std::lock_guard lock(m_mutex);
    const auto found = m_places.find(page);
    HB_ASSERT(found != m_places.end());
    if (found->second.isLost) {
        return PageState::Lost;
    }
    return found->second.segment ? PageState::Kept : PageState::Waiting;
}

void PageFile::release(Page page) {
    const std::lock_guard lock(m_mutex);
    const auto found = m_places.find(page);
    HB_ASSERT(found != m_places.end());
    if (found->second.segment) {
        --found->second.segment->pages;
    }
    m_places.erase(found);
    closeUnused();
    m_changed.notify_all();
}

/// Segments of which nothing is needed; that which is being written to only when there is no room otherwise.
void PageFile::closeUnused() {
    for (auto it = m_segments.begin(); it != m_segments.end();) {
        const bool isCurrent = std::next(it) == m_segments.end();
        const bool isUnused =
            (*it)->pages == 0 && (*it)->readers == 0 && (!isCurrent || (!m_isWriting && (*it)->length > 0));
        if (isUnused) {
            m_disk.close((*it)->handle);
            m_written_bytes -= (*it)->length;
            m_isDiskFull = false;
        }
        it = isUnused ? m_segments.erase(it) : std::next(it);
    }
}

void PageFile::setLimit_bytes(std::uint64_t limit_bytes) {
    const std::lock_guard lock(m_mutex);
    m_limit_bytes = limit_bytes;
    m_segment_bytes = segmentFor(m_config, limit_bytes);
}

std::uint64_t PageFile::limit_bytes() const {
    const std::lock_guard lock(m_mutex);
    return m_limit_bytes;
}

std::uint64_t PageFile::bytes() const {
    const std::lock_guard lock(m_mutex);
    return m_written_bytes;
}

std::optional<Error> PageFile::trouble() const {
    const std::lock_guard lock(m_mutex);
    return m_trouble;
}

void PageFile::report(std::string message, std::string hint) {
    if (!m_trouble) {
        m_trouble = Error{ErrorCode::FileSystem, std::move(message), std::move(hint)};
    }
}

bool PageFile::canWrite() const {
    return !m_orders.empty() && !m_isDiskFull && !m_hasFailed;
}

void PageFile::waitUntilIdle() {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return !m_isWriting && !canWrite(); });
}

void PageFile::run() {
    std::unique_lock lock(m_mutex);
    while (!m_isEnding) {
        if (canWrite()) {
            m_isWriting = true;
            writeNext(lock);
            m_isWriting = false;
            closeUnused();
            m_changed.notify_all();
        } else {
            m_changed.wait(lock);
        }
    }
}

/// The disk is asked without the lock. The page may be released meanwhile.
void PageFile::writeNext(std::unique_lock<std::mutex>& lock) {
    Order order = std::move(m_orders.front());
    m_orders.pop_front();
    if (m_places.count(order.page) == 0) { // released meanwhile
        m_waiting_bytes -= order.bytes;
        return;
    }
    lock.unlock();
    const std::vector<std::byte> text = textOf(order.content, order.page);
    lock.lock();
    if (!openSegment(lock, text.size())) {
        const int cause = errno;
        m_orders.push_front(std::move(order));
        onWriteFailure(cause);
        return;
    }
    const std::shared_ptr<Segment> segment = m_segments.back();
    const std::uint64_t offset = segment->length;
    lock.unlock();
    errno = 0;
    const bool isWritten = m_disk.write(segment->handle, text, offset);
    const int cause = errno;
    lock.lock();
    if (!isWritten) {
        m_orders.push_front(std::move(order));
        onWriteFailure(cause);
        return;
    }
    segment->length += text.size();
    m_written_bytes += text.size();
    m_waiting_bytes -= order.bytes;
    if (const auto place = m_places.find(order.page); place != m_places.end()) {
        place->second.segment = segment;
        place->second.offset = offset;
        ++segment->pages;
    }
}

/// Makes sure that the last segment takes a page. On failure `errno` says why.
bool PageFile::openSegment(std::unique_lock<std::mutex>& lock, std::size_t bytes) {
    if (!m_segments.empty() && m_segments.back()->length + bytes <= m_segment_bytes) {
        return true;
    }
    const std::uint64_t segment_bytes = m_segment_bytes;
    lock.unlock();
    errno = 0;
    const int handle = m_disk.open(m_config.folder);
    int cause = errno;
    if (handle >= 0) { // now the folder is there
        const std::optional<std::uint64_t> free_bytes = m_disk.free_bytes(m_config.folder);
        if (free_bytes && *free_bytes < m_config.spare_bytes + segment_bytes) {
            m_disk.close(handle);
            cause = ENOSPC;
        } else {
            cause = 0;
        }
    }
    lock.lock();
    if (cause != 0 || handle < 0) {
        errno = cause;
        return false;
    }
    auto segment = std::make_shared<Segment>();
    segment->handle = handle;
    m_segments.push_back(std::move(segment));
    return true;
}

void PageFile::onWriteFailure(int cause) {
    const bool isFull = isFullDisk(cause);
    if (isFull) {
        report(fmt::format("no space for more history in '{}': {}", m_config.folder, std::strerror(cause)),
               "the oldest samples are dropped earlier; recordings are not affected; free disk space");
    } else {
        report(fmt::format("cannot keep history in '{}': {}", m_config.folder, std::strerror(cause)),
               "the oldest samples are dropped when memory is full; recordings are not affected; check the "
               "folder and the disk");
    }
    const bool isSomethingKept =
        std::any_of(m_segments.begin(), m_segments.end(), [](const auto& one) { return one->pages > 0; });
    if (isFull && isSomethingKept) {
        m_isDiskFull = true; // until pages are released
        return;
    }
    m_hasFailed = true;
    for (const Order& order : m_orders) {
        if (const auto place = m_places.find(order.page); place != m_places.end()) {
            place->second.isLost = true;
        }
    }
    m_orders.clear();
    m_waiting_bytes = 0;
}

} // namespace halbench::devices
