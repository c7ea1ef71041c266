#include "app/session/recorder.h"
#include "devices/formats/convert_recording.h"
#include "devices/formats/recording_file.h"
#include "tests/small_disk.h"

#include <QtCore/QDir>
#include <QtCore/QSemaphore>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <gtest/gtest.h>

#include <cerrno>
#include <cmath>
#include <condition_variable>
#include <filesystem>
#include <mutex>

namespace halbench::app {
namespace {

namespace fs = std::filesystem;
using State = RecorderStatus::State;

std::shared_ptr<const StreamLayout> layoutOf(std::vector<std::string> names, double period_s) {
    StreamLayout layout;
    for (std::string& name : names) {
        layout.columns.push_back({std::move(name), "A"});
    }
    layout.period_s = period_s;
    return std::make_shared<const StreamLayout>(std::move(layout));
}

/// Rows from a time on; the value of column k in row i is 100 k + i.
SampleBlockPtr block(const std::shared_ptr<const StreamLayout>& layout, double from_s, std::size_t rows) {
    auto made = std::make_shared<SampleBlock>();
    made->layout = layout;
    for (std::size_t row = 0; row < rows; ++row) {
        made->time_s.push_back(from_s + static_cast<double>(row) * layout->period_s);
        for (std::size_t column = 0; column < layout->columns.size(); ++column) {
            made->values.push_back(100.0 * static_cast<double>(column) + static_cast<double>(row));
        }
    }
    return made;
}

/// Of events that come at once; a loaded machine may take longer.
constexpr int Patience_ms = 120000;

class RecorderTest : public testing::Test {
protected:
    RecorderConfig config(const std::shared_ptr<const StreamLayout>& layout) {
        RecorderConfig made;
        made.path = path();
        made.layout = *layout;
        return made;
    }
    std::string path() const { return folder.filePath("run.csv").toStdString(); }
    static bool ended(const Recorder& recorder) {
        return QTest::qWaitFor(
            [&] {
                return recorder.status().state == State::Done || recorder.status().state == State::Failed;
            },
            Patience_ms);
    }
    Recording read() const {
        const auto file = devices::readRecordingFile(path());
        EXPECT_TRUE(file) << (file ? "" : file.error().message);
        return file ? file->recording : Recording();
    }

    QTemporaryDir folder;
};

TEST_F(RecorderTest, writesWhatComesAndCountsTimeFromTheFirstRow) {
    const auto layout = layoutOf({"a", "b"}, 0.01);
    Recorder recorder(config(layout));
    recorder.push(block(layout, 5.0, 10));
    recorder.push(block(layout, 5.1, 10));
    recorder.addMarker(5.05, "here");
    recorder.addChange(5.1, "gain.kp", 12.0);
    recorder.finish();
    ASSERT_TRUE(ended(recorder));
    EXPECT_EQ(recorder.status().state, State::Done);
    EXPECT_EQ(recorder.status().rows, 20U);
    EXPECT_EQ(recorder.status().missingRows, 0U);
    EXPECT_NEAR(recorder.status().elapsed_s, 0.19, 1e-9);
    const auto file = devices::readRecordingFile(path());
    ASSERT_TRUE(file);
    EXPECT_EQ(file->recording.rows(), 20U);
    EXPECT_EQ(file->recording.time_s.front(), 0.0);
    EXPECT_TRUE(file->warnings.empty());
    ASSERT_EQ(file->meta.markers.size(), 1U);
    EXPECT_NEAR(file->meta.markers[0].time_s, 0.05, 1e-9);
    ASSERT_EQ(file->meta.changes.size(), 1U);
    EXPECT_EQ(file->meta.changes[0].name, "gain.kp");
    EXPECT_FALSE(fs::exists(path() + ".partial"));
}

// What is on the disk while it records is what a killed program leaves.
TEST_F(RecorderTest, markersAndChangesSurviveAKill) {
    const auto layout = layoutOf({"a"}, 0.01);
    Recorder recorder(config(layout));
    recorder.push(block(layout, 5.0, 10));
    recorder.addMarker(5.05, "here");
    recorder.addChange(5.1, "gain.kp", 12.0);
    const auto left = [this] { return devices::readPartialRecording(path() + ".partial"); };
    double at_s = 5.1;
    const auto isKept = [&](std::size_t markers) {
        recorder.push(block(layout, at_s, 200)); // two flush intervals
        at_s += 2.0;
        const auto partial = left(); // and the marker of the interruption
        return partial && partial->file.meta.markers.size() == markers + 1;
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return isKept(1); }, Patience_ms));
    recorder.addMarker(7.0, "there");
    ASSERT_TRUE(QTest::qWaitFor([&] { return isKept(2); }, Patience_ms));
    const auto partial = left();
    EXPECT_EQ(partial->file.meta.markers[0].text, "here");
    EXPECT_NEAR(partial->file.meta.markers[0].time_s, 0.05, 1e-9);
    EXPECT_EQ(partial->file.meta.markers[1].text, "there");
    ASSERT_EQ(partial->file.meta.changes.size(), 1U);
    EXPECT_EQ(partial->file.meta.changes[0].value, 12.0);
    recorder.finish();
    ASSERT_TRUE(ended(recorder));
    const auto file = devices::readRecordingFile(path());
    ASSERT_TRUE(file);
    EXPECT_EQ(file->meta.markers.size(), 2U) << "each once";
    EXPECT_EQ(file->meta.changes.size(), 1U);
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 2) << "data and sidecar, no working file";
}

