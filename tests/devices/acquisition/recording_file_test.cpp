#include "devices/acquisition/convert_recording.h"
#include "devices/acquisition/recording_csv.h"
#include "devices/acquisition/recording_file.h"

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace halbench::devices {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

Recording ramp(std::size_t rows, double period_s = 0.01) {
    Recording recording;
    recording.layout = std::make_shared<const StreamLayout>(
        StreamLayout{{{"position", "rad"}, {"hall.a", "T"}, {"status", ""}}, period_s});
    for (std::size_t row = 0; row < rows; ++row) {
        recording.time_s.push_back(static_cast<double>(row) / 100.0);
        recording.values.insert(recording.values.end(), {0.5 * static_cast<double>(row), 0.157, 1.0});
    }
    return recording;
}

RecordingMeta metaOf(const Recording& recording) {
    RecordingMeta meta;
    meta.device.model = "htm";
    meta.device.overrides = {{"c", "2e-3"}};
    meta.started = "1970-01-01T00:00:00Z";
    for (const StreamLayout::Column& column : recording.layout->columns) {
        meta.signals.push_back(
            {column.name, csvColumnName(column.name, column.unit), column.unit, column.name});
    }
    meta.parameters = {{"gain.kp", 10.0, "A/rad"}};
    return meta;
}

class RecordingFileTest : public testing::Test {
protected:
    std::string path(const std::string& name) const { return m_folder.filePath(name.c_str()).toStdString(); }
    QTemporaryDir m_folder;
};

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

TEST_F(RecordingFileTest, changedDataAreReadWithAWarning) {
    const Recording recording = ramp(3);
    ASSERT_TRUE(writeRecordingFile(path("run.csv"), recording, metaOf(recording)));
    std::ofstream(path("run.csv"), std::ios::app) << "0.03,1,2,3\n";
    const auto back = readRecordingFile(path("run.csv"));
    ASSERT_TRUE(back);
    ASSERT_EQ(back->warnings.size(), 1U);
    EXPECT_NE(back->warnings[0].find("SHA-256"), std::string::npos);
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

/// No file of this process may grow beyond the limit: what a full disk looks like to a writer.
class SmallDisk {
public:
    explicit SmallDisk(rlim_t octets) {
        getrlimit(RLIMIT_FSIZE, &m_before);
        m_handler = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit small{octets, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallDisk() {
        setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_handler);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

private:
    rlimit m_before{};
    void (*m_handler)(int) = nullptr;
};

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
    {
        auto writer = RecordingWriter::create(path("run.csv"), *part.layout, metaOf(part));
        ASSERT_TRUE(writer);
        ASSERT_TRUE((*writer)->append({part.layout, part.time_s, part.values, 0.0, 0}));
    } // the program ends here
    EXPECT_FALSE(fs::exists(path("run.csv")));
    std::ofstream(path("run.csv.partial"), std::ios::app) << "0.1,5,0.1";
    const auto rows = recoverRecording(path("run.csv"));
    ASSERT_TRUE(rows) << rows.error().message;
    EXPECT_EQ(*rows, 10U);
    const auto back = readRecordingFile(path("run.csv"));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->recording.values, part.values);
    EXPECT_EQ(back->meta.parameters.size(), 1U);
    EXPECT_EQ(back->recording.layout->columns[1].name, "hall.a");
    EXPECT_FALSE(fs::exists(path("run.csv.partial")));
}

TEST_F(RecordingFileTest, convertKeepsTheSignalsAndTheIntervalAskedFor) {
    const Recording recording = ramp(100);
    ASSERT_TRUE(writeRecordingFile(path("in.csv"), recording, metaOf(recording)));
    const auto rows =
        convertRecording({path("in.csv"), path("out.csv"), {"hall.a", "position_rad"}, 0.2, 0.5});
    ASSERT_TRUE(rows) << rows.error().message;
    EXPECT_EQ(*rows, 30U); // 0.20 ... 0.49
    const auto back = readRecordingFile(path("out.csv"));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->recording.layout->columns[0].name, "hall.a");
    EXPECT_EQ(back->recording.layout->columns[1].name, "position");
    EXPECT_DOUBLE_EQ(back->recording.time_s.front(), 0.2);
    EXPECT_DOUBLE_EQ(back->recording.time_s.back(), 0.49);
    EXPECT_EQ(back->recording.values[1], 10.0);
}

TEST_F(RecordingFileTest, convertRefusesWhatItCannotDo) {
    const Recording recording = ramp(10);
    ASSERT_TRUE(writeRecordingFile(path("in.csv"), recording, metaOf(recording)));
    const auto code = [&](const ConvertRequest& request) {
        const auto done = convertRecording(request);
        return done ? ErrorCode::Internal : done.error().code;
    };
    EXPECT_EQ(code({path("in.csv"), path("out.mat"), {}, {}, {}}), ErrorCode::Usage);
    EXPECT_EQ(code({path("in.csv"), path("out.csv"), {"unknown"}, {}, {}}), ErrorCode::UnknownName);
    EXPECT_EQ(code({path("in.csv"), path("out.csv"), {}, 5.0, {}}), ErrorCode::OutOfRange);
    EXPECT_EQ(code({path("none.csv"), path("out.csv"), {}, {}, {}}), ErrorCode::FileSystem);
    EXPECT_FALSE(fs::exists(path("out.csv")));
}

} // namespace
} // namespace halbench::devices
