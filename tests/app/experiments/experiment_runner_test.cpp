#include "app/documents/result_documents.h"
#include "app/documents/text/output_file.h"
#include "app/experiments/experiment_runner.h"
#include "app/experiments/run_files.h"
#include "app/experiments/run_plan.h"
#include "app/experiments/run_report.h"
#include "app/experiments/step_configs.h"
#include "app/headless/reconnecting_device.h"
#include "app/headless/recording_file.h"
#include "app/tuning/loop_conditions.h"
#include "devices/formats/recording_file.h"
#include "devices/open/open_device.h"
#include "devices/open/returning_device.h"
#include "tests/app/experiments/experiment_fixture.h"
#include "tests/app/procedures/faulty_motor.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace halbench::app {
namespace {

namespace fs = std::filesystem;

const std::string Steps = R"(schema = "halbench.experiment/1"
title = "A step & a <check>"
device = "sim:htm?imperfections=off"

[[step]]
kind = "set"
name = "stiffer"
values = { "gain.kp" = 12 }

[[step]]
kind = "move"
name = "step100"
reference = { shape = "step", amplitude_deg = 100 }
duration_s = 1.5

[[check]]
quantity = "step100.overshoot_percent"
min = 20
max = 50

[[check]]
quantity = "step100.rise_time_s"
max = 0.001
)";

TEST_F(ExperimentRunner, runsEveryStepAndJudgesEveryCheck) {
    const RunOutcome outcome = run(Steps);
    ASSERT_EQ(outcome.steps.size(), 2U);
    EXPECT_FALSE(outcome.stoppedBy.has_value());
    ASSERT_EQ(outcome.checks.size(), 2U);
    EXPECT_TRUE(outcome.checks[0].passed); // about a third, resources/help/htm-theory.md 8.1
    EXPECT_FALSE(outcome.checks[1].passed);
    EXPECT_FALSE(outcome.passed);
    EXPECT_EQ(outcome.steps[0].recording(), nullptr);
    ASSERT_NE(outcome.steps[1].recording(), nullptr);
    EXPECT_EQ(kp(), 12.0); // what `set` changed stays
    EXPECT_FALSE(m_device->state().isArmed);
}

TEST_F(ExperimentRunner, anErrorOfAStepPutsBackWhatWasThereBefore) {
    m_interruptSignal = 2;
    const RunOutcome interrupted = run(Steps);
    ASSERT_TRUE(interrupted.stoppedBy.has_value());
    EXPECT_EQ(interrupted.stoppedBy->code, ErrorCode::Interrupted);
    EXPECT_FALSE(interrupted.passed);
    EXPECT_EQ(kp(), 10.0);
    EXPECT_FALSE(m_device->state().isArmed);
}

TEST_F(ExperimentRunner, writesResultJunitRecordingAndReport) {
    const fs::path folder = fs::path(::testing::TempDir()) / "halbench_runner";
    fs::remove_all(folder);
    const RunOutcome outcome = run(Steps);
    ASSERT_TRUE(writeRunFiles(folder.string(), header(), m_experiment, outcome, *m_device).has_value());
    for (const char* name : {"result.json", "junit.xml", "step100.csv", "report.html"}) {
        EXPECT_TRUE(fs::exists(folder / name)) << name;
    }
    const std::string junit = readFile((folder / "junit.xml").string()).value();
    EXPECT_NE(junit.find("failures=\"1\""), std::string::npos);
    EXPECT_EQ(junit.find("A step & a <check>"), std::string::npos); // escaped
    const JsonValue result = parseJson(readFile((folder / "result.json").string()).value(), "r").value();
    EXPECT_FALSE(result.find("passed")->boolean());
    EXPECT_EQ(result.find("checks")->items().size(), 2U);
    EXPECT_NE(readFile((folder / "step100.csv").string()).value().find("time_s,"), std::string::npos);
    fs::remove_all(folder);
}

const std::string Response = R"(schema = "halbench.experiment/1"
device = "sim:htm?imperfections=off"

[[step]]
kind = "frequency"
name = "loop"
from_hz = 2
to_hz = 8
periods = 4
base_rad_s = -6
coherence = 0.95

[[check]]
quantity = "loop.rotor.phi_over_J.value"
min = 25
max = 27
)";

