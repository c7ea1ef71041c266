#include "app/documents/axis_loop_documents.h"
#include "app/documents/axis_model_file.h"
#include "app/documents/text/output_file.h"
#include "app/experiments/experiment.h"
#include "app/experiments/experiment_runner.h"
#include "app/procedures/apply/apply_axes.h"
#include "app/tuning/axis_conditions.h"
#include "devices/open/open_device.h"
#include "devices/simulated/registry/simulated_models.h"
#include "tests/conformance/stage/stage_model.h"

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

// An actuator that only this program knows, with two axes and friction on one of them, through the code that
// tunes, applies and runs experiments on every device with axes.

namespace halbench::app {
namespace {

/// m x'' + 0.4 N s/m x' = F - friction: the stage's own constants, each gain known to 2 %.
AxisModel modelOf(double massA_kg = 0.2, double massB_kg = 0.5) {
    const auto known = [](double value, const std::string& unit) {
        return control::Estimate{value, {}, control::EstimateSource::Identified, unit};
    };
    AxisModel model;
    model.axes.push_back({"a",
                          "m",
                          "N",
                          known(0.4 / massA_kg, "1/s"),
                          known(1.0 / massA_kg, "m/(s^2*N)"),
                          known(0.0, "N"),
                          {1e-3, 1}});
    model.axes.push_back({"b",
                          "m",
                          "N",
                          known(0.4 / massB_kg, "1/s"),
                          known(1.0 / massB_kg, "m/(s^2*N)"),
                          known(0.05, "N"),
                          {1e-3, 1}});
    model.covarianceNames = {"a.acceleration_gain", "b.acceleration_gain"};
    model.covariance = {{std::pow(0.02 / massA_kg, 2), 0.0}, {0.0, std::pow(0.02 / massB_kg, 2)}};
    return model;
}

class StageLoops : public ::testing::Test {
protected:
    static void SetUpTestSuite() { devices::addSimulatedModel(devices::stageModel()); }

