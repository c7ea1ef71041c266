#include "devices/formats/convert_recording.h"
#include "devices/formats/recording_file.h"
#include "tests/devices/recording/recording_folder.h"
#include "tests/devices/recording/recording_sample.h"
#include "tests/small_disk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace halbench::devices {
namespace {

namespace fs = std::filesystem;

class ConvertRecordingTest : public RecordingFolder {};

TEST_F(ConvertRecordingTest, keepsTheSignalsAndTheIntervalAskedFor) {
    const Recording recording = ramp(100);
    RecordingMeta meta = metaOf(recording);
    meta.markers = {{0.1, "before"}, {0.2, "first"}, {0.495, "last"}, {0.5, "behind"}};
    ASSERT_TRUE(writeRecordingFile(path("in.csv"), recording, meta));
    const auto rows =
        convertRecording({path("in.csv"), path("out.csv"), {"hall.a", "position_rad"}, 0.2, 0.5});
    ASSERT_TRUE(rows) << rows.error().message;
    EXPECT_EQ(rows->rows, 30U); // 0.20 ... 0.49
    EXPECT_FALSE(rows->recovery);
    const auto back = readRecordingFile(path("out.csv"));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->recording.layout->columns[0].name, "hall.a");
    EXPECT_EQ(back->recording.layout->columns[1].name, "position");
    EXPECT_DOUBLE_EQ(back->recording.time_s.front(), 0.2);
    EXPECT_DOUBLE_EQ(back->recording.time_s.back(), 0.49);
    EXPECT_EQ(back->recording.values[1], 10.0);
    ASSERT_EQ(back->meta.markers.size(), 2U) << "those of the interval";
    EXPECT_EQ(back->meta.markers[0].text, "first");
    EXPECT_EQ(back->meta.markers[1].text, "last");
}

TEST_F(ConvertRecordingTest, throughMdf4AndBackEveryOctetIsTheSame) {
    Recording recording = ramp(300);
    for (std::size_t row = 100; row < 300; ++row) { // a gap and a value that is missing
        recording.time_s[row] += 0.05;
    }
    recording.values[31] = std::nan("");
    RecordingMeta meta = metaOf(recording);
    meta.period_s = 0.01;
    meta.markers = {{1.0 / 3.0, "here & <there>"}};
    meta.changes = {{0.1, "gain.kp", 0.1}};
    ASSERT_TRUE(writeRecordingFile(path("in.csv"), recording, meta));
    ASSERT_TRUE(convertRecording({path("in.csv"), path("deep/run.mf4"), {}, {}, {}}));
    ASSERT_TRUE(convertRecording({path("deep/run.mf4"), path("out.csv"), {}, {}, {}}));
    EXPECT_EQ(contentOf(path("out.csv")), contentOf(path("in.csv")));
    EXPECT_EQ(contentOf(path("out.meta.json")), contentOf(path("in.meta.json")));
    EXPECT_FALSE(fs::exists(path("deep/run.meta.json"))) << "all of it is in the one file";
    const auto part = convertRecording({path("deep/run.mf4"), path("part.mf4"), {"hall_a_T"}, 0.2, 0.3});
    ASSERT_TRUE(part) << part.error().message;
    EXPECT_EQ(part->rows, 10U);
    EXPECT_EQ(readRecordingFile(path("part.mf4"))->recording.layout->columns[0].name, "hall.a");
}

TEST_F(ConvertRecordingTest, aFullDiskLeavesNoMdf4) {
    const Recording large = ramp(5000);
    ASSERT_TRUE(writeRecordingFile(path("in.csv"), large, metaOf(large)));
    fs::create_directory(path("out"));
    {
        const SmallDisk disk(20000);
        const auto done = convertRecording({path("in.csv"), path("out/run.mf4"), {}, {}, {}});
        ASSERT_FALSE(done);
        EXPECT_EQ(done.error().code, ErrorCode::FileSystem);
    }
    EXPECT_TRUE(fs::is_empty(path("out")));
}

TEST_F(ConvertRecordingTest, refusesWhatItCannotDo) {
    const Recording recording = ramp(10);
    ASSERT_TRUE(writeRecordingFile(path("in.csv"), recording, metaOf(recording)));
    const auto code = [&](const ConvertRequest& request) {
        const auto done = convertRecording(request);
        return done ? ErrorCode::Internal : done.error().code;
    };
    EXPECT_EQ(code({path("in.csv"), path("out.xls"), {}, {}, {}}), ErrorCode::Usage);
    EXPECT_EQ(code({path("in.xls"), path("out.csv"), {}, {}, {}}), ErrorCode::Usage);
    EXPECT_EQ(code({path("none.mf4"), path("out.csv"), {}, {}, {}}), ErrorCode::FileSystem);
    EXPECT_EQ(code({path("in.csv"), path("out.csv.partial"), {}, {}, {}}), ErrorCode::Usage);
    EXPECT_EQ(code({path("in.csv"), path("out.csv"), {"unknown"}, {}, {}}), ErrorCode::UnknownName);
    EXPECT_EQ(code({path("in.csv"), path("out.csv"), {}, 5.0, {}}), ErrorCode::OutOfRange);
    EXPECT_EQ(code({path("none.csv"), path("out.csv"), {}, {}, {}}), ErrorCode::FileSystem);
    EXPECT_FALSE(fs::exists(path("out.csv")));
}

} // namespace
} // namespace halbench::devices
