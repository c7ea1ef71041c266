#include "devices/formats/convert_recording.h"
#include "devices/formats/recording_file.h"
#include "devices/recording/recording_csv.h"
#include "devices/recording/recording_writer.h"
#include "tests/devices/recording/recording_folder.h"
#include "tests/devices/recording/recording_sample.h"
#include "tests/small_disk.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace halbench::devices {
namespace {

namespace fs = std::filesystem;

class RecordingFileTest : public RecordingFolder {};

TEST_F(RecordingFileTest, comesBackWithNamesUnitsRolesAndParameters) {
    const Recording recording = ramp(20);
    const std::string file = path("new/folder/run.csv");
    ASSERT_TRUE(writeRecordingFile(file, recording, metaOf(recording)));
    EXPECT_TRUE(fs::exists(path("new/folder/run.meta.json")));
    EXPECT_FALSE(fs::exists(file + ".partial"));
    const auto back = readRecordingFile(file);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_TRUE(back->hasMeta);
    EXPECT_TRUE(back->warnings.empty());
    EXPECT_EQ(back->recording.time_s, recording.time_s);
    EXPECT_EQ(back->recording.values, recording.values);
    EXPECT_EQ(back->recording.layout->columns[1].name, "hall.a");
    EXPECT_EQ(back->meta.device.overrides, (metaOf(recording).device.overrides));
    EXPECT_EQ(back->meta.parameters[0].value, 10.0);
    EXPECT_EQ(back->meta.rows, 20U);
}

/// Three hundred rows whose numbers have more digits than anybody needs: the file is long, reading it is not.
TEST_F(RecordingFileTest, moreThan256MegabytesAreRead) {
    {
        std::ofstream out(path("long.csv"));
        out << "time_s,hall_a_T\n";
        const std::string zeros(900'000, '0');
        for (int row = 0; row < 300; ++row) {
            out << row << ',' << row << ".5" << zeros << '\n';
        }
    }
    ASSERT_GT(fs::file_size(path("long.csv")), std::uintmax_t{256} << 20U);
    const Result<RecordedFile> file = readRecordingFile(path("long.csv"));
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_EQ(file->recording.rows(), 300U);
    EXPECT_EQ(file->recording.values[299], 299.5);
    ConvertRequest request;
    request.input = path("long.csv");
    request.output = path("short.csv");
    ASSERT_TRUE(convertRecording(request));
    EXPECT_LT(fs::file_size(path("short.csv")), 10'000U);
}

TEST_F(RecordingFileTest, sidecarHoldsTheSha256OfTheData) {
    // printf 'time_s\n0\n' | sha256sum
    Recording recording;
    recording.layout = std::make_shared<const StreamLayout>();
    recording.time_s = {0.0};
    ASSERT_TRUE(writeRecordingFile(path("run.csv"), recording, {}));
    ASSERT_EQ(contentOf(path("run.csv")), "time_s\n0\n");
    EXPECT_NE(contentOf(path("run.meta.json"))
                  .find("c7798a6c64de90895baf9326fe413fb9b6a5678755effc45916142d4687e1762"),
              std::string::npos);
}

TEST_F(RecordingFileTest, namesByADescriptionOfAnotherFirmwareAreDoubtedInTheFileAndByItsReaders) {
    const Recording recording = ramp(20);
    for (const char* other : {"", "1.0"}) {
        RecordingMeta meta = metaOf(recording);
        meta.device.firmware = "1.1";
        meta.device.otherFirmware = other;
        ASSERT_TRUE(writeRecordingFile(path("run.csv"), recording, meta));
        ConvertRequest request;
        request.input = path("run.csv");
        request.output = path(other + std::string("run.mf4"));
        ASSERT_TRUE(convertRecording(request));
        for (const std::string& file : {request.input, request.output}) {
            const auto back = readRecordingFile(file);
            ASSERT_TRUE(back) << back.error().message;
            EXPECT_EQ(back->meta.device.otherFirmware, other) << file;
            const auto told = std::count_if(back->warnings.begin(), back->warnings.end(), isFirmwareWarning);
            EXPECT_EQ(told, *other == '\0' ? 0 : 1) << file;
        }
    }
    RecordingMeta meta = metaOf(recording);
    meta.device.otherFirmware = "1.0";
    const std::string text = toMetaJson(meta);
    EXPECT_NE(text.find("\"verdict\": \"doubtful\""), std::string::npos) << text;
    EXPECT_NE(text.find("its description was of '1.0'"), std::string::npos) << text;
    meta.device.otherFirmware.clear();
    EXPECT_EQ(toMetaJson(meta).find("data_quality"), std::string::npos);
}

TEST_F(RecordingFileTest, changedDataAreReadWithAWarning) {
    const Recording recording = ramp(3);
    ASSERT_TRUE(writeRecordingFile(path("run.csv"), recording, metaOf(recording)));
    std::ofstream(path("run.csv"), std::ios::app) << "0.03,1,2,3\n";
    const auto back = readRecordingFile(path("run.csv"));
    ASSERT_TRUE(back);
    ASSERT_EQ(back->warnings.size(), 1U);
    EXPECT_NE(back->warnings[0].find("SHA-256"), std::string::npos);
}

TEST_F(RecordingFileTest, ofACutFileItIsSaidHowMuchIsThereAndAConversionSaysItToo) {
    const Recording recording = ramp(50);
    ASSERT_TRUE(writeRecordingFile(path("run.csv"), recording, metaOf(recording)));
    const std::string written = contentOf(path("run.csv"));
    std::ofstream(path("run.csv"), std::ios::binary) << written.substr(0, written.find("\n0.2,") + 1);
    const auto back = readRecordingFile(path("run.csv"));
    ASSERT_TRUE(back);
    ASSERT_EQ(back->warnings.size(), 1U);
    EXPECT_NE(back->warnings[0].find("20 of 50 rows"), std::string::npos) << back->warnings[0];
    const auto done = convertRecording({path("run.csv"), path("out.csv"), {}, {}, {}});
    ASSERT_TRUE(done) << done.error().message;
    EXPECT_EQ(done->warnings, back->warnings);
    EXPECT_TRUE(readRecordingFile(path("out.csv"))->warnings.empty()) << "it is what was written";
}

TEST_F(RecordingFileTest, withoutSidecarKnownColumnsGetTheirSignalNames) {
    std::ofstream(path("run.csv")) << "time_s,coil_temperature_a_degC,my_own_A\n0,25,1\n";
    const auto back = readRecordingFile(path("run.csv"));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->recording.layout->columns[0].name, "coil_temperature.a");
    EXPECT_EQ(back->recording.layout->columns[1].name, "my_own");
    EXPECT_EQ(back->recording.layout->columns[1].unit, "A");
}

TEST_F(RecordingFileTest, gapsAreNotedWithTheirTime) {
    Recording recording = ramp(10);
    for (std::size_t row = 5; row < 10; ++row) {
        recording.time_s[row] += 0.03;
    }
    ASSERT_TRUE(writeRecordingFile(path("run.csv"), recording, metaOf(recording)));
    const auto back = readRecordingFile(path("run.csv"));
    ASSERT_TRUE(back);
    ASSERT_EQ(back->meta.gaps.size(), 1U);
    EXPECT_EQ(back->meta.gaps[0].lostRows, 3U);
    EXPECT_DOUBLE_EQ(back->meta.gaps[0].time_s, 0.08);
}

TEST_F(RecordingFileTest, anUnwritableFolderIsAClearError) {
    std::ofstream(path("file")) << "x"; // a file where a folder is needed: fails for root as well
    const Recording recording = ramp(3);
    const auto written = writeRecordingFile(path("file/run.csv"), recording, metaOf(recording));
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::FileSystem);
    EXPECT_NE(written.error().message.find("file"), std::string::npos);
    EXPECT_FALSE(written.error().hint.empty());
}

TEST_F(RecordingFileTest, aFullDiskLeavesTheOldFileAndNothingElse) {
    const Recording small = ramp(3);
    ASSERT_TRUE(writeRecordingFile(path("run.csv"), small, metaOf(small)));
    const std::string before = contentOf(path("run.csv"));
    const Recording large = ramp(5000);
    Result<void> written;
    {
        const SmallDisk disk(20000);
        written = writeRecordingFile(path("run.csv"), large, metaOf(large));
    }
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::FileSystem);
    EXPECT_EQ(contentOf(path("run.csv")), before);
    EXPECT_FALSE(fs::exists(path("run.csv.partial")));
    EXPECT_FALSE(fs::exists(path("run.meta.json.partial")));
}