    static std::unique_ptr<devices::Device> open(const std::string& address = "sim:stage") {
        auto device = devices::openDevice(address, {});
        EXPECT_TRUE(device) << device.error().message;
        return device ? std::move(*device) : nullptr;
    }
    static double parameter(devices::Device& device, const std::string& name) {
        const std::string names[] = {name};
        const auto values = device.readParameters(names);
        EXPECT_TRUE(values) << name;
        return values ? values->front() : NAN;
    }
    static ApplyAxesConfig tuned(devices::Device& device, const AxisModel& model) {
        const auto conditions = axisConditionsOf(device, {"a", "b"});
        EXPECT_TRUE(conditions) << conditions.error().message;
        const auto result = tuneAxes(model, *conditions, {});
        EXPECT_TRUE(result) << result.error().message;
        auto config = applyAxesConfig(device.catalogue(), model, *result);
        EXPECT_TRUE(config) << config.error().message;
        return *config;
    }
};

TEST_F(StageLoops, areTunedAppliedInOneTransactionAndVerified) {
    const auto device = open();
    ASSERT_TRUE(device);
    const ApplyAxesConfig config = tuned(*device, modelOf());
    const auto result = runApplyAxes(*device, config, {});
    ASSERT_TRUE(result) << result.error().message;
    for (const Finding& finding : result->quality.findings) {
        EXPECT_TRUE(result->isKept) << finding.message;
    }
    EXPECT_TRUE(result->isKept);
    ASSERT_EQ(result->axes.size(), 2u);
    // w = 30 rad/s at 1 ms and one sample of delay, p = 2.2/s: K_P = m (w^2 + 2 w p), K_D = m (2 w + p) - c.
    EXPECT_NEAR(parameter(*device, "gain.a.kp") / (0.2 * 1032.0), 1.0, 1e-6);
    EXPECT_NEAR(parameter(*device, "gain.b.kp") / (0.5 * 1032.0), 1.0, 1e-6);
    EXPECT_NEAR(parameter(*device, "gain.b.kd") / (0.5 * 62.2 - 0.4), 1.0, 1e-6);
    EXPECT_NEAR(parameter(*device, "gain.a.reference_weight"), 0.745, 1e-6);
    for (const AxisVerification& verified : result->axes) {
        EXPECT_LT(std::fabs(verified.assessment.band->largestOff_rad), 0.02 * 0.002) << verified.axis.id;
        ASSERT_EQ(verified.assessment.verification->others.size(), 1u);
        EXPECT_LT(verified.assessment.verification->others[0].measured, 1e-6) << "nothing couples the axes";
    }
}

TEST_F(StageLoops, gainsOfHeavierSlidesArePutBack) {
    const auto device = open();
    ASSERT_TRUE(device);
    const auto result = runApplyAxes(*device, tuned(*device, modelOf(0.2, 2.0)), {});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_FALSE(result->isKept);
    EXPECT_EQ(result->axes.size(), 2u) << "axis a is as the model says, axis b is not";
    EXPECT_EQ(result->quality.findings.front().message.find("axis b: "), 0u);
    EXPECT_EQ(parameter(*device, "gain.a.kp"), 100.0);
    EXPECT_EQ(parameter(*device, "gain.b.kp"), 100.0);
}

TEST_F(StageLoops, anExperimentTunesAppliesAndMovesThem) {
    const auto device = open();
    ASSERT_TRUE(device);
    const QTemporaryDir folder;
    const std::string path = folder.filePath("model.json").toStdString();
    ResultHeader header;
    header.device = device->info();
    ASSERT_TRUE(writeFile(path, *toJsonText(axisModelDocument(header, modelOf()))));
    const std::string text = R"(schema = "halbench.experiment/1"
title = "Two axes"
device = "sim:stage"
[[step]]
kind = "tune"
name = "loops"
model_file = ")" + path + R"("
[[step]]
kind = "apply"
name = "write"
gains = "loops"
[[step]]
kind = "move"
name = "right"
axis = "b"
reference = { shape = "step", amplitude_um = 1000 }
duration_s = 2
[[check]]
quantity = "loops.axes.1.predicted.margins.phase_margin_deg"
min = 60
[[check]]
quantity = "write.kept"
min = 1
[[check]]
quantity = "right.axes.0.figures.overshoot_percent"
max = 2
)";
    const auto experiment = parseExperiment(text, "stage.toml", {});
    ASSERT_TRUE(experiment) << experiment.error().message;
    Console console{ConsoleStyle{}};
    std::atomic<int> signal = 0;
    CommandContext context{{}, console, signal};
    const RunOutcome outcome = runExperiment(context, *device, *experiment, 1, "");
    EXPECT_FALSE(outcome.stoppedBy) << outcome.stoppedBy->message;
    ASSERT_EQ(outcome.steps.size(), 3u);
    for (const CheckOutcome& check : outcome.checks) {
        EXPECT_TRUE(check.passed) << check.quantity << " = " << check.value.value_or(NAN);
    }
    EXPECT_TRUE(outcome.passed);
    EXPECT_NEAR(parameter(*device, "gain.a.kp") / (0.2 * 1032.0), 1.0, 1e-6);
}

TEST_F(StageLoops, anExperimentRefusesAModelOfAnotherDeviceAndAnUnknownAxis) {
    const auto device = open();
    ASSERT_TRUE(device);
    const QTemporaryDir folder;
    const std::string path = folder.filePath("model.json").toStdString();
    const auto run = [&](const std::string& more, const std::string& model) {
        ResultHeader header;
        header.device = device->info();
        header.device->model = model;
        EXPECT_TRUE(writeFile(path, *toJsonText(axisModelDocument(header, modelOf()))));
        const auto experiment = parseExperiment(
            "schema = \"halbench.experiment/1\"\n[[step]]\nkind = \"tune\"\nname = \"loops\"\n"
            "model_file = \"" +
                path + "\"\n" + more,
            "stage.toml", {});
        EXPECT_TRUE(experiment) << experiment.error().message;
        Console console{ConsoleStyle{}};
        std::atomic<int> signal = 0;
        CommandContext context{{}, console, signal};
        const RunOutcome outcome = runExperiment(context, *device, *experiment, 1, "");
        return outcome.stoppedBy ? outcome.stoppedBy->message : std::string();
    };
    EXPECT_NE(run("", "other").find("of a device 'other'"), std::string::npos);
    EXPECT_NE(run("axis = \"z\"\n", "stage").find("no axis 'z'"), std::string::npos);
    EXPECT_EQ(run("axis = \"a\"\n", "stage"), "");
}

} // namespace
} // namespace halbench::app
