#include "app/documents/axis_loop_documents.h"
#include "app/documents/axis_model_file.h"
#include "app/documents/text/output_file.h"
#include "app/procedures/apply/apply_axes.h"
#include "app/tuning/axis_conditions.h"
#include "devices/simulated/registry/simulated_models.h"
#include "tests/conformance/axis_experiments.h"
#include "tests/conformance/stage/stage_model.h"

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

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
        return openSimulated(address);
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
    EXPECT_NEAR(parameterOf(*device, "gain.a.kp") / (0.2 * 1032.0), 1.0, 1e-6);
    EXPECT_NEAR(parameterOf(*device, "gain.b.kp") / (0.5 * 1032.0), 1.0, 1e-6);
    EXPECT_NEAR(parameterOf(*device, "gain.b.kd") / (0.5 * 62.2 - 0.4), 1.0, 1e-6);
    EXPECT_NEAR(parameterOf(*device, "gain.a.reference_weight"), 0.745, 1e-6);
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
    EXPECT_EQ(parameterOf(*device, "gain.a.kp"), 100.0);
    EXPECT_EQ(parameterOf(*device, "gain.b.kp"), 100.0);
}

TEST_F(StageLoops, anExperimentTunesAppliesAndMovesThem) {
    const auto device = open();
    ASSERT_TRUE(device);
    const QTemporaryDir folder;
    const std::string path = folder.filePath("model.json").toStdString();
    ResultHeader header;
    header.device = device->info();
    ASSERT_TRUE(writeFile(path, *toJsonText(axisModelDocument(header, modelOf()))));
    const AxisExperiment run(*device, "title = \"Two axes\"\ndevice = \"sim:stage\"\n" +
                                          tuneApplyMove("model_file = \"" + path + "\"", "b", 1000) +
                                          R"([[check]]
quantity = "loops.axes.1.predicted.margins.phase_margin_deg"
min = 60
[[check]]
quantity = "right.axes.0.figures.overshoot_percent"
max = 2
)");
    run.expectPassed(3);
    EXPECT_NEAR(parameterOf(*device, "gain.a.kp") / (0.2 * 1032.0), 1.0, 1e-6);
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
        const AxisExperiment made(*device, "[[step]]\nkind = \"tune\"\nname = \"loops\"\nmodel_file = \"" +
                                               path + "\"\n" + more);
        const RunOutcome& outcome = made.outcome;
        return outcome.stoppedBy ? outcome.stoppedBy->message : std::string();
    };
    EXPECT_NE(run("", "other").find("of a device 'other'"), std::string::npos);
    EXPECT_NE(run("axis = \"z\"\n", "stage").find("no axis 'z'"), std::string::npos);
    EXPECT_EQ(run("axis = \"a\"\n", "stage"), "");
}

} // namespace
} // namespace halbench::app