TEST_F(RecordingFileTest, aWriterOnAFullDiskRepeatsItsErrorAndNeverFinishes) {
    const Recording part = ramp(3000);
    auto writer = RecordingWriter::create(path("run.csv"), *part.layout, metaOf(part));
    ASSERT_TRUE(writer);
    SampleBlock block{part.layout, part.time_s, part.values, 0.0, 0};
    Result<void> appended;
    {
        const SmallDisk disk(20000);
        appended = (*writer)->append(block);
    }
    ASSERT_FALSE(appended);
    EXPECT_FALSE((*writer)->finish());
    EXPECT_FALSE(fs::exists(path("run.csv")));
}

TEST_F(RecordingFileTest, anInterruptedRecordingIsRecoveredUpToItsLastWholeLine) {
    const Recording part = ramp(10);
    interrupt(path("run.csv"), part);
    EXPECT_FALSE(fs::exists(path("run.csv")));
    std::ofstream(path("run.csv.partial"), std::ios::app) << "0.1,5,0.1";
    const auto done = convertRecording({path("run.csv.partial"), path("run.csv"), {}, {}, {}});
    ASSERT_TRUE(done) << done.error().message;
    EXPECT_EQ(done->rows, 10U);
    ASSERT_TRUE(done->recovery);
    EXPECT_EQ(done->recovery->cutOctets, 9U);
    EXPECT_DOUBLE_EQ(done->recovery->duration_s, 0.09);
    const auto back = readRecordingFile(path("run.csv"));
    ASSERT_TRUE(back);
    EXPECT_TRUE(back->warnings.empty()) << "the sidecar's SHA-256 is that of the recovered data";
    EXPECT_EQ(back->recording.values, part.values);
    EXPECT_EQ(back->meta.parameters.size(), 1U);
    EXPECT_EQ(back->recording.layout->columns[1].name, "hall.a");
    ASSERT_EQ(back->meta.markers.size(), 1U);
    EXPECT_EQ(back->meta.markers[0].text, "recording interrupted");
    EXPECT_DOUBLE_EQ(back->meta.markers[0].time_s, 0.09);
    EXPECT_FALSE(fs::exists(path("run.csv.partial"))) << "it has become run.csv";
    EXPECT_FALSE(fs::exists(path("run.meta.json.partial")));
}

