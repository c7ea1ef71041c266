#include "app/actuators/axes/axes_actuator.h"
#include "app/documents/axis_model_file.h"
#include "app/experiments/run_report.h"
#include "app/procedures/apply/apply_axes.h"
#include "app/tuning/axis_conditions.h"
#include "devices/simulated/registry/simulated_models.h"
#include "tests/conformance/actuator/toy_model.h"
#include "tests/conformance/axis_experiments.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

// The toy through the code that identifies, tunes, applies, verifies and reports every actuator with
// independent axes; of the program it takes one row of the table of actuators.

namespace halbench::app {
namespace {

/// What the toy's plant obeys: v += (5 i - v)/m h by Euler's rule with h = 0.25 ms. Its speed decays as
/// (1 - h/m)^n = exp(-a n h), and 5 N/A against 1 N s/m end at 5 m/s per A: k = 5 a.
struct Truth {
    explicit Truth(double mass_kg) : dampingRate_1_s(-std::log1p(-Step_s / mass_kg) / Step_s) {}
    static constexpr double Step_s = 0.25e-3;
    double dampingRate_1_s;
    double gain() const { return 5.0 * dampingRate_1_s; }
    static double breakaway_A(const std::string& axis) { return axis == "y" ? 0.3 / 5.0 : 0.0; }
};

class ToyLoops : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        devices::addSimulatedModel(devices::toyModel());
        addActuator(independentAxes("toy", "Two slides"));
    }

    static std::unique_ptr<devices::Device> open(const std::string& address = "sim:toy") {
        return openSimulated(address);
    }
    static Result<AxesIdentifyResult> identified(devices::Device& device, const IdentifyConfig& config = {}) {
        const auto outcome = actuatorOf("toy").identify.run(device, config, {});
        if (!outcome) {
            return failure(outcome.error());
        }
        return std::get<AxesIdentifyResult>(*outcome);
    }
};

/// Counts the intervals that miss the truth.
class Misses {
public:
    void check(const std::string& what, const control::Estimate& estimate, double truth) {
        ASSERT_TRUE(estimate.interval95);
        const auto [low, high] = *estimate.interval95;
        ++m_checked;
        m_missed += low <= truth && truth <= high ? 0 : 1;
        EXPECT_LT(high - low, 0.02 * std::fabs(*estimate.value) + 2e-3) << what << ": tells nothing";
        EXPECT_NEAR(*estimate.value, truth, 2.0 * (high - low) + 1e-12) << what;
        m_text += fmt::format("{}: {} in {} ... {}\n", what, truth, low, high);
    }
    int missed() const { return m_missed; }
    int checked() const { return m_checked; }
    const std::string& text() const { return m_text; }

private:
    int m_missed = 0, m_checked = 0;
    std::string m_text;
};

TEST_F(ToyLoops, areIdentifiedWithinTheirIntervals) {
    Misses misses;
    for (const double mass_kg : {0.2, 0.5}) {
        for (const int seed : {1, 2, 3}) {
            const auto device = open(fmt::format("sim:toy?m={}&seed={}", mass_kg, seed));
            ASSERT_TRUE(device);
            const auto result = identified(*device);
            ASSERT_TRUE(result) << result.error().message;
            EXPECT_EQ(result->quality.verdict, Verdict::Good) << result->quality.findings.front().message;
            ASSERT_EQ(result->model.axes.size(), 2u);
            for (const IdentifiedAxis& axis : result->model.axes) {
                const std::string of = fmt::format("{} of {} kg, seed {}: ", axis.axis, mass_kg, seed);
                const Truth truth(mass_kg);
                misses.check(of + "damping rate", axis.dampingRate, truth.dampingRate_1_s);
                misses.check(of + "gain", axis.accelerationGain, truth.gain());
                misses.check(of + "breakaway", axis.breakawayEffort, Truth::breakaway_A(axis.axis));
            }
        }
    }
    EXPECT_EQ(misses.checked(), 36);
    // Of 36 intervals at 95 % more than 5 miss with a probability of 1 %; those of damping and gain are wider
    // than the noise, for what happens between two rows.
    EXPECT_LE(misses.missed(), 5) << misses.text();
}

TEST_F(ToyLoops, takeAGivenMassForAbsoluteConstants) {
    const auto device = open();
    ASSERT_TRUE(device);
    IdentifyConfig config;
    ASSERT_TRUE(actuatorOf("toy").identify.setGiven(config, "m", 0.2));
    config.axis = "y";
    const auto result = identified(*device, config);
    ASSERT_TRUE(result) << result.error().message;
    ASSERT_EQ(result->model.axes.size(), 1u);
    ASSERT_EQ(result->constants.size(), 3u);
    EXPECT_EQ(result->constants[0].name, "damping_y");
    EXPECT_NEAR(*result->constants[0].estimate.value, 1.0, 0.01);  // N s/m
    EXPECT_NEAR(*result->constants[1].estimate.value, 0.3, 0.003); // N
    EXPECT_NEAR(*result->constants[2].estimate.value, 5.0, 0.05);  // N/A
    EXPECT_EQ(result->constants[2].estimate.unit, "N/A");
}

