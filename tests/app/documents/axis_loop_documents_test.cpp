#include "app/documents/axis_loop_documents.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

AxisModel platen() {
    const auto known = [](double value, const std::string& unit) {
        return control::Estimate{value, {}, control::EstimateSource::Identified, unit};
    };
    AxisModel model;
    model.axes.push_back({"x", "m", "N", known(0.0, "1/s"), known(1.5625, "m/(s^2*N)"), {}, {1e-3, 1}});
    model.axes.push_back(
        {"phi", "rad", "N*m", known(0.0, "1/s"), known(1e3, "rad/(s^2*N*m)"), {}, {1e-3, 1}});
    return model;
}

const TuneAxesResult& tuned() {
    static const TuneAxesResult result = [] {
        LoopConditions x;
        x.timing = {1e-3, 1};
        x.currentLimit_A = 3.098;
        x.axis = LoopAxis{"x", "m", "N", 30.0, 1e-3};
        LoopConditions phi = x;
        phi.axis = LoopAxis{"phi", "rad", "N*m", 60.0, 5e-3};
        return *tuneAxes(platen(), {x, phi}, {});
    }();
    return result;
}

std::string written() {
    ResultHeader header;
    header.device = devices::DeviceInfo{};
    header.device->model = "two-axes";
    return *toJsonText(axisGainsDocument(header, tuned()));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(AxisLoopDocuments, gainsReadBackAsTheyWereWritten) {
    const auto file = parseAxisGains(written(), "g.json");
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_EQ(file->axes, (std::vector<std::string>{"x", "phi"}));
    EXPECT_EQ(file->device->model, "two-axes");
    for (std::size_t i = 0; i < 2; ++i) {
        const GainsFile& gains = file->gains[i];
        const TuneResult& axis = tuned().axes[i];
        EXPECT_DOUBLE_EQ(gains.law.gains.proportional, axis.law.gains.proportional);
        EXPECT_DOUBLE_EQ(gains.law.inertia_A_s2_rad, axis.law.inertia_A_s2_rad);
        ASSERT_TRUE(gains.filtered);
        EXPECT_DOUBLE_EQ(gains.filtered->proportionalWeight, 0.745);
        EXPECT_DOUBLE_EQ(*gains.filtered->gains.filter_s, *axis.filtered->gains.filter_s);
        EXPECT_EQ(gains.timing, (control::LoopTiming{1e-3, 1}));
        EXPECT_EQ(gains.method, "recommended");
    }
}

TEST(AxisLoopDocuments, numbersStandInTheUnitsOfTheirAxis) {
    const JsonValue body = axisGainsBody(tuned());
    const JsonValue& x = body.find("axes")->items()[0];
    EXPECT_EQ(x.find("axis")->text(), "x");
    EXPECT_EQ(x.find("gains")->find("kp")->find("unit")->text(), "N/m");
    EXPECT_EQ(x.find("gains")->find("ki")->find("unit")->text(), "N/(m*s)");
    EXPECT_EQ(x.find("gains")->find("feedforward_inertia")->find("unit")->text(), "N*s^2/m");
    const JsonValue* predicted = x.find("predicted");
    EXPECT_NE(predicted->find("friction_band_m"), nullptr);
    EXPECT_NE(predicted->find("proportional_limit_N_per_m"), nullptr);
    EXPECT_NE(predicted->find("step")->find("final_error_m"), nullptr);
    EXPECT_DOUBLE_EQ(predicted->find("large_step")->find("amplitude_m")->number(), 1e-3);
    EXPECT_NE(predicted->find("margins")->find("gain_crossover_rad_s"), nullptr) << "a frequency stays one";
    EXPECT_NE(x.find("proof")->find("peak_effort_N_per_m"), nullptr);
    EXPECT_NE(x.find("disturbance")->find("load_N"), nullptr);
    const JsonValue& phi = body.find("axes")->items()[1];
    EXPECT_EQ(phi.find("gains")->find("kd")->find("unit")->text(), "N*m*s/rad");
    EXPECT_NE(phi.find("proof")->find("noise_gain_Nm_per_rad"), nullptr);
    EXPECT_NE(phi.find("predicted")->find("friction_band_rad"), nullptr);
    const std::string text = *toJsonText(body);
    EXPECT_EQ(text.find("_A\""), std::string::npos) << "no key of a motor is left";
    EXPECT_EQ(text.find("A/rad"), std::string::npos);
}

TEST(AxisLoopDocuments, analysisHoldsTheSameJudgement) {
    const JsonValue body = axisAnalysisBody(tuned());
    const JsonValue& x = body.find("axes")->items()[0];
    EXPECT_TRUE(x.find("stable")->boolean());
    EXPECT_NE(x.find("robust"), nullptr);
    EXPECT_EQ(x.find("gains"), nullptr);
    EXPECT_TRUE(body.find("joint")->isNull()) << "of a model without covariance";
}

TEST(AxisLoopDocuments, knowsItsGainsFromThoseOfAMotor) {
    EXPECT_TRUE(isAxisGains(written()));
    EXPECT_FALSE(isAxisGains(R"({"schema": "halbench.gains/1", "gains": {}})"));
    const auto motor = parseAxisGains(R"({"schema": "halbench.gains/1", "gains": {}})", "g.json");
    ASSERT_FALSE(motor);
    EXPECT_NE(motor.error().message.find("single loop"), std::string::npos);
    const auto loop = parseGains(written(), "g.json");
    ASSERT_FALSE(loop);
    EXPECT_NE(loop.error().message.find("several axes"), std::string::npos) << loop.error().message;
}

TEST(AxisLoopDocuments, complaintsNameFileAxisAndKey) {
    const auto complaint = [](const std::string& text) {
        const auto file = parseAxisGains(text, "g.json");
        return file ? std::string() : file.error().message;
    };
    EXPECT_NE(complaint(replaced(written(), "\"N/m\"", "\"A/rad\"")).find("g.json: axis x: \"gains.kp\""),
              std::string::npos);
    EXPECT_NE(complaint(replaced(written(), "\"axis\": \"phi\"", "\"axis\": \"x\"")).find("\"axes\""),
              std::string::npos);
    EXPECT_NE(complaint(replaced(written(), "gains/1", "gains/2")).find("\"schema\""), std::string::npos);
    EXPECT_NE(complaint(replaced(written(), "\"kp\":", "\"kq\":")).find("axis x"), std::string::npos);
}

} // namespace
} // namespace halbench::app
