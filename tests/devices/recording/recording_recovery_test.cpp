#include "devices/formats/convert_recording.h"
#include "devices/formats/recording_file.h"
#include "devices/recording/recording_chunks.h"
#include "tests/devices/recording/recording_folder.h"
#include "tests/devices/recording/recording_sample.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace halbench::devices {
namespace {

namespace fs = std::filesystem;

class RecordingRecoveryTest : public RecordingFolder {};

/// As interrupt(), flushed with its checksums after every tenth row.
std::string interruptFlushed(const std::string& file, const Recording& part) {
    std::string journal;
    const std::string written = interrupt(file, part);
    std::string chunk;
    std::size_t lines = 0;
    for (const char character : written) {
        chunk += character;
        if (character == '\n' && ++lines % 10 == 0) {
            journal += chunkLine({chunk.size(), crc32(chunk)});
            chunk.clear();
        }
    }
    std::ofstream(journalPathOf(file), std::ios::binary) << journal;
    return written;
}

TEST_F(RecordingRecoveryTest, whatTheChecksumsSayIsDamagedIsLeftOutAndSaid) {
    std::string written = interruptFlushed(path("run.csv"), ramp(45));
    const auto whole = readPartialRecording(path("run.csv.partial"));
    ASSERT_TRUE(whole) << whole.error().message;
    EXPECT_EQ(whole->file.recording.rows(), 45U);
    EXPECT_EQ(whole->damagedOctets, 0U);
    written[written.find("\n0.15,") + 5] = '7'; // a digit that is none of ours, in the second chunk
    std::ofstream(path("run.csv.partial"), std::ios::binary) << written;
    const auto done = convertRecording({path("run.csv.partial"), path("run.csv"), {}, {}, {}});
    ASSERT_TRUE(done) << done.error().message;
    EXPECT_EQ(done->rows, 35U);
    EXPECT_GT(done->recovery->damagedOctets, 0U);
    const auto back = readRecordingFile(path("run.csv"));
    ASSERT_TRUE(back);
    ASSERT_EQ(back->meta.gaps.size(), 1U) << "ten rows, marked as a gap";
    EXPECT_EQ(back->meta.gaps[0].lostRows, 10U);
    // Ten rows are in nobody's file but this one.
    std::ifstream kept(path("run.csv.partial"), std::ios::binary);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(kept), {}), written);
}

TEST_F(RecordingRecoveryTest, aDamagedOriginalReplacesNoOlderOne) {
    std::ofstream(path("run.csv.damaged")) << "older";
    std::ofstream(path("run.csv.partial")) << "newer";
    EXPECT_EQ(retirePartialRecording(path("run.csv.partial"), true), path("run.csv.damaged-2"));
    EXPECT_EQ(fs::file_size(path("run.csv.damaged")), 5U);
    EXPECT_EQ(retirePartialRecording(path("run.csv.partial"), false), "");
}

TEST_F(RecordingRecoveryTest, whatIsNoRowEndsWhatHasNoChecksum) {
    const std::string written = interruptFlushed(path("run.csv"), ramp(45));
    std::ofstream(path("run.csv.partial"), std::ios::binary) << written << "of an older file\n";
    const auto found = readPartialRecording(path("run.csv.partial"));
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(found->file.recording.rows(), 45U);
    EXPECT_EQ(found->uncheckedRows, 6U); // with the header, four chunks of ten lines
    EXPECT_EQ(found->damagedOctets, 17U) << "somebody may want to see it: the file is kept";
}

