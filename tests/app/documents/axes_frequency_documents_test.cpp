#include "app/documents/axes_frequency_documents.h"
#include "app/documents/frequency_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace halbench::app {
namespace {

/// Two axes at one frequency with numbers that can be read by eye.
AxesFrequencyResult twoAxes() {
    AxesFrequencyResult result;
    AxesFrequencyPoint point;
    point.plant.frequency_rad_s = 20.0 * 3.14159265358979323846; // 10 Hz
    point.plant.value = Eigen::Matrix2cd{{{-0.1, 0.0}, {0.0, 0.001}}, {{0.01, 0.0}, {0.0, -10.0}}};
    point.plant.radius = Eigen::Matrix2d{{0.001, 0.002}, {0.001, 0.1}};
    point.plant.coherence = Eigen::Vector2d(0.99, 0.8);
    point.plant.averages = 24;
    point.loop.loops = {{{-0.5, 0.0}, 0.01}, {{0.0, -1.0}, 0.02}};
    point.loop.loci = {{{-0.5, 0.1}, 0.01}, {{0.0, -1.0}, 0.02}};
    point.loop.sensitivity = {{2.0, 0.0}, 0.1};
    point.loop.complementary = {{1.0, 0.0}, 0.1};
    point.isUsed = {true, false};
    result.points = {point};
    result.axes.resize(2);
    result.axes[0].axis.id = "x";
    result.axes[1].axis.id = "phi";
    result.bands = {{1.0, 50.0, 6, {0.5, 0.05}}};
    result.sensitivity = {MeasuredPeak::Withheld::No, 60.0, 2.0, 0.1};
    result.complementary = {MeasuredPeak::Withheld::Edge, 60.0, 1.0, 0.1};
    return result;
}

TEST(AxesFrequencyDocuments, rowsArePositionsAndColumnsCommands) {
    const JsonValue body = axesFrequencyBody(twoAxes());
    const JsonValue& plant = *body.find("points")->items()[0].find("plant");
    EXPECT_EQ(plant.items()[0].items()[1].find("im")->number(), 0.001);
    EXPECT_EQ(plant.items()[1].items()[0].find("re")->number(), 0.01);
    // The circle of x to phi holds zero: no interval of its size.
    EXPECT_TRUE(plant.items()[0].items()[1].find("magnitude_ci95_db")->isNull());
    EXPECT_FALSE(plant.items()[1].items()[1].find("magnitude_ci95_db")->isNull());
}

TEST(AxesFrequencyDocuments, aPeakIsToldOrWithheldWithTheReason) {
    const JsonValue body = axesFrequencyBody(twoAxes());
    EXPECT_EQ(body.find("sensitivity_peak")->find("value")->number(), 2.0);
    EXPECT_TRUE(body.find("sensitivity_peak")->find("withheld")->isNull());
    EXPECT_TRUE(body.find("complementary_peak")->find("value")->isNull());
    EXPECT_EQ(body.find("complementary_peak")->find("withheld")->text(), "edge");
    EXPECT_EQ(
        body.find("axes")->items()[0].find("margins")->find("phase_margin_deg")->find("withheld")->text(),
        "no_crossing");
}

TEST(AxesFrequencyDocuments, theTableHasAColumnForEachEntry) {
    const std::string table = axesFrequencyTable(twoAxes());
    const std::string head = table.substr(0, table.find('\n'));
    const std::string row = table.substr(table.find('\n') + 1);
    EXPECT_EQ(head.substr(0, 51), "frequency_hz,plant_x_x_db,plant_x_x_deg,plant_x_x_e");
    EXPECT_NE(head.find("plant_phi_x_db"), std::string::npos);
    EXPECT_NE(head.find("coherence_x,coherence_phi,used"), std::string::npos);
    EXPECT_EQ(std::count(head.begin(), head.end(), ','), std::count(row.begin(), row.end(), ','));
    EXPECT_EQ(row.substr(0, 9), "10,-20,-1"); // 0.1 is -20 dB, turned by half a turn
    EXPECT_EQ(row.substr(row.size() - 3), ",0\n");
}

} // namespace
} // namespace halbench::app
