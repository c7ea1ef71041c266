#include "app/session/recording_feed.h"
#include "devices/formats/recording_file.h"

#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace halbench::app {
namespace {

using State = RecorderStatus::State;
constexpr double Period_s = 1.0 / 1024.0; // a power of two: times of rows are exact

class RecordingFeedTest : public testing::Test {
protected:
    RecordingFeedTest() {
        auto made = std::make_shared<StreamLayout>();
        made->columns = {{"count", ""}};
        made->period_s = Period_s;
        layout = made;
    }

    /// Row i comes at i periods and says i.
    SampleBlockPtr block(int first, int count) const {
        auto made = std::make_shared<SampleBlock>();
        made->layout = layout;
        for (int row = first; row < first + count; ++row) {
            made->time_s.push_back(row * Period_s);
            made->values.push_back(row);
        }
        return made;
    }

    std::shared_ptr<Recorder> recorder(std::optional<double> end_s = {}) {
        RecorderConfig config;
        config.path = path();
        config.layout = *layout;
        config.end_s = end_s;
        config.queue_rows = 10'000'000;
        return std::make_shared<Recorder>(std::move(config));
    }

    devices::RecordedFile finished(Recorder& one) {
        one.finish();
        EXPECT_TRUE(QTest::qWaitFor([&] { return one.status().state == State::Done; }, 20000));
        auto file = devices::readRecordingFile(path());
        EXPECT_TRUE(file) << (file ? "" : file.error().message);
        return file ? *std::move(file) : devices::RecordedFile();
    }

    std::string path() const { return folder.filePath("run.csv").toStdString(); }

    std::shared_ptr<const StreamLayout> layout;
    QTemporaryDir folder;
    RecordingFeed feed;
};

TEST_F(RecordingFeedTest, rowsFromBeforeTheStartGoInFront) {
    feed.keep(0.5);
    for (int first = 0; first < 2048; first += 100) {
        feed.push(block(first, 100));
    }
    EXPECT_EQ(feed.newest_s(), 2099 * Period_s);
    const auto one = recorder();
    feed.give(one, 1500 * Period_s);
    one->addMarker(2000 * Period_s, "trigger");
    feed.push(block(2100, 100));
    const auto file = finished(*one);
    const std::vector<double> counts = file.recording.column("count");
    ASSERT_EQ(counts.size(), 700U);
    for (std::size_t row = 0; row < counts.size(); ++row) {
        ASSERT_EQ(counts[row], 1500.0 + static_cast<double>(row));
    }
    EXPECT_EQ(file.recording.lostRows, 0U);
    ASSERT_EQ(file.meta.markers.size(), 1U);
    EXPECT_DOUBLE_EQ(file.meta.markers[0].time_s, 500 * Period_s);
}

TEST_F(RecordingFeedTest, noRowIsLostOrTwiceWheneverTheStartComes) {
    constexpr int Rows = 200'000;
    feed.keep(1000.0);
    std::atomic<int> sent = 0;
    std::thread stream([&] {
        for (int first = 0, size = 1; first < Rows; first += size, size = first % 37 + 1) {
            feed.push(block(first, std::min(size, Rows - first)));
            sent = first;
        }
    });
    while (sent < Rows / 4) {
        std::this_thread::yield();
    }
    const auto one = recorder();
    feed.give(one, 1000 * Period_s); // while rows come
    stream.join();
    const auto file = finished(*one);
    const std::vector<double> counts = file.recording.column("count");
    ASSERT_EQ(counts.size(), static_cast<std::size_t>(Rows - 1000));
    for (std::size_t row = 0; row < counts.size(); ++row) {
        ASSERT_EQ(counts[row], 1000.0 + static_cast<double>(row));
    }
    EXPECT_TRUE(file.meta.gaps.empty());
}

TEST_F(RecordingFeedTest, aGapFromBeforeTheStartIsAGapOfTheRecording) {
    feed.keep(10.0);
    feed.push(block(0, 100));
    feed.push(block(150, 100));
    const auto one = recorder();
    feed.give(one, 50 * Period_s);
    const auto file = finished(*one);
    EXPECT_EQ(file.recording.rows(), 150U);
    ASSERT_EQ(file.meta.gaps.size(), 1U);
    EXPECT_EQ(file.meta.gaps[0].lostRows, 50U);
    EXPECT_DOUBLE_EQ(file.meta.gaps[0].time_s, 100 * Period_s);
}

TEST_F(RecordingFeedTest, aRecordingWithAnEndFinishesByItselfThere) {
    feed.keep(10.0);
    feed.push(block(0, 100));
    const auto one = recorder(300 * Period_s);
    feed.give(one, 10 * Period_s);
    for (int first = 100; first < 500; first += 40) {
        feed.push(block(first, 40));
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return one->status().state == State::Done; }, 20000));
    const auto file = finished(*one);
    EXPECT_EQ(file.recording.rows(), 290U);
    EXPECT_EQ(file.recording.column("count").back(), 299.0);
}

TEST_F(RecordingFeedTest, withoutALengthNothingIsKept) {
    feed.push(block(0, 100));
    EXPECT_FALSE(feed.newest_s());
    const auto one = recorder();
    feed.give(one, 0.0);
    feed.push(block(100, 10));
    EXPECT_EQ(finished(*one).recording.column("count").front(), 100.0);
    feed.leave();
    feed.keep(1.0);
    feed.push(block(200, 10));
    EXPECT_EQ(feed.oldest_s(), 200 * Period_s);
    EXPECT_EQ(feed.rows(), 10U);
}

} // namespace
} // namespace halbench::app
