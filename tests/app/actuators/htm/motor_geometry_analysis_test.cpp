#include "app/actuators/htm/motor_geometry_analysis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

double figure(const MotorAnalysis& analysis, const std::string& key) {
    const auto found = std::find_if(analysis.figures.begin(), analysis.figures.end(),
                                    [&](const ComputedFigure& figure) { return figure.key == key; });
    EXPECT_NE(found, analysis.figures.end()) << key;
    return found == analysis.figures.end() ? std::nan("") : found->value;
}

TEST(FieldAnalysis, flagsARemanenceThatNoMagnetHas) {
    const MotorAnalysis nominal = analyseField({}, {});
    EXPECT_NEAR(figure(nominal, "centre_per_tesla"), 0.07690, 2e-5);
    EXPECT_NEAR(figure(nominal, "sensor"), 118.9, 0.05);
    EXPECT_NEAR(figure(nominal, "centre"), 101.5, 0.05);
    EXPECT_NEAR(figure(nominal, "remanence_sensor"), 1.743, 2e-3);
    EXPECT_NEAR(figure(nominal, "remanence_centre"), 2.042, 2e-3);
    EXPECT_NEAR(figure(nominal, "remanence_long"), 1.390, 2e-3);
    EXPECT_NEAR(figure(nominal, "radial"), 1.1711, 5e-4);
    EXPECT_NEAR(figure(nominal, "tangential"), 1.0558, 5e-4);
    EXPECT_NEAR(figure(nominal, "axis_end"), 0.6713, 5e-4);
    EXPECT_NEAR(figure(nominal, "calibration"), 157.0 / 118.9, 1e-3);
    EXPECT_EQ(figure(nominal, "remanence_is_real"), 0.0);
    ASSERT_EQ(nominal.quality.findings.size(), 1U);
    EXPECT_EQ(nominal.quality.findings[0].code, "remanence_not_real");
    EXPECT_EQ(nominal.quality.verdict, Verdict::Doubtful);
    FieldQuestion small; // the row of 30.0 mm: 1.284 T
    small.ringRadius_m = 30.0e-3;
    const MotorAnalysis possible = analyseField({}, small);
    EXPECT_NEAR(figure(possible, "remanence_sensor"), 1.284, 2e-3);
    EXPECT_EQ(figure(possible, "remanence_is_real"), 1.0);
    EXPECT_EQ(possible.quality.verdict, Verdict::Good);
}

TEST(CoilAnalysis, saysWhatPitchAndInductanceTheWindingHas) {
    const Result<MotorAnalysis> analysis = analyseCoil({}, 0.7e-3);
    ASSERT_TRUE(analysis.has_value());
    EXPECT_NEAR(figure(*analysis, "fill"), 0.53, 5e-3);
    EXPECT_NEAR(figure(*analysis, "pitch"), 0.784, 5e-4);
    EXPECT_NEAR(figure(*analysis, "fill_at_pitch"), 0.66, 5e-3);
    EXPECT_GT(figure(*analysis, "series_inductance"), 500.0);
    EXPECT_LT(figure(*analysis, "series_inductance"), 600.0);
    EXPECT_NEAR(figure(*analysis, "parameter_inductance"), 152.0, 1e-9);
    EXPECT_NEAR(figure(*analysis, "lag_difference"), 0.0, 5e-4); // 1.080 degrees either way
}

} // namespace
} // namespace halbench::app