TEST_F(RecorderTest, keepsEveryTenthRowOfAStreamTenTimesAsDense) {
    const auto stream = layoutOf({"a"}, 0.001);
    Recorder recorder(config(layoutOf({"a"}, 0.01)));
    for (int i = 0; i < 10; ++i) {
        recorder.push(block(stream, 0.025 * i, 25)); // blocks end between the rows that are kept
    }
    recorder.finish();
    ASSERT_TRUE(ended(recorder));
    EXPECT_EQ(recorder.status().rows, 25U);
    EXPECT_EQ(recorder.status().missingRows, 0U);
    EXPECT_NEAR(read().time_s.back(), 0.24, 1e-9);
}

TEST_F(RecorderTest, columnsStayWhileTheStreamChangesItsSignals) {
    Recorder recorder(config(layoutOf({"a", "b"}, 0.01)));
    recorder.push(block(layoutOf({"a", "b"}, 0.01), 0.0, 5));
    recorder.push(block(layoutOf({"c", "b"}, 0.01), 0.05, 5));
    recorder.finish();
    ASSERT_TRUE(ended(recorder));
    const Recording recording = read();
    ASSERT_EQ(recording.rows(), 10U);
    EXPECT_EQ(recording.column("b")[7], 102.0); // second column, third row of its block
    EXPECT_EQ(recording.column("a")[4], 4.0);
    EXPECT_TRUE(std::isnan(recording.column("a")[5]));
}

TEST_F(RecorderTest, aGapIsCountedAndMarkedInTheSidecar) {
    const auto layout = layoutOf({"a"}, 0.01);
    Recorder recorder(config(layout));
    recorder.push(block(layout, 0.0, 5));
    recorder.push(block(layout, 0.10, 5)); // five rows are missing
    recorder.finish();
    ASSERT_TRUE(ended(recorder));
    EXPECT_EQ(recorder.status().missingRows, 5U);
    const auto file = devices::readRecordingFile(path());
    ASSERT_TRUE(file);
    ASSERT_EQ(file->meta.gaps.size(), 1U);
    EXPECT_EQ(file->meta.gaps[0].lostRows, 5U);
    EXPECT_NEAR(file->meta.gaps[0].time_s, 0.10, 1e-9);
}