TEST_F(RecordingFileTest, anInterruptionAtAnyByteLosesNoWholeRow) {
    const Recording part = ramp(5);
    const std::string written = interrupt(path("run.csv"), part);
    const std::size_t header = written.find('\n') + 1;
    for (std::size_t size = 0; size <= written.size(); ++size) {
        std::ofstream(path("run.csv.partial"), std::ios::binary) << written.substr(0, size);
        const auto found = readPartialRecording(path("run.csv.partial"));
        const auto lines = static_cast<std::size_t>(
            std::count(written.begin(), written.begin() + static_cast<long>(size), '\n'));
        ASSERT_EQ(found.has_value(), lines > 1) << size;
        if (!found) {
            EXPECT_EQ(found.error().code, ErrorCode::InvalidInput);
            EXPECT_FALSE(found.error().hint.empty());
            continue;
        }
        EXPECT_EQ(found->file.recording.rows(), lines - 1) << size;
        EXPECT_EQ(found->cutOctets, size - written.rfind('\n', size - 1) - 1) << size;
        EXPECT_TRUE(std::equal(found->file.recording.values.begin(), found->file.recording.values.end(),
                               part.values.begin()));
    }
    EXPECT_GT(written.size(), header);
}

TEST_F(RecordingFileTest, zerosThatAPowerLossLeftAreCutOff) {
    const std::string written = interrupt(path("run.csv"), ramp(5));
    std::ofstream(path("run.csv.partial"), std::ios::binary) << written + std::string(100, '\0') + "0,1\n";
    const auto found = readPartialRecording(path("run.csv.partial"));
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(found->file.recording.rows(), 5U);
    EXPECT_EQ(found->damagedOctets, 104U) << "there is something behind the zeros: the file is kept";
    std::ofstream(path("run.csv.partial"), std::ios::binary) << written + std::string(100, '\0');
    const auto zeros = readPartialRecording(path("run.csv.partial"));
    ASSERT_TRUE(zeros) << zeros.error().message;
    EXPECT_EQ(zeros->cutOctets, 100U);
    EXPECT_EQ(zeros->damagedOctets, 0U);
}

TEST_F(RecordingFileTest, aDamagedSidecarDoesNotStopARecovery) {
    interrupt(path("run.csv"), ramp(5));
    const std::string meta = contentOf(path("run.meta.json.partial"));
    std::ofstream(path("run.meta.json.partial")) << meta.substr(0, meta.size() / 2);
    const auto found = readPartialRecording(path("run.csv.partial"));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->file.recording.layout->columns[1].name, "hall.a") << "known by its column";
}