TEST_F(ToyLoops, withoutAMassAbsoluteConstantsAreNotIdentifiable) {
    const auto device = open();
    ASSERT_TRUE(device);
    const auto result = identified(*device);
    ASSERT_TRUE(result) << result.error().message;
    for (const NamedEstimate& constant : result->constants) {
        EXPECT_FALSE(constant.estimate.value) << constant.name;
    }
}

TEST_F(ToyLoops, leaveTheBoardAsItWas) {
    const auto device = open();
    ASSERT_TRUE(device);
    ASSERT_TRUE(identified(*device));
    EXPECT_FALSE(device->state().isArmed);
    EXPECT_EQ(parameterOf(*device, "hb.mode"), 0.0);
    EXPECT_EQ(parameterOf(*device, "reference.x.shape"), 0.0);
    EXPECT_EQ(parameterOf(*device, "gain.x.kp"), 100.0);
}

TEST_F(ToyLoops, aSlideThatDoesNotMoveIsRefused) {
    const auto device = open();
    ASSERT_TRUE(device);
    const ParameterValue weak[] = {{"limit.y", 0.05}}; // 0.25 N of 0.3 N of friction
    ASSERT_TRUE(device->writeParameters(weak));
    const auto result = identified(*device);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->quality.verdict, Verdict::Refused);
    ASSERT_FALSE(result->quality.findings.empty());
    const auto isOfY = [](const Finding& finding) {
        return finding.code == "not_determined" && finding.message.find("axis y: ") == 0;
    };
    EXPECT_TRUE(std::any_of(result->quality.findings.begin(), result->quality.findings.end(), isOfY));
}

TEST_F(ToyLoops, refuseWhatOnlyAMotorHas) {
    const auto device = open();
    ASSERT_TRUE(device);
    IdentifyConfig config;
    config.sweep.from_A = 1.0;
    EXPECT_EQ(identified(*device, config).error().code, ErrorCode::Usage);
    EXPECT_EQ(actuatorOf("toy").identify.setGiven(config, "Iz", 1.0).error().code, ErrorCode::UnknownName);
    EXPECT_EQ(actuatorOf("toy").identify.setGiven(config, "m", 0.0).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(actuatorOf("toy").calibrate.check(device->catalogue(), {}).error().code, ErrorCode::Usage);
}

constexpr const char* Identify = R"(title = "Two slides"
device = "sim:toy"
[[step]]
kind = "identify"
name = "slides"
given = { m = 0.2 }
)";

constexpr const char* Checks = R"([[check]]
quantity = "slides.axes.0.parameters.acceleration_gain.value"
min = 24.5
max = 25.5
[[check]]
quantity = "loops.axes.1.predicted.margins.phase_margin_deg"
min = 45
)";

TEST_F(ToyLoops, anExperimentIdentifiesTunesAppliesVerifiesAndReportsBothAxes) {
    const auto device = open();
    ASSERT_TRUE(device);
    const AxisExperiment run(*device, Identify + tuneApplyMove("model = \"slides\"", "y", 10000) + Checks);
    run.expectPassed(4);
    EXPECT_NE(parameterOf(*device, "gain.x.kp"), 100.0);
    EXPECT_NE(parameterOf(*device, "gain.y.kp"), 100.0);
    ResultHeader header;
    header.device = device->info();
    const auto report = renderRunReport(header, run.experiment, run.outcome, *device);
    ASSERT_TRUE(report) << report.error().message;
    for (const char* text : {"Gains of axis x", "Gains of axis y", "axis x", "axis y"}) {
        EXPECT_NE(report->find(text), std::string::npos) << text;
    }
    // The board reports neither: no figure of them is made up.
    for (const char* text : {"coil temperature", "peak current"}) {
        EXPECT_EQ(report->find(text), std::string::npos) << text;
    }
    const JsonValue* identified = run.outcome.steps[0].body.find("highest_temperature_degC");
    ASSERT_NE(identified, nullptr);
    EXPECT_TRUE(identified->isNull());
    const JsonValue& figures = *run.outcome.steps[3].body.find("axes")->items()[0].find("figures");
    EXPECT_TRUE(figures.find("highest_temperature_degC")->isNull());
    EXPECT_TRUE(figures.find("peak_current_A")->isNull());
    EXPECT_GT(figures.find("peak_effort_A")->number(), 0.0);
}

} // namespace
} // namespace halbench::app