TEST_F(RecorderTest, aSlowerStreamIsToldInTheSidecarAndReadAsWhole) {
    Recorder recorder(config(layoutOf({"a"}, 0.001)));
    recorder.push(block(layoutOf({"a"}, 0.001), 3.0, 50));
    recorder.push(block(layoutOf({"a"}, 0.01), 3.055, 30));
    recorder.push(block(layoutOf({"a"}, 0.001), 3.35, 50));
    recorder.finish();
    ASSERT_TRUE(ended(recorder));
    EXPECT_EQ(recorder.status().missingRows, 0U);
    const auto file = devices::readRecordingFile(path());
    ASSERT_TRUE(file);
    EXPECT_EQ(file->recording.rows(), 130U);
    EXPECT_EQ(file->recording.lostRows, 0U);
    EXPECT_EQ(file->meta.rates.size(), 3U);
    EXPECT_TRUE(file->meta.gaps.empty());
    // What is made of it knows it too.
    for (const char* name : {"copy.csv", "copy.mf4"}) {
        devices::ConvertRequest request;
        request.input = path();
        request.output = folder.filePath(name).toStdString();
        ASSERT_TRUE(devices::convertRecording(request)) << name;
        const auto copy = devices::readRecordingFile(request.output);
        ASSERT_TRUE(copy) << name;
        EXPECT_EQ(copy->recording.lostRows, 0U) << name;
        EXPECT_EQ(copy->recording.rates.size(), 3U) << name;
    }
}

TEST_F(RecorderTest, whatDoesNotFitIntoTheQueueIsCountedNeverHidden) {
    const auto layout = layoutOf({"a"}, 0.01);
    RecorderConfig small = config(layout);
    small.queue_rows = 8;
    Recorder recorder(std::move(small));
    recorder.push(block(layout, 0.0, 9)); // larger than the queue, whatever the disk does
    recorder.push(block(layout, 0.09, 5));
    recorder.finish();
    ASSERT_TRUE(ended(recorder));
    EXPECT_EQ(recorder.status().droppedRows, 9U);
    EXPECT_EQ(recorder.status().rows, 5U);
}

/// A disk that takes nothing until it is told to.
class SlowDisk {
public:
    devices::DiskAccess access() {
        devices::DiskAccess made = devices::realDisk();
        made.write = [this](QFile& file, std::string_view octets) {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, [this] { return !m_isStuck; });
            return devices::realDisk().write(file, octets);
        };
        return made;
    }
    void setStuck(bool isStuck) {
        const std::lock_guard lock(m_mutex);
        m_isStuck = isStuck;
        m_wake.notify_all();
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_wake;
    bool m_isStuck = false;
};

TEST_F(RecorderTest, aDiskThatStallsDelaysNobodyAndWhatItMissedIsInTheSidecar) {
    const auto layout = layoutOf({"a"}, 0.01);
    SlowDisk disk;
    RecorderConfig slow = config(layout);
    slow.queue_rows = 20;
    slow.disk = disk.access();
    Recorder recorder(std::move(slow));
    recorder.push(block(layout, 0.0, 10));
    ASSERT_TRUE(QTest::qWaitFor([&] { return recorder.status().rows == 10; }, Patience_ms));
    disk.setStuck(true);
    // Returns at once; the queue takes two blocks, what the writer holds comes on top. When it takes a block
    // in between, there are two gaps.
    for (int i = 1; i < 10; ++i) {
        recorder.push(block(layout, 0.1 * i, 10));
    }
    const std::uint64_t dropped = recorder.status().droppedRows;
    EXPECT_GE(dropped, 40U);
    disk.setStuck(false);
    ASSERT_TRUE(QTest::qWaitFor([&] { return recorder.status().rows == 100 - dropped; }, Patience_ms));
    recorder.push(block(layout, 1.0, 10)); // it goes on
    recorder.finish();
    ASSERT_TRUE(ended(recorder));
    EXPECT_EQ(recorder.status().state, State::Done);
    EXPECT_EQ(recorder.status().missingRows, dropped);
    const auto file = devices::readRecordingFile(path());
    ASSERT_TRUE(file);
    EXPECT_EQ(file->recording.rows(), 110U - dropped);
    EXPECT_EQ(file->meta.droppedRows, dropped);
    ASSERT_FALSE(file->meta.gaps.empty());
    std::uint64_t missing = 0;
    for (const auto& gap : file->meta.gaps) {
        missing += gap.lostRows;
    }
    EXPECT_EQ(missing, dropped);
    ASSERT_EQ(file->meta.markers.size(), 1U) << "what is dropped within a second is told once";
    EXPECT_EQ(file->meta.markers[0].text, std::to_string(dropped) + " rows lost: disk too slow");
    EXPECT_NEAR(file->meta.markers[0].time_s,
                file->meta.gaps[0].time_s - 0.01 * static_cast<double>(file->meta.gaps[0].lostRows),
                1e-9); // where the gap begins
}

