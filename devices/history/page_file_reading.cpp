// Parts of pages that come back: at once for who waits, and beside the owner for who does not.
#include "control/base/assert.h"
#include "devices/history/page_file.h"
#include "devices/history/page_part.h"

#include <fmt/format.h>

#include <cerrno>
#include <utility>

namespace halbench::devices {

namespace {

/// What may wait to be read: some pictures full. Of more, what was asked for first is not seen any more.
constexpr std::size_t MostFetches = 2048;

} // namespace

/// Nothing when the page is not in a file.
std::optional<PageFile::Stretch> PageFile::stretchOf(Page page, std::size_t part, std::size_t bytes) const {
    const auto found = m_places.find(page);
    HB_ASSERT(found != m_places.end() && part < found->second.ends.size());
    const Place& place = found->second;
    const std::uint64_t begin = part > 0 ? place.ends[part - 1] : 0;
    HB_ASSERT(place.ends[part] - begin == PartSumBytes + bytes);
    return place.segment ? std::optional<Stretch>({place.segment, place.offset + begin}) : std::nullopt;
}

/// Without the lock. Otherwise than it was written, or not at all: `errno` is zero, or says why.
bool PageFile::readPart(const Stretch& stretch, const FetchedPart& part, std::vector<std::byte>& text) {
    text.resize(PartSumBytes + part.bytes);
    errno = 0;
    if (!m_disk.read(stretch.segment->handle, text, stretch.offset)) {
        return false;
    }
    errno = 0;
    std::uint64_t sum = 0;
    std::memcpy(&sum, text.data(), PartSumBytes);
    return sum == partSum(std::span(text).subspan(PartSumBytes), part.page, part.part);
}

void PageFile::reportUnread(int cause) {
    report(fmt::format("the history in '{}' cannot be read: {}", m_config.folder,
                       cause == 0 ? "damaged (checksum)" : std::strerror(cause)),
           "a gap is shown instead; recordings are not affected; check the disk");
}

bool PageFile::read(Page page, std::size_t part, std::span<std::byte> octets) {
    std::unique_lock lock(m_mutex);
    const std::optional<Stretch> stretch = stretchOf(page, part, octets.size());
    if (!stretch) {
        return false;
    }
    lock.unlock(); // the owner alone releases, and waits here
    FetchedPart wanted;
    wanted.page = page;
    wanted.part = part;
    wanted.bytes = octets.size();
    if (readPart(*stretch, wanted, m_read)) {
        std::memcpy(octets.data(), m_read.data() + PartSumBytes, octets.size());
        return true;
    }
    const int cause = errno;
    lock.lock();
    reportUnread(cause);
    return false;
}

bool PageFile::fetch(Page page, std::size_t part, std::size_t bytes) {
    const std::lock_guard lock(m_mutex);
    FetchedPart wanted;
    wanted.page = page;
    wanted.part = part;
    wanted.bytes = bytes;
    m_fetches.push_back(std::move(wanted));
    if (m_fetches.size() > MostFetches) {
        m_fetched.push_back(std::move(m_fetches.front()));
        m_fetched.back().isDropped = true;
        m_fetches.pop_front();
    }
    m_fetchChanged.notify_all();
    return true;
}

std::vector<FetchedPart> PageFile::fetched() {
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_fetched, {});
}

void PageFile::waitUntilFetched() {
    std::unique_lock lock(m_mutex);
    m_fetchChanged.wait(lock, [this] { return m_fetches.empty() && !m_isFetching; });
}

void PageFile::serveFetches() {
    std::unique_lock lock(m_mutex);
    while (!m_isEnding) {
        if (m_fetches.empty()) {
            m_fetchChanged.wait(lock);
        } else {
            m_isFetching = true;
            fetchNext(lock);
            m_isFetching = false;
            m_fetchChanged.notify_all();
        }
    }
}

/// What was asked for last is what is looked at now. The page may have been released, also meanwhile; its
/// file stays until it is read.
void PageFile::fetchNext(std::unique_lock<std::mutex>& lock) {
    FetchedPart part = std::move(m_fetches.back());
    m_fetches.pop_back();
    part.isDropped = m_places.count(part.page) == 0;
    const std::optional<Stretch> stretch =
        part.isDropped ? std::nullopt : stretchOf(part.page, part.part, part.bytes);
    if (stretch) {
        ++stretch->segment->readers;
        lock.unlock();
        std::vector<std::byte> text;
        const bool isRead = readPart(*stretch, part, text);
        const int cause = errno;
        if (isRead) {
            part.octets = std::make_unique_for_overwrite<std::byte[]>(part.bytes);
            std::memcpy(part.octets.get(), text.data() + PartSumBytes, part.bytes);
        }
        lock.lock();
        --stretch->segment->readers;
        closeUnused();
        if (!isRead) {
            reportUnread(cause);
        }
    }
    m_fetched.push_back(std::move(part));
}

} // namespace halbench::devices
