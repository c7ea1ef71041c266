#include "devices/history/page_file.h"

#include <QtCore/QDir>
#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>

namespace halbench::devices {
namespace {

/// A page of two parts that only it has.
PageContent contentOf(int number, std::size_t length = 1000) {
    auto octets = std::make_shared<std::vector<std::byte>>(length);
    for (std::size_t i = 0; i < length; ++i) {
        (*octets)[i] = static_cast<std::byte>(i * 7 + static_cast<std::size_t>(number) * 13);
    }
    const std::span<const std::byte> all(*octets);
    return {{all.first(length / 4), all.subspan(length / 4)}, octets};
}

bool readsBack(PageFile& file, PageStore::Page page, int number, std::size_t length = 1000) {
    const PageContent expected = contentOf(number, length);
    for (std::size_t part = 0; part < 2; ++part) {
        std::vector<std::byte> octets(expected.parts[part].size());
        if (!file.read(page, part, octets) ||
            !std::equal(octets.begin(), octets.end(), expected.parts[part].begin())) {
            return false;
        }
    }
    return true;
}

class PageFileTest : public testing::Test {
protected:
    PageFileConfig config() const {
        PageFileConfig config;
        config.folder = m_folder.filePath(QStringLiteral("cache/history")).toStdString();
        config.limit_bytes = 40'000;
        config.segment_bytes = 5'000;
        config.spare_bytes = 0;
        return config;
    }
    QTemporaryDir m_folder;
};

TEST_F(PageFileTest, givesBackWhatItWasGiven) {
    PageFile file(config());
    std::vector<PageStore::Page> pages;
    for (int i = 0; i < 20; ++i) {
        ASSERT_EQ(file.room(1000), PageRoom::Free);
        pages.push_back(file.put(contentOf(i)));
    }
    file.waitUntilIdle();
    for (int i = 0; i < 20; ++i) {
        EXPECT_EQ(file.state(pages[static_cast<std::size_t>(i)]), PageState::Kept);
        EXPECT_TRUE(readsBack(file, pages[static_cast<std::size_t>(i)], i));
    }
    EXPECT_FALSE(file.trouble());
}

TEST_F(PageFileTest, leavesNoFileBehindEvenWhileItRuns) {
    PageFile file(config());
    file.put(contentOf(1));
    file.waitUntilIdle();
    EXPECT_GT(file.bytes(), 1000U);
    EXPECT_TRUE(QDir(QString::fromStdString(config().folder)).exists());
    EXPECT_TRUE(QDir(QString::fromStdString(config().folder)).isEmpty());
}

TEST_F(PageFileTest, roomComesBackWhenOldPagesAreReleased) {
    PageFile file(config());
    std::deque<PageStore::Page> pages;
    int next = 0;
    for (int i = 0; i < 500; ++i) {
        file.waitUntilIdle();
        while (file.room(1000) == PageRoom::Full) {
            ASSERT_FALSE(pages.empty());
            file.release(pages.front());
            pages.pop_front();
            ++next;
        }
        pages.push_back(file.put(contentOf(i)));
        ASSERT_LE(file.bytes(), 40'000U);
    }
    file.waitUntilIdle();
    EXPECT_GE(pages.size(), 34U); // of 39: a segment of four goes at once
    EXPECT_TRUE(readsBack(file, pages.front(), next));
    EXPECT_TRUE(readsBack(file, pages.back(), 499));
    EXPECT_FALSE(file.trouble());
}

TEST_F(PageFileTest, anotherLimitCountsFromThenOnAndWhatIsWrittenStays) {
    PageFile file(config());
    std::deque<PageStore::Page> pages;
    for (int i = 0; i < 30; ++i) {
        pages.push_back(file.put(contentOf(i)));
    }
    file.waitUntilIdle();
    EXPECT_EQ(file.limit_bytes(), 40'000U);
    EXPECT_EQ(file.room(1000), PageRoom::Free);
    file.setLimit_bytes(16'000);
    EXPECT_EQ(file.room(1000), PageRoom::Full);
    EXPECT_GT(file.bytes(), 30'000U);
    EXPECT_TRUE(readsBack(file, pages.front(), 0));
    int first = 0;
    while (file.room(1000) == PageRoom::Full) { // as a history does
        ASSERT_FALSE(pages.empty());
        file.release(pages.front());
        pages.pop_front();
        ++first;
    }
    EXPECT_LE(file.bytes(), 15'000U);
    EXPECT_TRUE(readsBack(file, pages.front(), first));
    file.setLimit_bytes(80'000);
    EXPECT_EQ(file.room(50'000), PageRoom::Free);
    EXPECT_FALSE(file.trouble()) << "a limit is none";
}

TEST_F(PageFileTest, moreThanItMayHoldInMemoryWaits) {
    std::atomic<bool> isStalled = true;
    std::atomic<bool> isAsked = false;
    PageDisk disk = realPageDisk();
    disk.write = [&, write = disk.write](int handle, std::span<const std::byte> octets,
                                         std::uint64_t offset) {
        isAsked = true;
        isAsked.notify_all();
        isStalled.wait(true);
        return write(handle, octets, offset);
    };
    PageFileConfig small = config();
    small.waiting_bytes = 2500;
    PageFile file(small, disk);
    const auto first = file.put(contentOf(0));
    isAsked.wait(false);
    const auto second = file.put(contentOf(1));
    EXPECT_EQ(file.room(1000), PageRoom::Busy);
    EXPECT_EQ(file.state(second), PageState::Waiting);
    file.release(first); // while it is being written
    isStalled = false;
    isStalled.notify_all();
    file.waitUntilIdle();
    EXPECT_EQ(file.room(1000), PageRoom::Free);
    EXPECT_TRUE(readsBack(file, second, 1));
}

TEST_F(PageFileTest, aFullDiskIsSaidOnceAndRoomIsMadeByReleasing) {
    std::atomic<int> room = 8; // pages
    PageDisk disk = realPageDisk();
    disk.write = [&, write = disk.write](int handle, std::span<const std::byte> octets,
                                         std::uint64_t offset) {
        if (room <= 0) {
            errno = ENOSPC;
            return false;
        }
        --room;
        return write(handle, octets, offset);
    };
    PageFile file(config(), disk);
    std::vector<PageStore::Page> pages;
    for (int i = 0; i < 9; ++i) {
        pages.push_back(file.put(contentOf(i)));
    }
    file.waitUntilIdle();
    EXPECT_EQ(file.room(1000), PageRoom::Full);
    EXPECT_EQ(file.state(pages[8]), PageState::Waiting);
    ASSERT_TRUE(file.trouble());
    EXPECT_EQ(file.trouble()->code, ErrorCode::FileSystem);
    EXPECT_NE(file.trouble()->message.find("No space left"), std::string::npos);
    EXPECT_NE(file.trouble()->message.find(config().folder), std::string::npos);
    room = 4;
    for (std::size_t i = 0; i < 4; ++i) { // the first segment
        file.release(pages[i]);
    }
    file.waitUntilIdle();
    EXPECT_EQ(file.state(pages[8]), PageState::Kept);
    EXPECT_EQ(file.room(1000), PageRoom::Free);
    EXPECT_TRUE(readsBack(file, pages[5], 5));
    EXPECT_TRUE(readsBack(file, pages[8], 8));
}

TEST_F(PageFileTest, leavesOthersTheirShareOfTheDisk) {
    PageDisk disk = realPageDisk();
    disk.free_bytes = [](const std::string&) { return std::optional<std::uint64_t>(5500); };
    PageFileConfig polite = config();
    polite.spare_bytes = 1000;
    PageFile file(polite, disk);
    const auto page = file.put(contentOf(0));
    file.waitUntilIdle();
    EXPECT_EQ(file.state(page), PageState::Lost); // there was nothing that could be released
    EXPECT_EQ(file.room(1000), PageRoom::None);
    ASSERT_TRUE(file.trouble());
}

TEST_F(PageFileTest, aDiskThatFailsEndsWritingButNotReading) {
    std::atomic<bool> hasFailed = false;
    PageDisk disk = realPageDisk();
    disk.write = [&, write = disk.write](int handle, std::span<const std::byte> octets,
                                         std::uint64_t offset) {
        errno = EIO;
        return !hasFailed && write(handle, octets, offset);
    };
    PageFile file(config(), disk);
    const auto good = file.put(contentOf(0));
    file.waitUntilIdle();
    hasFailed = true;
    const auto bad = file.put(contentOf(1));
    const auto later = file.put(contentOf(2));
    file.waitUntilIdle();
    EXPECT_EQ(file.state(good), PageState::Kept);
    EXPECT_EQ(file.state(bad), PageState::Lost);
    EXPECT_EQ(file.state(later), PageState::Lost);
    EXPECT_EQ(file.room(1), PageRoom::None);
    EXPECT_TRUE(readsBack(file, good, 0));
    ASSERT_TRUE(file.trouble());
    EXPECT_NE(file.trouble()->message.find("Input/output error"), std::string::npos);
}

TEST_F(PageFileTest, aFolderThatCannotBeMadeIsSaid) {
    PageFileConfig wrong = config();
    wrong.folder = "/proc/no/such/folder";
    PageFile file(wrong);
    const auto page = file.put(contentOf(0));
    file.waitUntilIdle();
    EXPECT_EQ(file.state(page), PageState::Lost);
    ASSERT_TRUE(file.trouble());
    EXPECT_NE(file.trouble()->message.find("/proc/no/such/folder"), std::string::npos);
}

TEST_F(PageFileTest, damagedAndTruncatedPagesAreNoAnswer) {
    enum class Damage { None, Bit, Short };
    std::atomic<Damage> damage = Damage::None;
    PageDisk disk = realPageDisk();
    disk.read = [&, read = disk.read](int handle, std::span<std::byte> octets, std::uint64_t offset) {
        const std::uint64_t place = damage == Damage::Short ? offset + 1'000'000 : offset;
        const bool isRead = read(handle, octets, place);
        if (damage == Damage::Bit && octets.size() > 500) {
            octets[300] ^= std::byte{4};
        }
        return isRead;
    };
    PageFile file(config(), disk);
    const auto page = file.put(contentOf(0));
    file.waitUntilIdle();
    EXPECT_TRUE(readsBack(file, page, 0));
    damage = Damage::Bit;
    EXPECT_FALSE(readsBack(file, page, 0));
    ASSERT_TRUE(file.trouble());
    EXPECT_NE(file.trouble()->message.find("checksum"), std::string::npos);
    damage = Damage::Short;
    EXPECT_FALSE(readsBack(file, page, 0));
    EXPECT_NE(file.trouble()->message.find("checksum"), std::string::npos); // the first stays
    damage = Damage::None;
    EXPECT_TRUE(readsBack(file, page, 0));
}

TEST_F(PageFileTest, endsWhileSomethingWaits) {
    PageFile file(config());
    for (int i = 0; i < 30; ++i) {
        file.put(contentOf(i));
    }
}

/// Of a page of contentOf().
std::size_t partBytes(std::size_t part) {
    return part == 0 ? 250 : 750;
}

TEST_F(PageFileTest, whatIsFetchedComesAsItWasGivenWhileNobodyWaits) {
    std::atomic<bool> isStalled = true;
    PageDisk disk = realPageDisk();
    disk.read = [&, read = disk.read](int handle, std::span<std::byte> octets, std::uint64_t offset) {
        isStalled.wait(true); // a disk that takes its time
        return read(handle, octets, offset);
    };
    PageFile file(config(), disk);
    std::vector<PageStore::Page> pages;
    for (int i = 0; i < 8; ++i) {
        pages.push_back(file.put(contentOf(i)));
    }
    file.waitUntilIdle();
    for (const PageStore::Page page : pages) {
        for (std::size_t part = 0; part < 2; ++part) {
            EXPECT_TRUE(file.fetch(page, part, partBytes(part)));
        }
    }
    EXPECT_TRUE(file.fetched().empty());
    isStalled = false;
    isStalled.notify_all();
    file.waitUntilFetched();
    const std::vector<FetchedPart> parts = file.fetched();
    ASSERT_EQ(parts.size(), 16U);
    for (const FetchedPart& part : parts) {
        ASSERT_NE(part.octets, nullptr);
        const auto number = static_cast<int>(part.page - pages.front());
        const PageContent expected = contentOf(number);
        EXPECT_TRUE(std::equal(expected.parts[part.part].begin(), expected.parts[part.part].end(),
                               part.octets.get()));
    }
    EXPECT_TRUE(file.fetched().empty());
    EXPECT_FALSE(file.trouble());
}

TEST_F(PageFileTest, aPageThatIsReleasedWhileItIsReadKeepsItsFileUntilThen) {
    std::atomic<bool> isStalled = true;
    std::atomic<bool> isAsked = false;
    std::atomic<int> closed = 0;
    PageDisk disk = realPageDisk();
    disk.read = [&, read = disk.read](int handle, std::span<std::byte> octets, std::uint64_t offset) {
        isAsked = true;
        isAsked.notify_all();
        isStalled.wait(true);
        return read(handle, octets, offset);
    };
    disk.close = [&, close = disk.close](int handle) {
        ++closed;
        close(handle);
    };
    PageFile file(config(), disk);
    const auto page = file.put(contentOf(1));
    const auto other = file.put(contentOf(2));
    file.waitUntilIdle();
    file.fetch(other, 0, partBytes(0));
    file.fetch(page, 0, partBytes(0));
    isAsked.wait(false);
    file.release(page);
    file.release(other);
    EXPECT_EQ(closed, 0);
    isStalled = false;
    isStalled.notify_all();
    file.waitUntilFetched();
    std::size_t dropped = 0;
    for (const FetchedPart& part : file.fetched()) {
        dropped += part.isDropped ? 1 : 0;
    }
    EXPECT_LE(dropped, 1U); // the one whose turn came after its release
    EXPECT_EQ(closed, 1);
}

TEST_F(PageFileTest, whatIsDamagedIsFetchedAsNothingAndSaid) {
    PageDisk disk = realPageDisk();
    disk.read = [read = disk.read](int handle, std::span<std::byte> octets, std::uint64_t offset) {
        const bool isRead = read(handle, octets, offset);
        octets[octets.size() / 2] ^= std::byte{1};
        return isRead;
    };
    PageFile file(config(), disk);
    const auto page = file.put(contentOf(1));
    file.waitUntilIdle();
    file.fetch(page, 1, partBytes(1));
    file.waitUntilFetched();
    const std::vector<FetchedPart> parts = file.fetched();
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].octets, nullptr);
    EXPECT_FALSE(parts[0].isDropped);
    ASSERT_TRUE(file.trouble());
    EXPECT_NE(file.trouble()->message.find("checksum"), std::string::npos);
}

TEST_F(PageFileTest, ofMoreThanAnybodyLooksAtTheOldestIsDroppedAndSaid) {
    std::atomic<bool> isStalled = true;
    PageDisk disk = realPageDisk();
    disk.read = [&, read = disk.read](int handle, std::span<std::byte> octets, std::uint64_t offset) {
        isStalled.wait(true);
        return read(handle, octets, offset);
    };
    PageFile file(config(), disk);
    const auto page = file.put(contentOf(1));
    file.waitUntilIdle();
    constexpr std::size_t Asked = 5000;
    for (std::size_t i = 0; i < Asked; ++i) {
        file.fetch(page, i % 2, partBytes(i % 2));
    }
    isStalled = false;
    isStalled.notify_all();
    file.waitUntilFetched();
    const std::vector<FetchedPart> parts = file.fetched();
    ASSERT_EQ(parts.size(), Asked) << "each is answered";
    EXPECT_TRUE(
        std::any_of(parts.begin(), parts.end(), [](const FetchedPart& part) { return part.isDropped; }));
}

} // namespace
} // namespace halbench::devices
