// The history and its page file together; each has its tests beside it.
#include "control/base/random.h"
#include "control/history/sample_history.h"
#include "devices/history/page_file.h"
#include "tests/control/history/history_blocks.h"

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

namespace halbench::devices {
namespace {

using control::SampleHistory;
using control::TimedValue;

constexpr std::size_t Rows = 300'000;
const std::size_t Budget_bytes = 12 * control::SampleChunk::bytesFor(2);

class HistoryOnDiskTest : public testing::Test {
protected:
    void SetUp() override {
        PageFileConfig config;
        config.folder = m_folder.path().toStdString();
        config.spare_bytes = 0;
        file = std::make_shared<PageFile>(config);
        paged.setStore(file);
        const auto layout = control::layoutOf({"a", "b"}, 0.0001);
        Random random(2);
        const auto noise = [&](std::size_t, std::size_t) { return random.gaussian(); };
        for (std::size_t first = 0; first < Rows; first += 1000) {
            const SampleBlock block = control::blockOf(layout, first, 1000, noise);
            plain.append(block);
            paged.append(block);
            file->waitUntilIdle(); // the machine may be slower than a device
        }
    }
    /// Of the page file, which has no name, as the system knows it.
    std::string openFile() const {
        for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
            std::error_code problem;
            const std::string target = std::filesystem::read_symlink(entry.path(), problem).string();
            if (target.find(m_folder.path().toStdString() + "/history-") == 0) {
                return entry.path().string();
            }
        }
        return {};
    }
    QTemporaryDir m_folder;
    std::shared_ptr<PageFile> file;
    SampleHistory plain{std::size_t{1} << 30};
    SampleHistory paged{Budget_bytes};
};

TEST_F(HistoryOnDiskTest, everySampleComesBack) {
    EXPECT_GT(file->bytes(), 5'000'000U);
    EXPECT_EQ(plain.range(), paged.range());
    std::vector<TimedValue> one;
    std::vector<TimedValue> other;
    for (const char* signal : {"a", "b"}) {
        plain.samples(signal, *plain.range(), one);
        paged.samples(signal, *plain.range(), other);
        ASSERT_EQ(one.size(), Rows);
        ASSERT_EQ(other.size(), Rows);
        for (std::size_t i = 0; i < Rows; ++i) {
            ASSERT_EQ(one[i].time_s, other[i].time_s);
            ASSERT_EQ(one[i].value, other[i].value);
        }
    }
    EXPECT_LE(paged.bytes(), Budget_bytes);
    EXPECT_FALSE(file->trouble());
}

// What is written stays until samples come, of which the oldest on the disk make room; the newest stay whole.
TEST_F(HistoryOnDiskTest, aSmallerLimitIsKeptAsSamplesCome) {
    constexpr std::uint64_t Limit_bytes = 2'000'000;
    PageFileConfig config;
    config.folder = m_folder.path().toStdString();
    config.spare_bytes = 0;
    config.segment_bytes = 250'000; // room comes back in such pieces
    const auto disk = std::make_shared<PageFile>(config);
    SampleHistory history{Budget_bytes};
    history.setStore(disk);
    const auto layout = control::layoutOf({"a"}, 0.0001);
    const auto ramp = [](std::size_t row, std::size_t) { return static_cast<double>(row); };
    const auto feed = [&](std::size_t from, std::size_t to) {
        for (std::size_t first = from; first < to; first += 1000) {
            history.append(control::blockOf(layout, first, 1000, ramp));
            disk->waitUntilIdle();
        }
    };
    feed(0, Rows);
    EXPECT_EQ(history.range()->begin_s, 0.0);
    ASSERT_GT(disk->bytes(), Limit_bytes + 500'000);
    disk->setLimit_bytes(Limit_bytes);
    feed(Rows, Rows + 20'000);
    EXPECT_LE(disk->bytes(), Limit_bytes);
    EXPECT_GT(disk->bytes(), Limit_bytes - 3 * config.segment_bytes); // used, not given up
    EXPECT_GT(history.range()->begin_s, 0.0);
    std::vector<TimedValue> samples;
    history.samples("a", *history.range(), samples);
    ASSERT_EQ(samples.back().value, static_cast<double>(Rows + 20'000 - 1));
    for (std::size_t i = 1; i < samples.size(); ++i) {
        ASSERT_EQ(samples[i].value, samples[i - 1].value + 1.0);
    }
    EXPECT_FALSE(disk->trouble()) << "a limit is none";
}

TEST_F(HistoryOnDiskTest, aFileCutShortIsAGapThatIsSaid) {
    const std::string open = openFile();
    ASSERT_FALSE(open.empty());
    const auto length = static_cast<off_t>(file->bytes());
    ASSERT_EQ(::truncate(open.c_str(), length / 2), 0);
    std::vector<TimedValue> samples;
    paged.samples("a", *paged.range(), samples);
    ASSERT_EQ(samples.size(), Rows);
    std::size_t missing = 0;
    for (std::size_t i = 1; i < Rows; ++i) {
        ASSERT_GT(samples[i].time_s, samples[i - 1].time_s);
        missing += std::isnan(samples[i].value) ? 1 : 0;
    }
    // Half of the pages, and the one that was cut; a page has both signals.
    EXPECT_NEAR(static_cast<double>(missing), 0.5 * static_cast<double>(file->bytes()) / 24.0 / 1.05,
                30'000.0);
    EXPECT_FALSE(std::isnan(samples[100].value));
    EXPECT_FALSE(std::isnan(samples.back().value)); // in memory
    ASSERT_TRUE(file->trouble());
    EXPECT_NE(file->trouble()->message.find("Input/output error"), std::string::npos)
        << file->trouble()->message;
}

} // namespace
} // namespace halbench::devices
