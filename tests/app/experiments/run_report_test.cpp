#include "app/experiments/run_report.h"
#include "devices/open/open_device.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace halbench::app {
namespace {

class RunReport : public ::testing::Test {
protected:
    void SetUp() override {
        auto opened = devices::openDevice("sim:htm?imperfections=off", {});
        ASSERT_TRUE(opened.has_value());
        m_device = *std::move(opened);
        m_experiment.title = "Two steps";
        m_experiment.description = "A description & more";
        m_outcome.passed = true;
    }

    std::string render() { return renderRunReport(m_header, m_experiment, m_outcome, *m_device).value(); }

    std::unique_ptr<devices::Device> m_device;
    ResultHeader m_header;
    Experiment m_experiment;
    RunOutcome m_outcome;
};

TEST_F(RunReport, namesDeviceStepsAndChecks) {
    m_outcome.checks = {{"step100.overshoot_percent", 7.5, "%", {}, 12.0, "published claim", true}};
    m_outcome.steps.push_back(
        {"wait", "pause", {}, JsonValue::object().set("duration_s", 2.5), {}, {}, false});
    const std::string html = render();
    for (const char* words : {"Two steps", "A description &amp; more", "SIMULATED", "all checks passed",
                              "wait: pause", "2.5 s", "step100.overshoot_percent: published claim",
                              "imperfections = off", "Published figures that contradict each other"}) {
        EXPECT_NE(html.find(words), std::string::npos) << words;
    }
}

TEST_F(RunReport, showsParametersAtStartWithUnitsAndWords) {
    m_outcome.parametersAtStart = {{"gain.kp", 10.0}, {"decode.method", 1.0}};
    const ParameterSpec* decoding = m_device->catalogue().findParameter("decode.method");
    ASSERT_NE(decoding, nullptr);
    ASSERT_EQ(decoding->choices.size(), 2U);
    const std::string html = render();
    EXPECT_NE(html.find(">10 A/rad<"), std::string::npos);
    EXPECT_NE(html.find(">" + decoding->choices[1] + "<"), std::string::npos);
}

TEST_F(RunReport, saysWhyARunEndedEarly) {
    m_outcome.passed = false;
    m_outcome.stoppedBy = Error{ErrorCode::SafetyStop, "coil temperature above its limit", "let it cool"};
    const std::string html = render();
    EXPECT_NE(html.find("Ended early"), std::string::npos);
    EXPECT_NE(html.find("coil temperature above its limit"), std::string::npos);
    EXPECT_EQ(html.find("all checks passed"), std::string::npos);
}

TEST_F(RunReport, drawsTheLoopAtStartBesideTheProposal) {
    TuneOutcome tuned;
    tuned.motor.values = {{"J", 5.5e-4}, {"c", 1.23e-3}, {"Kf", 2.05e-2}, {"phi", 1.43e-2}};
    Result<TuneResult> result = runTune(tuned.motor, TuneConfig{});
    ASSERT_TRUE(result.has_value());
    tuned.result = *std::move(result);
    m_outcome.parametersAtStart = {{"gain.kp", 10.0}, {"gain.ki", 0.1}, {"gain.kd", 0.0}};
    m_outcome.steps.push_back({"tune", "gains", {}, JsonValue::object(), tuned, {}, false});
    const std::string html = render();
    EXPECT_NE(html.find("37.92°"),
              std::string::npos); // margins of the recommended and of the published loop:
    EXPECT_NE(html.find("3.308°"), std::string::npos); // resources/help/htm-theory.md sections 8.4 and 5
    EXPECT_NE(html.find(">before<"), std::string::npos);
}

} // namespace
} // namespace halbench::app