// The step is the procedure that `identify --frequency` runs: with the same settings it gives the same
// numbers. 26.0 is phi/J of the published motor.
TEST_F(ExperimentRunner, aFrequencyStepIsTheProcedureOfTheCommand) {
    const fs::path folder = fs::path(::testing::TempDir()) / "halbench_response";
    fs::remove_all(folder);
    const RunOutcome outcome = run(Response, folder.string());
    ASSERT_EQ(outcome.steps.size(), 1U) << (outcome.stoppedBy ? outcome.stoppedBy->message : "");
    EXPECT_TRUE(outcome.passed);
    FrequencyConfig config;
    config.from_Hz = 2.0;
    config.to_Hz = 8.0;
    config.periods = 4;
    config.base_rad_s = -6.0;
    config.leastCoherence = 0.95;
    const auto second = devices::openDevice("sim:htm?imperfections=off", {}).value();
    const auto conditions = loopConditionsOf(*second).value();
    const auto direct = runFrequency(*second, config, conditions.stray, {});
    ASSERT_TRUE(direct) << direct.error().message;
    EXPECT_EQ(*toJsonText(outcome.steps[0].body), *toJsonText(frequencyBody(*direct)));
    ASSERT_NE(outcome.steps[0].recording(), nullptr); // the raw record becomes loop.csv
    ASSERT_TRUE(writeRunFiles(folder.string(), header(), m_experiment, outcome, *m_device));
    EXPECT_TRUE(fs::exists(folder / "loop.csv"));
    const std::string report = readFile((folder / "report.html").string()).value();
    for (const char* part : {"frequency: loop", "Measured open loop", "Measured plant", "coherence",
                             "Excitation as recorded", "95 % interval"}) {
        EXPECT_NE(report.find(part), std::string::npos) << part;
    }
    EXPECT_FALSE(m_device->state().isArmed);
    fs::remove_all(folder);
}

// What --dry-run says of it is what it takes: the run adds only what is on its way at the end of each stage.
TEST_F(ExperimentRunner, aFrequencyStepTakesAsLongAsThePlanSays) {
    m_experiment = parseExperiment(Response, "e.toml", {}).value();
    ASSERT_TRUE(checkAgainstDevice(m_experiment, *m_device));
    const auto plan = planRun(m_experiment, *m_device);
    ASSERT_TRUE(plan);
    const RunOutcome outcome = run(Response);
    const double duration_s = *findQuantity(outcome.steps.at(0).body, "duration_s");
    EXPECT_NEAR(plan->duration_s, duration_s, 0.05 * duration_s);
    const double highest_A = *findQuantity(outcome.steps.at(0).body, "highest_current_A");
    EXPECT_GE(plan->peakCurrent_A, 0.8 * highest_A);
    EXPECT_LE(plan->peakCurrent_A, 4.0);
}

TEST_F(ExperimentRunner, aFrequencyStepThatWouldTurnTheRotorBackIsRefusedBeforeAnythingMoves) {
    for (const char* setting :
         {"step.loop.base_rad_s=2", "step.loop.amplitude_deg=30", "step.loop.to_hz=60"}) {
        const auto experiment = parseExperiment(Response, "e.toml", {setting});
        ASSERT_TRUE(experiment) << setting;
        const Result<void> refused = checkAgainstDevice(*experiment, *m_device);
        ASSERT_FALSE(refused) << setting;
        EXPECT_NE(refused.error().message.find("e.toml:"), std::string::npos) << refused.error().message;
    }
    EXPECT_FALSE(parseExperiment(Response, "e.toml", {"step.loop.periods=2"}));
    EXPECT_FALSE(parseExperiment(Response, "e.toml", {"step.loop.excitation=noise"}));
}

TEST_F(ExperimentRunner, reportIsOneSelfContainedDocumentWithEqualBytes) {
    const RunOutcome outcome = run(Steps);
    const Result<std::string> report = renderRunReport(header(), m_experiment, outcome, *m_device);
    ASSERT_TRUE(report.has_value());
    EXPECT_NE(report->find("A step &amp; a &lt;check&gt;"), std::string::npos);
    EXPECT_NE(report->find("<svg"), std::string::npos);
    for (const char* outside : {"<script src", "<link", "href=\"http", "src=\"http"}) {
        EXPECT_EQ(report->find(outside), std::string::npos) << outside;
    }
    EXPECT_EQ(*report, renderRunReport(header(), m_experiment, outcome, *m_device).value());
}

TEST_F(ExperimentRunner, aRepeatedMoveIsJudgedByItsShareAndALockTimeByItsThreshold) {
    std::string text = Steps.substr(0, Steps.find("[[check]]"));
    text += "repeat = 2\nsettled_deg = 10\nlock_threshold_deg = 20\n";
    for (const char* quantity : {"repetition.settled_fraction", "repetition.count", "lock_time_s",
                                 "repetition.runs.1.start_deg", "repetition.median_peak_to_peak_deg"}) {
        text += "[[check]]\nquantity = \"step100." + std::string(quantity) + "\"\nmin = 0\n";
    }
    const RunOutcome outcome = run(text);
    ASSERT_EQ(outcome.checks.size(), 5U);
    for (const CheckOutcome& check : outcome.checks) {
        EXPECT_TRUE(check.passed) << check.quantity;
    }
    EXPECT_EQ(outcome.checks[0].value, 1.0); // friction stops the rotor within 8.21 degrees
    EXPECT_EQ(outcome.checks[1].value, 2.0);
    EXPECT_EQ(outcome.steps[1].body.find("lock_threshold_deg")->number(), 20.0);
    EXPECT_NEAR(planRun(m_experiment, *m_device)->duration_s, 2.0 * 1.5, 1e-9);
}