TEST_F(RecordingRecoveryTest, aRecordingFlushesWithChecksumsWhileItGoesOn) {
    const Recording part = ramp(10);
    WriterOptions options;
    options.flushInterval_s = 1e6;
    const auto writer = RecordingWriter::create(path("run.csv"), *part.layout, metaOf(part), options);
    ASSERT_TRUE(writer);
    ASSERT_TRUE((*writer)->append({part.layout, part.time_s, part.values, 0.0, 0}));
    ASSERT_TRUE((*writer)->abandon());
    const std::string written = contentOf(path("run.csv.partial"));
    EXPECT_EQ(contentOf(path("run.chunks.partial")), chunkLine({written.size(), crc32(written)}));
    ASSERT_TRUE(interrupt(path("run.csv"), part).size() > 0); // finds the first one
    EXPECT_TRUE(fs::exists(path("run.interrupted.chunks.partial"))) << "its checksums went with it";
    EXPECT_FALSE(fs::exists(path("run.chunks.partial")));
}

TEST_F(RecordingRecoveryTest, aKillBetweenTheLastTwoStepsLosesNoSidecar) {
    const Recording part = ramp(10);
    ASSERT_TRUE(writeRecordingFile(path("run.csv"), part, metaOf(part)));
    fs::rename(path("run.meta.json"), completeMetaPathOf(path("run.csv")));
    const auto back = readRecordingFile(path("run.csv"));
    ASSERT_TRUE(back);
    EXPECT_TRUE(back->hasMeta);
    EXPECT_TRUE(back->warnings.empty());
}

TEST_F(RecordingRecoveryTest, droppedRowsTagsAndNotesAreKeptThroughMdf4) {
    const Recording part = ramp(10);
    RecordingMeta meta = metaOf(part);
    meta.period_s = 0.01;
    meta.droppedRows = 12;
    meta.tags = {"cold", "new bearing"};
    meta.notes = "first line\nsecond & <last>";
    ASSERT_TRUE(writeRecordingFile(path("in.csv"), part, meta));
    ASSERT_TRUE(convertRecording({path("in.csv"), path("run.mf4"), {}, {}, {}}));
    ASSERT_TRUE(convertRecording({path("run.mf4"), path("out.csv"), {}, {}, {}}));
    EXPECT_EQ(contentOf(path("out.meta.json")), contentOf(path("in.meta.json")));
    const auto back = readRecordingFile(path("out.csv"));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->meta.droppedRows, 12U);
    EXPECT_EQ(back->meta.tags, meta.tags);
    EXPECT_EQ(back->meta.notes, meta.notes);
}

TEST_F(RecordingRecoveryTest, aFileShorterThanItsFirstChunkIsNotEmpty) {
    const std::string written = interrupt(path("run.csv"), ramp(45));
    std::ofstream(journalPathOf(path("run.csv")), std::ios::binary)
        << chunkLine({written.size(), crc32(written)});
    std::ofstream(path("run.csv.partial"), std::ios::binary) << written.substr(0, written.find("\n0.2,") + 3);
    const auto found = readPartialRecording(path("run.csv.partial"));
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(found->file.recording.rows(), 20U);
    EXPECT_EQ(found->uncheckedRows, 20U);
}

TEST_F(RecordingRecoveryTest, onlyAFileWithoutARowCanBeRemoved) {
    const std::string written = interruptFlushed(path("run.csv"), ramp(5)); // shorter than a chunk
    std::ofstream(journalPathOf(path("run.csv")), std::ios::binary) << chunkLine({written.size(), 1});
    const auto damaged = readPartialRecording(path("run.csv.partial"));
    ASSERT_FALSE(damaged);
    EXPECT_EQ(damaged.error().hint.find("can be removed"), std::string::npos) << damaged.error().hint;
    EXPECT_NE(damaged.error().hint.find("run.chunks.partial"), std::string::npos) << damaged.error().hint;
    fs::remove(journalPathOf(path("run.csv")));
    EXPECT_TRUE(readPartialRecording(path("run.csv.partial"))) << "as the hint says";
    std::ofstream(path("run.csv.partial"), std::ios::binary) << written.substr(0, written.find('\n') + 3);
    const auto empty = readPartialRecording(path("run.csv.partial"));
    ASSERT_FALSE(empty);
    EXPECT_NE(empty.error().hint.find("can be removed"), std::string::npos) << empty.error().hint;
}

} // namespace
} // namespace halbench::devices