TEST_F(RecorderTest, aDiskThatCannotFlushEndsTheRecordingWithItsReason) {
    const auto layout = layoutOf({"a"}, 0.01);
    RecorderConfig bad = config(layout);
    bad.flushInterval_s = 1e-3;
    QSemaphore refused;
    bad.disk.sync = [&refused](int) {
        refused.release();
        errno = EIO;
        return false;
    };
    Recorder recorder(std::move(bad));
    recorder.push(block(layout, 0.0, 10));
    ASSERT_TRUE(refused.tryAcquire(1, Patience_ms)) << "rows are flushed while it records";
    // It learns of that with rows that come later; each block waits for the one before.
    for (std::uint64_t pushed = 10; recorder.status().state == State::Recording; pushed += 10) {
        recorder.push(block(layout, 0.01 * static_cast<double>(pushed), 10));
        ASSERT_TRUE(QTest::qWaitFor(
            [&] {
                return recorder.status().state != State::Recording || recorder.status().rows == pushed + 10;
            },
            Patience_ms));
    }
    ASSERT_TRUE(ended(recorder));
    EXPECT_EQ(recorder.status().state, State::Failed);
    ASSERT_TRUE(recorder.status().error);
    EXPECT_EQ(recorder.status().error->code, ErrorCode::FileSystem);
    EXPECT_NE(recorder.status().error->message.find("Input/output error"), std::string::npos);
    EXPECT_TRUE(devices::readPartialRecording(path() + ".partial")) << "what came is there";
}

TEST_F(RecorderTest, aFullDiskEndsTheRecordingWithItsReasonAndKeepsWhatWasWritten) {
    const auto layout = layoutOf({"a"}, 0.01);
    RecorderStatus status;
    {
        const SmallDisk disk(20000);
        Recorder recorder(config(layout));
        for (int i = 0; i < 100; ++i) {
            recorder.push(block(layout, i * 1.0, 100));
        }
        ASSERT_TRUE(ended(recorder));
        status = recorder.status();
        recorder.push(block(layout, 100.0, 100)); // goes nowhere, disturbs nothing
    }
    EXPECT_EQ(status.state, State::Failed);
    ASSERT_TRUE(status.error);
    EXPECT_EQ(status.error->code, ErrorCode::FileSystem);
    EXPECT_FALSE(fs::exists(path()));
    const auto kept = devices::readPartialRecording(path() + ".partial");
    ASSERT_TRUE(kept) << kept.error().message;
    EXPECT_GE(kept->file.recording.rows(), status.rows);
}

TEST_F(RecorderTest, anUnwritableFolderFailsWithItsName) {
    RecorderConfig bad = config(layoutOf({"a"}, 0.01));
    QFile file(folder.filePath("file"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly)); // a file where a folder is needed: fails for root as well
    bad.path = folder.filePath("file/run.csv").toStdString();
    Recorder recorder(std::move(bad));
    ASSERT_TRUE(ended(recorder));
    EXPECT_EQ(recorder.status().state, State::Failed);
    EXPECT_NE(recorder.status().error->message.find("file"), std::string::npos);
}

} // namespace
} // namespace halbench::app
