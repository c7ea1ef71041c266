// Steps of experiments that record.
#include "app/documents/text/output_file.h"
#include "app/experiments/run_files.h"
#include "app/experiments/run_plan.h"
#include "app/experiments/step_configs.h"
#include "app/headless/recording_file.h"
#include "devices/formats/recording_file.h"
#include "tests/app/experiments/experiment_fixture.h"

#include <cmath>
#include <filesystem>

namespace halbench::app {
namespace {

namespace fs = std::filesystem;

const std::string RecordThenSet = R"(schema = "halbench.experiment/1"
device = "sim:htm?imperfections=off"

[[step]]
kind = "record"
name = "rest"
duration_s = 0.5

[[step]]
kind = "move"
name = "stairs"
reference = { shape = "staircase", amplitude_deg = 5, count = 3, period_s = 0.2 }
duration_s = 0.8

[[step]]
kind = "set"
name = "stiffer"
values = { "gain.kp" = 12 }
)";

const std::string Triggered = R"(schema = "halbench.experiment/1"
device = "sim:htm?hall_noise_mT=2"

[[step]]
kind = "record"
name = "noise"
signals = ["position"]
duration_s = 0.2
trigger = "hall.a>0.157"
pre_trigger_s = 0.1
wait_s = 5
)";

double kpIn(const devices::RecordingMeta& meta) {
    for (const devices::RecordingMeta::ParameterNote& note : meta.parameters) {
        if (note.name == "gain.kp") {
            return note.value;
        }
    }
    return 0.0;
}

TEST_F(ExperimentRunner, aRecordingThatWaitsHasTheTimeBeforeTheEventAndItsMarker) {
    m_device = devices::openDevice("sim:htm?hall_noise_mT=2", {}).value();
    const fs::path folder = fs::path(::testing::TempDir()) / "halbench_triggered";
    fs::remove_all(folder);
    const RunOutcome outcome = run(Triggered, folder.string());
    ASSERT_FALSE(outcome.stoppedBy.has_value()) << outcome.stoppedBy->message;
    const double trigger_s = outcome.steps[0].body.find("trigger_s")->number();
    EXPECT_LE(trigger_s, 0.1 + 0.01); // the time before, to a row of 100 Hz
    const auto file = devices::readRecordingFile((folder / "noise.csv").string());
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_EQ(file->meta.markers.size(), 1U);
    EXPECT_EQ(file->meta.markers[0].text, "trigger");
    EXPECT_EQ(file->meta.markers[0].time_s, trigger_s);
    const std::vector<double> hall = file->recording.column("hall.a"); // recorded, though not named
    const auto row = static_cast<std::size_t>(std::ceil(trigger_s * 100.0 - 1e-6));
    ASSERT_LT(row, hall.size());
    ASSERT_GT(row, 0U);
    EXPECT_GE(hall[row], 0.157);
    EXPECT_LT(hall[row - 1], 0.157);
    EXPECT_NEAR(file->recording.time_s.back(), trigger_s + 0.2, 0.0101);
    const RunPlan plan = planRun(m_experiment, *m_device).value();
    EXPECT_EQ(plan.duration_s, 5.2) << "when it comes at the last moment";
}

TEST_F(ExperimentRunner, aTriggerThatDoesNotComeEndsTheRunAndAnUnknownSignalIsToldBefore) {
    const RunOutcome outcome = run(std::string(Triggered).replace(Triggered.find("0.157"), 5, "9"));
    ASSERT_TRUE(outcome.stoppedBy.has_value());
    EXPECT_EQ(outcome.stoppedBy->code, ErrorCode::Refused);
    EXPECT_NE(outcome.stoppedBy->hint.find("wait_s"), std::string::npos) << outcome.stoppedBy->hint;
    const auto wrong = parseExperiment(
        std::string(Triggered).replace(Triggered.find("hall.a>"), 7, "hall.z>"), "e.toml", {});
    ASSERT_TRUE(wrong);
    const Result<void> checked = checkAgainstDevice(*wrong, *m_device);
    ASSERT_FALSE(checked);
    EXPECT_EQ(checked.error().code, ErrorCode::UnknownName);
    EXPECT_NE(checked.error().message.find("e.toml:9:"), std::string::npos) << checked.error().message;
}

TEST_F(ExperimentRunner, recordingsTellTheParametersAtTheirStartAndTheSegmentsOfTheReference) {
    const fs::path folder = fs::path(::testing::TempDir()) / "halbench_recorded";
    fs::remove_all(folder);
    const RunOutcome outcome = run(RecordThenSet, folder.string());
    ASSERT_FALSE(outcome.stoppedBy.has_value()) << outcome.stoppedBy->message;
    EXPECT_TRUE(fs::exists(folder / "rest.csv")) << "written while it recorded";
    EXPECT_FALSE(fs::exists(folder / "stairs.csv"));
    const std::string early = readFile((folder / "rest.csv").string()).value();
    EXPECT_EQ(outcome.steps[0].recording()->rows(), 50U) << "the report has the rows as well";
    ASSERT_TRUE(writeRunFiles(folder.string(), header(), m_experiment, outcome, *m_device));
    EXPECT_EQ(readFile((folder / "rest.csv").string()).value(), early);
    ASSERT_EQ(kp(), 12.0);
    const auto rest = devices::readRecordingFile((folder / "rest.csv").string());
    const auto stairs = devices::readRecordingFile((folder / "stairs.csv").string());
    ASSERT_TRUE(rest && stairs);
    EXPECT_TRUE(rest->warnings.empty());
    EXPECT_EQ(kpIn(rest->meta), 10.0);
    EXPECT_EQ(kpIn(stairs->meta), 10.0);
    ASSERT_GE(stairs->meta.markers.size(), 3U);
    for (int stair = 1; stair < 3; ++stair) { // one every 0.2 s, taken by the board at its 10 ms cycle
        const auto index = static_cast<std::size_t>(stair);
        EXPECT_EQ(stairs->meta.markers[index].text, "reference segment " + std::to_string(stair + 1));
        EXPECT_NEAR(stairs->meta.markers[index].time_s, 0.2 * stair, 0.0101);
    }
    fs::remove_all(folder);
}

} // namespace
} // namespace halbench::app
