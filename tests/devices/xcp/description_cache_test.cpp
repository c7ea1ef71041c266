#include "devices/xcp/description_cache.h"
#include "devices/xcp/xcp_device.h"
#include "tests/devices/xcp/test_slave.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace halbench::devices::xcp {
namespace {

namespace fs = std::filesystem;

const std::string Text = "ASAP2_VERSION 1 61\n/begin PROJECT x \"\" \n\x01 any octets \xFF",
                  Epk = "0.1.0-0x12";

class DescriptionCacheTest : public testing::Test {
protected:
    void SetUp() override {
        m_folder =
            fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
        fs::remove_all(m_folder);
    }
    void TearDown() override { fs::remove_all(m_folder); }

    std::string folder() const { return m_folder.string(); }
    fs::path onlyFile() const {
        EXPECT_EQ(std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()), 1);
        return fs::directory_iterator(m_folder)->path();
    }
    static std::string contentOf(const fs::path& path) {
        std::ifstream file(path, std::ios::binary);
        std::ostringstream content;
        content << file.rdbuf();
        return content.str();
    }
    static void replace(const fs::path& path, const std::string& content) {
        std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
    }

    fs::path m_folder;
    DescriptionKey m_key{"htm", Epk, Text.size()};
};

TEST_F(DescriptionCacheTest, givesBackWhatItWasGiven) {
    const DescriptionCache cache(folder() + "/deeper");
    EXPECT_FALSE(cache.find(m_key));
    EXPECT_TRUE(*cache.store(m_key, Text));
    EXPECT_EQ(cache.find(m_key), Text);
    EXPECT_TRUE(*cache.store(m_key, Text)) << "again, over the old one";
    EXPECT_EQ(cache.find(m_key), Text);
}

TEST_F(DescriptionCacheTest, anotherNameEpkOrLengthIsAnotherDescription) {
    const DescriptionCache cache(folder());
    ASSERT_TRUE(*cache.store(m_key, Text));
    EXPECT_FALSE(cache.find({"htm2", Epk, Text.size()}));
    EXPECT_FALSE(cache.find({"htm", Epk + "1", Text.size()}));
    EXPECT_FALSE(cache.find({"htm", Epk, Text.size() + 1}));
    EXPECT_FALSE(cache.find({"htm", Epk, Text.size() - 1}));
}

TEST_F(DescriptionCacheTest, fileCutShortAnywhereIsIgnored) {
    const DescriptionCache cache(folder());
    ASSERT_TRUE(*cache.store(m_key, Text));
    const fs::path path = onlyFile();
    const std::string whole = contentOf(path);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        replace(path, whole.substr(0, size));
        ASSERT_FALSE(cache.find(m_key)) << size;
        replace(path, whole.substr(size + 1)); // its beginning is missing
        ASSERT_FALSE(cache.find(m_key)) << size;
    }
    replace(path, whole + " ");
    EXPECT_FALSE(cache.find(m_key));
    replace(path, whole);
    EXPECT_EQ(cache.find(m_key), Text);
}

TEST_F(DescriptionCacheTest, everyFlippedBitIsNoticed) {
    const DescriptionCache cache(folder());
    ASSERT_TRUE(*cache.store(m_key, Text));
    const fs::path path = onlyFile();
    const std::string whole = contentOf(path);
    for (std::size_t at = 0; at < whole.size(); ++at) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string damaged = whole;
            damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
            replace(path, damaged);
            ASSERT_FALSE(cache.find(m_key)) << "octet " << at << ", bit " << bit;
        }
    }
}

TEST_F(DescriptionCacheTest, boardThatCannotBeToldApartIsNotKept) {
    const DescriptionCache cache(folder());
    for (const DescriptionKey& key :
         {DescriptionKey{"", Epk, Text.size()}, DescriptionKey{"htm", "", Text.size()},
          DescriptionKey{"a\nb", Epk, Text.size()}, DescriptionKey{"htm", Epk, 0},
          DescriptionKey{"htm", Epk, Text.size() + 1}}) {
        EXPECT_FALSE(*cache.store(key, Text));
        EXPECT_FALSE(cache.find(key));
    }
    EXPECT_FALSE(*DescriptionCache("").store(m_key, Text));
    EXPECT_FALSE(fs::exists(m_folder));
}

TEST_F(DescriptionCacheTest, folderThatCannotBeWrittenIsToldAndLeavesNothing) {
    const DescriptionCache cache("/dev/null/cache");
    const auto stored = cache.store(m_key, Text);
    ASSERT_FALSE(stored);
    EXPECT_EQ(stored.error().code, ErrorCode::FileSystem);
    EXPECT_FALSE(cache.find(m_key));
}

