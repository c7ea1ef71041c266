#include "app/cli/axis_tuning.h"
#include "app/cli/axis_tuning_text.h"
#include "app/documents/text/output_file.h"

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

AxisModel oneAxis() {
    const auto known = [](double value, const std::string& unit) {
        return control::Estimate{value, {}, control::EstimateSource::Identified, unit};
    };
    AxisModel model;
    model.axes.push_back({"x", "m", "N", known(0.0, "1/s"), known(1.5625, "m/(s^2*N)"), {}, {1e-3, 1}});
    return model;
}

TEST(AxisTuning, takesTheModelsOfAxesAndLeavesAllOtherFiles) {
    const QTemporaryDir folder;
    const auto written = [&folder](const char* name, const std::string& text) {
        const std::string path = folder.filePath(name).toStdString();
        EXPECT_TRUE(writeFile(path, text));
        return path;
    };
    const std::string axes = *toJsonText(axisModelDocument({}, oneAxis()));
    const auto model = axisModelIn(written("axes.json", axes));
    ASSERT_TRUE(model && *model);
    EXPECT_EQ((**model).model.axes.size(), 1u);
    const auto motor = axisModelIn(written("motor.json", R"({"schema": "halbench.identification/1"})"));
    ASSERT_TRUE(motor);
    EXPECT_FALSE(*motor);
    EXPECT_FALSE(*axisModelIn(folder.filePath("missing.json").toStdString()));
    const auto newer = axisModelIn(written("newer.json", R"({"schema": "halbench.axis-model/9"})"));
    EXPECT_FALSE(newer) << "a version that is not known is no motor's model either";
}

TEST(AxisTuning, aMotorHasNoAxisToChoose) {
    EXPECT_TRUE(refuseAxis({}));
    EXPECT_EQ(refuseAxis("x").error().code, ErrorCode::Usage);
}

TEST(AxisTuning, textSaysGainsMarginsAndVerdictInTheUnitsOfTheAxis) {
    LoopConditions conditions;
    conditions.timing = {1e-3, 1};
    conditions.currentLimit_A = 3.098;
    conditions.axis = LoopAxis{"x", "m", "N", 30.0, 1e-3};
    const auto result = tuneAxes(oneAxis(), {conditions}, {});
    ASSERT_TRUE(result);
    const std::string text = axisGainsText(*result);
    for (const char* words :
         {"axis x\n", "method recommended", "660.48 N/m", "set-point", "test step", "phase margin"}) {
        EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
    }
    EXPECT_EQ(text.find("rotor"), std::string::npos) << text;
    EXPECT_EQ(axisAnalysisText(*result).find("method"), std::string::npos);
}

} // namespace
} // namespace halbench::app
