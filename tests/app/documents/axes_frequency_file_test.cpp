#include "app/documents/axes_frequency_documents.h"
#include "app/documents/axes_frequency_file.h"
#include "control/base/units.h"
#include "control/law/board_law.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

/// Free masses of 0.64 kg and 1e-3 kg m^2, as measured in loops that ran with a filter section in x.
AxesFrequencyResult measured() {
    AxesFrequencyResult result;
    result.delaySamples = 1;
    result.axes.resize(2);
    result.axes[0].axis.id = "x";
    result.axes[0].axis.positionUnit = "m";
    result.axes[0].axis.effortUnit = "N";
    result.axes[1].axis.id = "phi";
    result.axes[1].axis.positionUnit = "rad";
    result.axes[1].axis.effortUnit = "N*m";
    for (AxisResponse& response : result.axes) {
        response.law.period_s = 1e-3;
        response.law.delaySamples = 1;
        response.law.kp_A_per_rad = 660.0;
        response.law.kd_As_per_rad = 40.0;
        response.law.derivativeFilter_s = 2e-3;
    }
    result.axes[0].law.sections = {{1.0, 0.1, 0.02, 0.3, 0.02}};
    for (const double frequency_Hz : {2.0, 5.0, 10.0}) {
        const double w = 2.0 * Pi * frequency_Hz;
        AxesFrequencyPoint point;
        point.plant.frequency_rad_s = w;
        point.plant.value = Eigen::Matrix2cd::Zero();
        point.plant.radius = Eigen::Matrix2d::Zero();
        point.plant.coherence = Eigen::Vector2d(0.99, 0.5);
        for (const AxisResponse& response : result.axes) {
            const double inertia = response.axis.id == "x" ? 0.64 : 1e-3;
            const std::complex<double> loop = -1.0 / (inertia * w * w) * std::polar(1.0, -w * 1e-3) *
                                              control::feedbackResponse(response.law, w);
            point.loop.loops.push_back({loop, 0.01});
            point.loop.loci.push_back({loop, 0.01});
        }
        point.isUsed = {true, frequency_Hz < 6.0};
        result.points.push_back(point);
    }
    return result;
}

std::string written(const AxesFrequencyResult& result = measured()) {
    ResultHeader header;
    header.schema = AxisFrequencySchema;
    header.quality = result.quality;
    return *toJsonText(axesFrequencyDocument(header, result));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

AxisModel modelWith(const char* axis, const char* position, const char* effort) {
    AxisModel model;
    model.axes.push_back({axis, position, effort, {}, {}, {}, {}});
    return model;
}

// -1/(m w^2) of a free mass, whatever law ran while it was measured.
TEST(AxesFrequencyFile, plantsAreThoseThatWereMeasured) {
    const auto file = parseAxesFrequency(written(), "r.json");
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_EQ(file->axes.size(), 2U);
    EXPECT_EQ(file->axes[1].axis, "phi");
    EXPECT_EQ(file->axes[1].effortUnit, "N*m");
    for (const AxisPlantFile& axis : file->axes) {
        const double inertia = axis.axis == "x" ? 0.64 : 1e-3;
        ASSERT_EQ(axis.plant.points.size(), 3U);
        EXPECT_EQ(axis.plant.period_s, 1e-3);
        EXPECT_EQ(axis.plant.leastCoherence, 0.9);
        for (const MeasuredPlant::Point& point : axis.plant.points) {
            const double w = 2.0 * Pi * point.frequency_Hz;
            EXPECT_NEAR(point.value.real() * inertia * w * w, -1.0, 1e-9) << axis.axis;
            EXPECT_NEAR(point.value.imag() * inertia * w * w, 0.0, 1e-9) << axis.axis;
        }
    }
    EXPECT_TRUE(file->axes[0].plant.points[2].isUsed);
    EXPECT_FALSE(file->axes[1].plant.points[2].isUsed);
    EXPECT_EQ(file->axes[1].plant.points[0].coherence, 0.5);
}

TEST(AxesFrequencyFile, placeOfAnErrorIsNamed) {
    const std::string good = written();
    const auto place = [](const std::string& text) {
        const auto file = parseAxesFrequency(text, "r.json");
        return file ? std::string() : file.error().message;
    };
    EXPECT_NE(place("{").find("r.json"), std::string::npos);
    EXPECT_NE(place(replaced(good, AxisFrequencySchema, "halbench.frequency/1")).find("schema"),
              std::string::npos);
    EXPECT_NE(place(replaced(good, "\"effort_unit\": \"N\"", "\"effort_unit\": \"\"")).find("axes[0]"),
              std::string::npos);
    EXPECT_NE(place(replaced(good, "\"kp\": 660", "\"kp\": null")).find("axes[0]: gains"), std::string::npos);
    EXPECT_NE(place(replaced(good, "\"frequency_hz\": 5", "\"frequency_hz\": 1")).find("points[1]"),
              std::string::npos);
    EXPECT_NE(place(replaced(good, "\"frequency_hz\": 10", "\"frequency_hz\": 501")).find("points[2]"),
              std::string::npos);
    EXPECT_NE(place(replaced(good, "\"sample_period_s\": 0.001", "\"sample_period_s\": 0")).find("sample"),
              std::string::npos);
    EXPECT_NE(
        place(replaced(good, "\"delay_samples\": 1", "\"delay_samples\": 2.5")).find("\"delay_samples\" is"),
        std::string::npos);
    EXPECT_NE(place(replaced(good, "0.99", "1.2")).find("\"points[0].coherence[0]\" is 1.2"),
              std::string::npos);
    AxesFrequencyResult empty = measured();
    empty.points.clear();
    EXPECT_NE(place(written(empty)).find("points"), std::string::npos);
}

TEST(AxesFrequencyFile, rejectedResponseIsNotTaken) {
    AxesFrequencyResult rejected = measured();
    rejected.quality.verdict = Verdict::Refused;
    const auto file = parseAxesFrequency(written(rejected), "r.json");
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().code, ErrorCode::Refused);
}

TEST(AxesFrequencyFile, plantsAreTakenForAxesOfTheModelInItsUnits) {
    const auto file = parseAxesFrequency(written(), "r.json");
    ASSERT_TRUE(file);
    const auto plants = plantsFor(modelWith("x", "m", "N"), *file);
    ASSERT_TRUE(plants);
    EXPECT_EQ(plants->size(), 1U);
    EXPECT_EQ(plants->count("x"), 1U);
    const auto otherUnit = plantsFor(modelWith("phi", "rad", "A"), *file);
    ASSERT_FALSE(otherUnit);
    EXPECT_EQ(otherUnit.error().message, "axis phi: the response is in rad/(N*m), the model in rad/(A)");
    const auto otherAxis = plantsFor(modelWith("z", "m", "N"), *file);
    ASSERT_FALSE(otherAxis);
    EXPECT_EQ(otherAxis.error().message, "the response is of axes x, phi, the model has z");
}

} // namespace
} // namespace halbench::app
