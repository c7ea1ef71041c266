#include "app/recordings/run_comparison.h"
#include "devices/recording/recording_writer.h"
#include "tests/app/experiments/compared_run.h"

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

#include <limits>

namespace halbench::app {
namespace {

TEST(RunComparison, zeroIsTheFirstRowTheTriggerOrAMarker) {
    ComparedRun run = runOf("a", -0.25);
    EXPECT_EQ(alignedZero_s(run, {}), -0.25);
    EXPECT_FALSE(alignedZero_s(run, {RunAlignment::Moment::Trigger, {}}));
    run.meta.markers = {{0.0, "record"}, {0.4, "knock"}, {0.5, "knock"}};
    EXPECT_EQ(alignedZero_s(run, {RunAlignment::Moment::Trigger, {}}), 0.0) << "Record was pressed";
    run.meta.markers.push_back({0.1, "trigger"});
    EXPECT_EQ(alignedZero_s(run, {RunAlignment::Moment::Trigger, {}}), 0.1);
    EXPECT_EQ(alignedZero_s(run, {RunAlignment::Moment::Marker, "knock"}), 0.4) << "the first of them";
    EXPECT_FALSE(alignedZero_s(run, {RunAlignment::Moment::Marker, "none"}));
}

TEST(RunComparison, onlyWhatAllRunsHaveIsOffered) {
    ComparedRun one = runOf("a", 0.0);
    ComparedRun two = runOf("b", 0.0);
    two.recording.layout =
        std::make_shared<const StreamLayout>(StreamLayout{{{"hall.a", "T"}, {"position", "rad"}}, 0.01});
    one.meta.markers = {{0.1, "x"}, {0.2, "x"}, {0.3, "y"}};
    two.meta.markers = {{0.5, "x"}};
    EXPECT_EQ(commonSignals({one, two}), (std::vector<std::string>{"position"}));
    EXPECT_EQ(commonMarkers({one, two}), (std::vector<std::string>{"x"}));
    EXPECT_TRUE(commonSignals({}).empty());
    EXPECT_TRUE(commonMarkers({}).empty());
}

TEST(RunComparison, theCursorReadsTheNearestSampleAndNothingInAGap) {
    ComparedRun run = runOf("a", 5.0);
    EXPECT_NEAR(valueAt(run, "position", 5.0, 0.204).value_or(-1.0), 5.20, 1e-9);
    EXPECT_NEAR(valueAt(run, "position", 5.0, 0.206).value_or(-1.0), 5.21, 1e-9);
    EXPECT_FALSE(valueAt(run, "position", 5.0, -0.1));
    EXPECT_FALSE(valueAt(run, "position", 5.0, 1.2));
    EXPECT_FALSE(valueAt(run, "none", 5.0, 0.2));
    for (std::size_t row = 50; row < 100; ++row) {
        run.recording.time_s[row] += 1.0;
    }
    EXPECT_FALSE(valueAt(run, "position", 5.0, 1.0));
    run.recording.values[0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(valueAt(run, "position", 5.0, 0.0));
}

class RunFiles : public testing::Test {
protected:
    std::string write(const QString& name, int rows) {
        Recording recording = runOf("", 0.0).recording;
        recording.time_s.resize(static_cast<std::size_t>(rows));
        recording.values.resize(2 * static_cast<std::size_t>(rows));
        const std::string path = folder.filePath(name + ".csv").toStdString();
        EXPECT_TRUE(devices::writeRecordingFile(path, recording, {}));
        return path;
    }
    QTemporaryDir folder;
};

TEST_F(RunFiles, runsAreReadInTheirOrderAndWhatCannotBeIsSaid) {
    const std::string long_ = write("long", 100);
    const ReadRuns read = readRuns({write("short", 50), "none.csv", long_, write("empty", 0)});
    ASSERT_EQ(read.runs.size(), 2U);
    EXPECT_EQ(read.runs[0].name, "short");
    EXPECT_EQ(read.runs[1].recording.rows(), 100U);
    ASSERT_EQ(read.refused.size(), 2U);
    EXPECT_EQ(read.refused[0].code, ErrorCode::FileSystem);
    EXPECT_NE(read.refused[1].message.find("no rows"), std::string::npos) << read.refused[1].message;
}

TEST_F(RunFiles, whatDoesNotFitBesideTheOthersIsRefused) {
    const std::string one = write("one", 100);
    const std::string two = write("two", 50);
    const std::string three = write("three", 10);
    // two signals and the time: 300, 150 and 30 numbers
    const ReadRuns read = readRuns({one, two, three}, {}, 330);
    ASSERT_EQ(read.runs.size(), 2U);
    EXPECT_EQ(read.runs[1].name, "three");
    ASSERT_EQ(read.refused.size(), 1U);
    EXPECT_EQ(read.refused[0].code, ErrorCode::OutOfRange);
    EXPECT_EQ(readRuns({one}, {}, 10).runs.size(), 1U) << "one alone always fits";
}

TEST_F(RunFiles, readingEndsWhenNobodyWaitsForIt) {
    const auto stop = [] { return Result<void>(failure(ErrorCode::Interrupted, "enough", "")); };
    EXPECT_TRUE(readRuns({write("run", 100)}, stop).runs.empty());
}

} // namespace
} // namespace halbench::app
