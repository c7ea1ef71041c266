#include "widgets/live_plot/axes/sensor_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace halbench::widgets {
namespace {

std::vector<control::TimedValue> samplesOf(const std::vector<double>& values) {
    std::vector<control::TimedValue> samples;
    for (std::size_t i = 0; i < values.size(); ++i) {
        samples.push_back({0.001 * static_cast<double>(i), values[i], false});
    }
    return samples;
}

TEST(SensorStep, flickerBetweenStepsOfAConverterTellsTheStep) {
    constexpr double Step = 0.0025;
    EXPECT_DOUBLE_EQ(sensorStep(samplesOf({Step, 0.0, 0.0, Step, 0.0})).value(), Step);
    // The least difference seen, although two steps are jumped over in between.
    EXPECT_NEAR(sensorStep(samplesOf({10 * Step, 7 * Step, 8 * Step, 10 * Step})).value(), Step, 1e-15);
}

TEST(SensorStep, smoothConstantAndMissingValuesHaveNone) {
    std::vector<double> smooth;
    for (int i = 0; i < 500; ++i) {
        smooth.push_back(std::sin(0.1 * i));
    }
    EXPECT_FALSE(sensorStep(samplesOf(smooth)));
    EXPECT_FALSE(sensorStep(samplesOf({0.0, 1.0, 2.41, 0.0}))); // 1.41 is no whole multiple
    EXPECT_FALSE(sensorStep(samplesOf({3.0, 3.0, 3.0})));
    EXPECT_FALSE(sensorStep({}));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(sensorStep(samplesOf({nan, 1.0, nan})));
    EXPECT_DOUBLE_EQ(sensorStep(samplesOf({nan, 1.0, 3.0})).value(), 2.0);
}

} // namespace
} // namespace halbench::widgets
