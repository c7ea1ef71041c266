#include "app/workbench/signals/signal_stretch.h"
#include "control/signals/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::app {
namespace {

/// Ten seconds of a counter at 100 Hz; the other signal is missing in every second row.
control::SampleHistory counted() {
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{"count", "A"}, {"half", ""}};
    layout->period_s = 0.01;
    SampleBlock block;
    block.layout = layout;
    for (int row = 0; row < 1000; ++row) {
        block.time_s.push_back(0.01 * row);
        block.values.push_back(row);
        block.values.push_back(row % 2 == 0 ? row : std::numeric_limits<double>::quiet_NaN());
    }
    control::SampleHistory history(std::size_t{1} << 24);
    history.append(block);
    return history;
}

TEST(SignalStretchTest, copiesTheNewestSecondsWithTheirUnit) {
    const control::SampleHistory history = counted();
    const SignalStretch stretch = lastStretch(history, "count", 2.0, 100000);
    ASSERT_EQ(stretch.values.size(), 201U); // both ends
    EXPECT_EQ(stretch.values.front(), 799.0);
    EXPECT_EQ(stretch.values.back(), 999.0);
    EXPECT_EQ(stretch.unit, "A");
}

TEST(SignalStretchTest, copiesNoMoreRowsThanItMay) {
    const control::SampleHistory history = counted();
    const SignalStretch stretch = lastStretch(history, "count", 1e6, 50);
    EXPECT_LE(stretch.values.size(), 52U);
    EXPECT_GE(stretch.values.size(), 48U);
    EXPECT_EQ(stretch.values.back(), 999.0);
}

TEST(SignalStretchTest, ofASignalThatNeverCameThereIsNothing) {
    const control::SampleHistory history = counted();
    EXPECT_TRUE(lastStretch(history, "nobody", 2.0, 100).time_s.empty());
}

TEST(SignalStretchTest, aStreamThatWasStartedAnewIsAGapForASpectrum) {
    control::SampleHistory history(std::size_t{1} << 24);
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{"x", "A"}};
    layout->period_s = 0.01;
    for (const double begin_s : {0.0, 5.004}) { // four tenths of a step late
        SampleBlock block;
        block.layout = layout;
        block.lostRows = begin_s > 0.0 ? 1 : 0;
        for (int row = 0; row < 500; ++row) {
            block.time_s.push_back(begin_s + 0.01 * row);
            block.values.push_back(std::sin(0.2 * row));
        }
        history.append(block);
    }
    const SignalStretch stretch = lastStretch(history, "x", 100.0, 10000);
    ASSERT_EQ(stretch.gaps, std::vector<std::size_t>{500});
    const control::SpectrumConfig config{.segment_s = 1.0};
    EXPECT_FALSE(control::spectrum({stretch.time_s, stretch.values, "A"}, config));
    const SignalStretch open = withOpenGaps(stretch);
    EXPECT_NEAR(open.time_s[500] - open.time_s[499], 0.02, 1e-9);
    EXPECT_NEAR(open.time_s[501] - open.time_s[500], 0.01, 1e-9);
    const auto spectrum = control::spectrum({open.time_s, open.values, "A"}, config);
    ASSERT_TRUE(spectrum) << spectrum.error().message;
    EXPECT_EQ(spectrum->gaps, 1U);
}

TEST(SignalStretchTest, pairsOnlyRowsInWhichBothAreThere) {
    const control::SampleHistory history = counted();
    const SignalPair pair =
        pairUp(lastStretch(history, "count", 1.0, 1000), lastStretch(history, "half", 2.0, 1000));
    ASSERT_EQ(pair.x.size(), 50U); // the even ones of 899 ... 999
    EXPECT_EQ(pair.x, pair.y);
}

} // namespace
} // namespace halbench::app
