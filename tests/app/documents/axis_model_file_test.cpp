#include "app/documents/axis_model_file.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

using control::Estimate;
using control::EstimateSource;

Estimate identified(double value, const std::string& unit) {
    return {value, std::pair(0.9 * value, 1.1 * value), EstimateSource::Identified, unit};
}

AxisModel twoAxes() {
    AxisModel model;
    model.axes.push_back({"x",
                          "m",
                          "N",
                          identified(0.1, "1/s"),
                          identified(1.5625, "m/(s^2*N)"),
                          identified(0.02, "N"),
                          {1e-3, 1}});
    model.axes.push_back({"phi",
                          "rad",
                          "N*m",
                          identified(0.2, "1/s"),
                          identified(370.0, "rad/(s^2*N*m)"),
                          Estimate{},
                          {1e-3, std::nullopt}});
    model.covarianceNames = {"x.acceleration_gain", "phi.acceleration_gain"};
    model.covariance = {{1e-4, 1e-5}, {1e-5, 4.0}};
    return model;
}

std::string written(const AxisModel& model) {
    ResultHeader header;
    header.device = devices::DeviceInfo{};
    header.device->model = "two-axes";
    header.seed = 7;
    return *toJsonText(axisModelDocument(header, model));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

std::string complaint(const std::string& text) {
    const auto file = parseAxisModel(text, "m.json");
    return file ? std::string() : file.error().message;
}

TEST(AxisModelFile, readsBackWhatWasWritten) {
    const auto file = parseAxisModel(written(twoAxes()), "m.json");
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_EQ(file->header.device->model, "two-axes");
    EXPECT_EQ(file->header.seed, 7u);
    ASSERT_EQ(file->model.axes.size(), 2u);
    const IdentifiedAxis* x = file->model.find("x");
    ASSERT_NE(x, nullptr);
    EXPECT_EQ(x->positionUnit, "m");
    EXPECT_EQ(x->effortUnit, "N");
    EXPECT_EQ(x->accelerationGain.value, 1.5625);
    EXPECT_EQ(x->accelerationGain.interval95, std::pair(0.9 * 1.5625, 1.1 * 1.5625));
    EXPECT_EQ(x->breakawayEffort.value, 0.02);
    EXPECT_EQ(x->timing, (MeasuredTiming{1e-3, 1}));
    const IdentifiedAxis* phi = file->model.find("phi");
    ASSERT_NE(phi, nullptr);
    EXPECT_FALSE(phi->breakawayEffort.value.has_value());
    EXPECT_EQ(phi->timing, (MeasuredTiming{1e-3, std::nullopt}));
    EXPECT_EQ(file->model.covarianceNames, twoAxes().covarianceNames);
    EXPECT_EQ(file->model.covariance, twoAxes().covariance);
    EXPECT_EQ(file->model.find("y"), nullptr);
}

TEST(AxisModelFile, constantsOfTheActuatorBesideTheAxesAreNoFault) {
    const std::string text =
        replaced(written(twoAxes()), "\"axes\":", "\"constants\": {\"mass\": 0.64}, \"axes\":");
    EXPECT_EQ(complaint(text), "");
}

TEST(AxisModelFile, knowsItsDocumentsFromThoseOfAMotor) {
    EXPECT_TRUE(isAxisModel(written(twoAxes())));
    EXPECT_FALSE(isAxisModel(R"({"schema": "halbench.identification/1"})"));
    EXPECT_FALSE(isAxisModel("{"));
}

TEST(AxisModelFile, namesFileAndPlaceOfWhatIsWrong) {
    const std::string good = written(twoAxes());
    EXPECT_NE(complaint(replaced(good, "axis-model/1", "axis-model/2")).find("m.json: \"schema\""),
              std::string::npos);
    EXPECT_NE(
        complaint(replaced(good, "\"delay_samples\": 1", "\"delay_samples\": 1.5")).find("axes[0].delay_samples"),
        std::string::npos);
    EXPECT_NE(complaint(replaced(good, "m/(s^2*N)", "m/s^2")).find("axis x: acceleration gain"),
              std::string::npos);
    EXPECT_NE(
        complaint(replaced(good, "\"value\": 370", "\"value\": -370")).find("axis phi: acceleration gain"),
        std::string::npos);
    EXPECT_NE(complaint(replaced(good, "\"axis\": \"phi\"", "\"axis\": \"x\"")).find("twice"),
              std::string::npos);
    EXPECT_NE(complaint(replaced(good, "phi.acceleration_gain", "z.acceleration_gain")).find("'z.acc"),
              std::string::npos);
    EXPECT_NE(complaint(replaced(good, "\"verdict\": \"good\"", "\"verdict\": \"refused\"")).find("rejected"),
              std::string::npos);
    EXPECT_NE(complaint("{").find("m.json"), std::string::npos);
}

} // namespace
} // namespace halbench::app