TEST_F(RecordingFileTest, recoveringUnderAnotherNameOrAPartLeavesThePartialFile) {
    const std::string written = interrupt(path("run.csv"), ramp(10));
    ASSERT_TRUE(convertRecording({path("run.csv.partial"), path("other.csv"), {}, {}, {}}));
    ASSERT_TRUE(convertRecording({path("run.csv.partial"), path("run.csv"), {"hall.a"}, {}, {}}));
    EXPECT_EQ(contentOf(path("run.csv.partial")), written);
    EXPECT_TRUE(fs::exists(path("run.meta.json.partial")));
}

TEST_F(RecordingFileTest, aFullDiskWhileRecoveringLosesNothing) {
    const std::string written = interrupt(path("run.csv"), ramp(3000));
    {
        const SmallDisk disk(20000);
        ASSERT_FALSE(convertRecording({path("run.csv.partial"), path("run.csv"), {}, {}, {}}));
    }
    EXPECT_EQ(contentOf(path("run.csv.partial")), written);
    EXPECT_FALSE(fs::exists(path("run.csv")));
    EXPECT_FALSE(fs::exists(path("run.csv.recovering")));
}

TEST_F(RecordingFileTest, anOldInterruptedRecordingIsMovedAsideNotLost) {
    const std::string first = interrupt(path("run.csv"), ramp(10));
    const std::string second = interrupt(path("run.csv"), ramp(20)); // finds the first one
    ASSERT_TRUE(writeRecordingFile(path("run.csv"), ramp(3), metaOf(ramp(3))));
    EXPECT_EQ(contentOf(path("run.interrupted.csv.partial")), first);
    EXPECT_EQ(contentOf(path("run.interrupted-2.csv.partial")), second);
    const auto back = readPartialRecording(path("run.interrupted.csv.partial"));
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_TRUE(back->file.hasMeta) << "its sidecar went with it";
    EXPECT_FALSE(fs::exists(path("run.csv.partial")));
}

TEST_F(RecordingFileTest, twoProgramsDoNotMixTheirRows) {
    const Recording part = ramp(3);
    const auto one = RecordingWriter::create(path("run.csv"), *part.layout, metaOf(part));
    ASSERT_TRUE(one);
    const auto two = RecordingWriter::create(path("run.csv"), *part.layout, metaOf(part));
    ASSERT_FALSE(two);
    EXPECT_EQ(two.error().code, ErrorCode::Usage);
    ASSERT_TRUE((*one)->append({part.layout, part.time_s, part.values, 0.0, 0}));
    EXPECT_TRUE((*one)->finish());
    EXPECT_EQ(readRecordingFile(path("run.csv"))->recording.rows(), 3U);
}

TEST_F(RecordingFileTest, anAbandonedRecordingStaysOnlyWhenItHasRows) {
    const Recording part = ramp(3);
    {
        const auto writer = RecordingWriter::create(path("run.csv"), *part.layout, metaOf(part));
        ASSERT_TRUE(writer);
        EXPECT_FALSE((*writer)->abandon());
    }
    EXPECT_TRUE(fs::is_empty(path("")));
    const auto writer = RecordingWriter::create(path("run.csv"), *part.layout, metaOf(part));
    ASSERT_TRUE((*writer)->append({part.layout, part.time_s, part.values, 0.0, 0}));
    EXPECT_TRUE((*writer)->abandon());
    EXPECT_TRUE(readPartialRecording(path("run.csv.partial")));
}

TEST_F(RecordingFileTest, aFileLargerThanMemoryIsRefusedUnread) {
    std::ofstream(path("large.mf4")) << "";
    fs::resize_file(path("large.mf4"), std::uintmax_t{1} << 40U); // takes no room on the disk
    const auto file = readRecordingFile(path("large.mf4"));
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().message, "'" + path("large.mf4") + "' has 1099511627776 bytes");
    EXPECT_NE(file.error().hint.find("--from"), std::string::npos);
    fs::rename(path("large.mf4"), path("large.csv"));
    EXPECT_NE(readTableText(path("large.csv")).error().hint.find("first line"), std::string::npos);
    // Of a recording the numbers count, and here is not one in a whole line.
    const auto rows = readRecordingFile(path("large.csv"));
    ASSERT_FALSE(rows);
    EXPECT_NE(rows.error().message.find("large.csv:1:1:"), std::string::npos) << rows.error().message;
}

} // namespace
} // namespace halbench::devices
