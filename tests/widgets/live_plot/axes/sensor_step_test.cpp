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

TEST(SensorStep, aJumpFromOneStreamToTheNextIsNone) {
    std::vector<control::TimedValue> samples = samplesOf({0.0, 0.0, 0.52, 0.52, 0.52});
    samples[2].isAfterGap = true;
    EXPECT_FALSE(sensorStep(samples));
    samples.back().value = 0.53; // the flicker of the new stream counts, the jump does not
    EXPECT_NEAR(sensorStep(samples).value(), 0.01, 1e-12);
}

TEST(SensorStep, rowsOfAnEarlierStreamInAHistoryAreNoStep) {
    control::SampleHistory history(1U << 20U);
    const auto addStream = [&history](double value, double begin_s) {
        auto block = std::make_shared<SampleBlock>();
        auto layout = std::make_shared<StreamLayout>();
        layout->columns = {{"position", "rad"}};
        layout->period_s = 0.01;
        block->layout = layout;
        for (int row = 0; row < 100; ++row) {
            block->time_s.push_back(0.01 * row);
            block->values.push_back(value);
        }
        block->hostArrival_s = begin_s + 1.0;
        history.append(*block);
    };
    addStream(0.0, 0.0);
    addStream(0.52, 1.0);
    std::vector<control::TimedValue> samples;
    const double end_s = history.range("position")->end_s;
    history.samples("position", {end_s - 0.5, end_s}, samples);
    EXPECT_FALSE(sensorStep(samples));
    history.samples("position", {0.5, end_s}, samples); // both streams
    EXPECT_FALSE(sensorStep(samples));
}

} // namespace
} // namespace halbench::widgets