TEST_F(ExperimentRunner, everySubjectOfAnAnalysisIsComputedFromTheMotorOfTheAddress) {
    std::string text = "schema = \"halbench.experiment/1\"\ndevice = \"sim:htm?imperfections=off\"\n";
    for (const char* what : {"torque", "sensing", "poles", "field", "coil"}) {
        text += fmt::format("[[step]]\nkind = \"analyse\"\nname = \"{0}\"\nwhat = \"{0}\"\n", what);
    }
    const RunOutcome outcome = run(text);
    ASSERT_EQ(outcome.steps.size(), 5U) << outcome.stoppedBy->message;
    for (const StepOutcome& step : outcome.steps) {
        EXPECT_EQ(step.body.find("what")->text(), step.name);
        EXPECT_FALSE(step.body.find("figures")->members().empty()) << step.name;
    }
    EXPECT_NEAR(findQuantity(outcome.steps[0].body, "figures.largest_torque.value").value_or(0), 0.0572,
                5e-5);
    EXPECT_EQ(quantityUnit(outcome.steps[0].body, "figures.largest_torque.value"), "N*m");
    m_device = devices::openDevice("sim:htm?phi=0.02&Imax=3", {}).value();
    EXPECT_NEAR(findQuantity(run(text).steps[0].body, "figures.largest_torque.value").value_or(0), 0.06,
                1e-12);
}

TEST_F(ExperimentRunner, planPredictsWithoutMoving) {
    m_experiment = parseExperiment(Steps, "e.toml", {}).value();
    const double before_s = m_device->clock().now_s();
    const Result<RunPlan> plan = planRun(m_experiment, *m_device);
    ASSERT_TRUE(plan.has_value()) << plan.error().message;
    ASSERT_EQ(plan->steps.size(), 2U);
    EXPECT_GE(plan->duration_s, 1.5);
    EXPECT_GT(plan->peakCurrent_A, 0.0);
    EXPECT_LE(plan->peakCurrent_A, 4.0);
    EXPECT_GE(plan->highestTemperature_degC, 25.0);
    EXPECT_LT(m_device->clock().now_s() - before_s, 0.5);
    EXPECT_EQ(kp(), 10.0);
}

TEST_F(ExperimentRunner, whatTheDeviceCannotDoIsRefusedBeforeAnythingMoves) {
    std::string text = Steps;
    text.replace(text.find("gain.kp"), 7, "gain.kq");
    m_experiment = parseExperiment(text, "e.toml", {}).value();
    const Result<void> checked = checkAgainstDevice(m_experiment, *m_device);
    ASSERT_FALSE(checked.has_value());
    EXPECT_NE(checked.error().message.find("e.toml:"), std::string::npos) << checked.error().message;
    EXPECT_NE(checked.error().message.find("gain.kq"), std::string::npos);
}

TEST_F(ExperimentRunner, onlyARecordingThatAsksForItWaitsForALostDevice) {
    const std::string recording = R"(schema = "halbench.experiment/1"
device = "sim:htm"

[[step]]
kind = "record"
name = "long"
duration_s = 4
rate_hz = 100
signals = ["position"]
reconnect = )";
    for (const bool isWaiting : {true, false}) {
        FaultyMotor motor("imperfections=off");
        auto first = motor.connect();
        double host_s = 1000.0;
        devices::DeviceReturn back(first->info(), [&]() -> Result<std::unique_ptr<devices::Device>> {
            motor.repair();
            return motor.connect();
        });
        motor.faults().unplugAt_s = first->clock().now_s() + 2.0;
        devices::ReturningDevice device(std::move(first), std::move(back),
                                        {[&] { return host_s; }, [&](double time_s) { host_s += time_s; }});
        device.setWaiting(false);
        const Experiment experiment =
            parseExperiment(recording + (isWaiting ? "true\n" : "false\n"), "e.toml", {}).value();
        const RunOutcome outcome = runExperiment(m_context, device, experiment, 1, {});
        EXPECT_EQ(outcome.stoppedBy.has_value(), !isWaiting);
        if (isWaiting) {
            ASSERT_EQ(outcome.steps.size(), 1U);
            EXPECT_NE(toJsonText(outcome.steps[0].body).value_or("").find("\"gaps\""), std::string::npos);
            EXPECT_EQ(outcome.steps[0].quality.verdict, Verdict::Doubtful) << "a gap is said";
        } else {
            EXPECT_EQ(outcome.stoppedBy->code, ErrorCode::DeviceLost);
        }
    }
}

TEST_F(ExperimentRunner, aDeviceThatWouldBeWaitedForRunsLikeItself) {
    const auto waiting = reconnectingDevice(m_context, "sim:htm", std::move(m_device));
    waiting->setWaiting(false);
    EXPECT_EQ(waiting->info().model, "htm");
    m_experiment = parseExperiment(Steps, "e.toml", {}).value();
    const RunOutcome outcome = runExperiment(m_context, *waiting, m_experiment, 1, {});
    EXPECT_FALSE(outcome.stoppedBy);
    EXPECT_EQ(outcome.steps.size(), 2U);
    EXPECT_EQ(waiting->readParameters(std::vector<std::string>{"gain.kp"}).value()[0], 12.0);
}

} // namespace
} // namespace halbench::app
