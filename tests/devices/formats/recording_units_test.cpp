#include "control/base/units.h"
#include "devices/formats/mdf4_writer.h"
#include "devices/formats/recording_units.h"
#include "tests/devices/recording/recording_folder.h"
#include "tests/devices/recording/recording_sample.h"

#include <gtest/gtest.h>

#include <fstream>

namespace halbench::devices {
namespace {

class RecordingUnits : public RecordingFolder {
protected:
    Result<RecordedFile> read(const std::string& header, const std::string& row = "0,90") {
        std::ofstream(path("run.csv")) << header << '\n' << row << '\n';
        return readRecordingFile(path("run.csv"));
    }
};

TEST_F(RecordingUnits, knownColumnsAreConvertedToSi) {
    struct Case {
        const char* column;
        const char* signal;
        const char* unit;
        double value; ///< of 90 written
    };
    for (const Case& one :
         {Case{"position_deg", "position", "rad", Pi / 2.0}, Case{"position_mrad", "position", "rad", 0.09},
          Case{"position_rev", "position", "rad", 180.0 * Pi},
          Case{"position [deg]", "position", "rad", Pi / 2.0}, Case{"speed_rpm", "speed", "rad/s", 3.0 * Pi},
          Case{"speed_deg_s", "speed", "rad/s", Pi / 2.0},
          Case{"speed_deg_per_s", "speed", "rad/s", Pi / 2.0},
          Case{"speed_r_min", "speed", "rad/s", 3.0 * Pi},
          Case{"current_command_mA", "current_command", "A", 0.09}, Case{"hall_a_mT", "hall.a", "T", 0.09},
          Case{"hall.b_G", "hall.b", "T", 9e-3}, Case{"reference_deg", "reference", "rad", Pi / 2.0},
          Case{"truth_position_deg", "truth.position", "rad", Pi / 2.0},
          Case{"coil_temperature_a_K", "coil_temperature.a", "degC", 90.0 - 273.15}}) {
        const auto file = read(std::string("time_s,") + one.column);
        ASSERT_TRUE(file) << one.column << ": " << file.error().message;
        EXPECT_EQ(file->recording.layout->columns[0].name, one.signal) << one.column;
        EXPECT_EQ(file->recording.layout->columns[0].unit, one.unit) << one.column;
        // one product and one quotient are rounded
        EXPECT_NEAR(file->recording.values[0], one.value, 1e-13 * std::abs(one.value)) << one.column;
        EXPECT_TRUE(file->warnings.empty()) << one.column;
    }
}

TEST_F(RecordingUnits, anotherQuantityIsRefusedNamingTheColumn) {
    for (const char* column :
         {"position_mm", "position_A", "position [furlong]", "speed_deg", "current_command_V", "hall_a_deg",
          "coil_temperature_a_deg", "position_counts", "reference_grad"}) {
        const auto file = read(std::string("time_s,") + column);
        ASSERT_FALSE(file) << column;
        EXPECT_EQ(file.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(file.error().message.find(column), std::string::npos) << file.error().message;
    }
}

TEST_F(RecordingUnits, otherSignalsKeepTheirNames) {
    for (const char* column :
         {"position_filtered", "speed_min", "position_error_deg", "temp_deg", "arr[0]"}) {
        const auto file = read(std::string("time_s,") + column);
        ASSERT_TRUE(file) << column << ": " << file.error().message;
        EXPECT_EQ(file->recording.values[0], 90.0) << column;
    }
}

TEST_F(RecordingUnits, aMissingUnitIsSaid) {
    const auto file = read("time_s,position");
    ASSERT_TRUE(file);
    EXPECT_EQ(file->recording.values[0], 90.0);
    ASSERT_EQ(file->warnings.size(), 1U);
    EXPECT_NE(file->warnings[0].find("position"), std::string::npos);
}

/// A board that measures in degrees, or in what is no angle at all, tells so in the sidecar or MDF4 file.
TEST_F(RecordingUnits, unitsOfTheSidecarAreConvertedWhereTheyCanBe) {
    Recording recording;
    recording.layout = std::make_shared<const StreamLayout>(
        StreamLayout{{{"position", "deg"}, {"speed", "rpm"}, {"reference", "mm"}}, 0.01});
    recording.time_s = {0.0, 0.01};
    recording.values = {90.0, 60.0, 1.0, 180.0, 30.0, 2.0};
    ASSERT_TRUE(writeRecordingFile(path("board.csv"), recording, metaOf(recording)));
    ASSERT_TRUE(writeMdf4File(path("board.mf4"), recording, metaOf(recording)));
    for (const char* name : {"board.csv", "board.mf4"}) {
        const auto file = readRecordingFile(path(name));
        ASSERT_TRUE(file) << file.error().message;
        EXPECT_DOUBLE_EQ(file->recording.column("position")[1], Pi) << name;
        EXPECT_DOUBLE_EQ(file->recording.column("speed")[0], 2.0 * Pi) << name;
        EXPECT_EQ(file->recording.column("reference")[1], 2.0) << name;
        EXPECT_EQ(file->recording.layout->columns[2].unit, "mm") << name;
        EXPECT_EQ(file->meta.signals[0].unit, "rad") << name;
        EXPECT_EQ(file->meta.signals[0].column, "position_rad") << name;
    }
}

TEST_F(RecordingUnits, aSidecarThatContradictsItsColumnIsRefused) {
    const Recording recording = ramp(3);
    RecordingMeta meta = metaOf(recording);
    ASSERT_TRUE(writeRecordingFile(path("run.csv"), recording, meta));
    std::string text = contentOf(path("run.meta.json"));
    text.replace(text.find("\"unit\": \"rad\""), 13, "\"unit\": \"deg\"");
    std::ofstream(path("run.meta.json")) << text;
    const auto file = readRecordingFile(path("run.csv"));
    ASSERT_FALSE(file);
    EXPECT_NE(file.error().message.find("signals[0].unit"), std::string::npos) << file.error().message;
}

/// Names that differ in nothing that a column's name can show.
TEST_F(RecordingUnits, namesThatMeetInAFileComeBack) {
    Recording recording;
    recording.layout = std::make_shared<const StreamLayout>(StreamLayout{
        {{"a.b", ""}, {"a_b", ""}, {"time_s", ""}, {"time", "s"}, {"x.y", "A"}, {"x_y", "A"}, {"x_y_2", "A"}},
        0.01});
    recording.time_s = {0.0, 0.01};
    recording.values = {1, 2, 3, 4, 5, 6, 7, 1, 2, 3, 4, 5, 6, 7};
    ASSERT_TRUE(writeRecordingFile(path("meet.csv"), recording, metaOf(recording)));
    ASSERT_TRUE(writeMdf4File(path("meet.mf4"), recording, metaOf(recording)));
    EXPECT_EQ(contentOf(path("meet.csv")).substr(0, contentOf(path("meet.csv")).find('\n')),
              "time_s,a_b,a_b_2,time_s_2,time_2_s,x_y_A,x_y_2_A,x_y_2_2_A");
    for (const char* name : {"meet.csv", "meet.mf4"}) {
        const auto file = readRecordingFile(path(name));
        ASSERT_TRUE(file) << name << ": " << file.error().message;
        ASSERT_EQ(file->recording.layout->columns.size(), 7U);
        for (std::size_t i = 0; i < 7; ++i) {
            EXPECT_EQ(file->recording.layout->columns[i].name, recording.layout->columns[i].name) << name;
            EXPECT_EQ(file->recording.layout->columns[i].unit, recording.layout->columns[i].unit) << name;
        }
    }
}

} // namespace
} // namespace halbench::devices
