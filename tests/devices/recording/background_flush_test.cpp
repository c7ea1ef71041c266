#include "devices/recording/background_flush.h"

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

#include <atomic>
#include <cerrno>
#include <thread>

namespace halbench::devices {
namespace {

constexpr double Never_s = 1e6; // no flush by time

class BackgroundFlushTest : public testing::Test {
protected:
    std::string journal() const { return folder.filePath("run.chunks.partial").toStdString(); }
    std::vector<RecordingChunk> noted() const {
        QFile file(QString::fromStdString(journal()));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return parseChunks(file.readAll().toStdString());
    }
    DiskAccess disk(bool works = true) {
        DiskAccess made = realDisk();
        made.sync = [this, works](int) {
            ++syncs;
            errno = EIO;
            return works;
        };
        return made;
    }

    QTemporaryDir folder;
    std::atomic<int> syncs = 0;
};

TEST_F(BackgroundFlushTest, eachFlushNotesTheChecksumOfWhatCameSinceTheLast) {
    BackgroundFlush flush("run.csv", 0, journal(), 1e-3, disk());
    const auto waitFor = [&](int count) {
        while (syncs < count) {
            std::this_thread::yield();
        }
    };
    flush.add("first\n");
    waitFor(1);
    flush.add("second\n");
    flush.stop(true);
    const std::vector<RecordingChunk> chunks = noted();
    ASSERT_EQ(chunks.size(), 2U);
    EXPECT_EQ(chunks[0], (RecordingChunk{6, crc32("first\n")}));
    EXPECT_EQ(chunks[1], (RecordingChunk{7, crc32("second\n")}));
    EXPECT_FALSE(flush.error());
}

TEST_F(BackgroundFlushTest, piecesOfOneIntervalAreOneChunk) {
    BackgroundFlush flush("run.csv", 0, journal(), Never_s, disk());
    flush.add("1\n");
    flush.add("2\n");
    flush.stop(true);
    EXPECT_EQ(noted(), (std::vector<RecordingChunk>{{4, crc32("1\n2\n")}}));
    EXPECT_EQ(syncs, 1);
}

TEST_F(BackgroundFlushTest, stoppingWithoutALastFlushWritesNothing) {
    {
        BackgroundFlush flush("run.csv", 0, journal(), Never_s, disk());
        flush.add("1\n");
    }
    EXPECT_TRUE(noted().empty());
    EXPECT_EQ(syncs, 0);
}

TEST_F(BackgroundFlushTest, aDiskThatFailsIsAnErrorAndNotesNoChecksum) {
    BackgroundFlush flush("run.csv", 0, journal(), Never_s, disk(false));
    flush.add("1\n");
    flush.stop(true);
    const std::optional<Error> error = flush.error();
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code, ErrorCode::FileSystem);
    EXPECT_EQ(error->message, "cannot write 'run.csv': Input/output error");
    EXPECT_TRUE(noted().empty());
}

TEST_F(BackgroundFlushTest, aJournalThatCannotBeMadeIsAnError) {
    BackgroundFlush flush("run.csv", 0, folder.filePath("none/run.chunks").toStdString(), Never_s, disk());
    EXPECT_TRUE(flush.error());
}

} // namespace
} // namespace halbench::devices