/// A connection to a new slave of the same tables, and how it came by the description.
struct Opened {
    std::vector<std::string> messages;
    std::size_t uploads = 0;
    std::size_t signals = 0;
};

Opened connectTo(const std::string& folder, const std::string& epk = "1") {
    SlaveTraits traits;
    traits.name = "slave";
    traits.epk = epk;
    auto slave = std::make_unique<TestSlave>(traits);
    TestSlave* watched = slave.get();
    Opened opened;
    XcpDeviceOptions options;
    options.cacheFolder = folder;
    options.onMessage = [&](const std::string& text) { opened.messages.push_back(text); };
    const auto device = openXcpDevice(std::move(slave), std::move(options));
    EXPECT_TRUE(device) << device.error().message;
    opened.uploads = watched->count(Command::Upload);
    opened.signals = device ? (*device)->catalogue().signals.size() : 0;
    return opened;
}

TEST_F(DescriptionCacheTest, secondConnectionReadsNoDescription) {
    const Opened first = connectTo(folder());
    const Opened second = connectTo(folder());
    EXPECT_GT(first.uploads, 5U);
    EXPECT_EQ(second.uploads, 0U);
    EXPECT_EQ(second.signals, first.signals);
    EXPECT_NE(first.messages.front().find("read from the device"), std::string::npos);
    EXPECT_NE(second.messages.front().find("taken from the cache"), std::string::npos);
}

TEST_F(DescriptionCacheTest, changedEpkOrNoneIsReadFromTheBoard) {
    const std::size_t uploads = connectTo(folder(), "1").uploads;
    EXPECT_EQ(connectTo(folder(), "2").uploads, uploads);
    EXPECT_EQ(connectTo(folder(), "1").uploads, 0U);
    EXPECT_EQ(connectTo(folder(), "2").uploads, 0U);
    EXPECT_EQ(connectTo(folder(), "").uploads, uploads);
    EXPECT_EQ(connectTo(folder(), "").uploads, uploads) << "nothing would tell when it changes";
}

TEST_F(DescriptionCacheTest, changedFirmwareIsToldWithBothOfThem) {
    const auto told = [](const Opened& opened) {
        return std::count_if(opened.messages.begin(), opened.messages.end(), [](const std::string& text) {
            return text.find("the firmware of 'slave' changed from 'one'") != std::string::npos &&
                   text.find("to 'two'") != std::string::npos;
        });
    };
    EXPECT_EQ(told(connectTo(folder(), "one")), 0);
    EXPECT_EQ(told(connectTo(folder(), "one")), 0);
    EXPECT_EQ(told(connectTo(folder(), "two")), 1);
    EXPECT_EQ(told(connectTo(folder(), "two")), 0) << "known by now";
    EXPECT_EQ(told(connectTo("", "two")), 0) << "nothing is remembered without a folder";
}

TEST_F(DescriptionCacheTest, theFirmwareBeforeIsThatOfTheSameBoardAndOfWholeFiles) {
    const DescriptionCache cache(folder());
    EXPECT_FALSE(cache.epkBefore(m_key));
    ASSERT_TRUE(*cache.store(m_key, Text));
    EXPECT_FALSE(cache.epkBefore(m_key)) << "the same";
    EXPECT_FALSE(cache.epkBefore({"htm2", "new", 5})) << "another board";
    EXPECT_EQ(cache.epkBefore({"htm", "new", 5}), Epk);
    replace(onlyFile(), "halbench.description-cache/2\nhtm\nold\n");
    EXPECT_FALSE(cache.epkBefore({"htm", "new", 5}));
    replace(onlyFile(), "");
    EXPECT_FALSE(cache.epkBefore({"htm", "new", 5}));
}

TEST_F(DescriptionCacheTest, withoutAFolderEveryConnectionReadsIt) {
    (void)connectTo("");
    EXPECT_GT(connectTo("").uploads, 5U);
}

TEST_F(DescriptionCacheTest, damagedCopyIsReadAgainFromTheBoard) {
    const Opened first = connectTo(folder());
    const fs::path path = onlyFile();
    const std::string whole = contentOf(path);
    replace(path, whole.substr(0, whole.size() / 2));
    EXPECT_EQ(connectTo(folder()).uploads, first.uploads);
    EXPECT_EQ(contentOf(path), whole);
    EXPECT_EQ(connectTo(folder()).uploads, 0U);
}

} // namespace
} // namespace halbench::devices::xcp
