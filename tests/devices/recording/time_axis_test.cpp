#include "devices/recording/time_axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace halbench::devices {
namespace {

TEST(TimeAxis, theMedianStepIsThePeriodWhateverTheGapsAre) {
    EXPECT_EQ(nominalPeriod({0.0, 1.0, 2.0, 9.0, 10.0, 11.0}), 1.0);
    EXPECT_EQ(nominalPeriod({5.0}), 0.0);
    EXPECT_EQ(nominalPeriod({}), 0.0);
}

TEST(TimeAxis, aGapHasLostTheRowsThatWouldFillIt) {
    EXPECT_EQ(countLostRows({0.0, 1.0, 4.0, 5.0, 7.0}, 1.0), 3U); // 2, 3 and 6
    EXPECT_EQ(countLostRows({0.0, 1.4, 2.0, 3.0}, 1.0), 0U) << "one late stamp is jitter";
    EXPECT_EQ(countLostRows({0.0, 100.0}, 0.0), 0U) << "without a period nothing is known to be missing";
}

TEST(TimeAxis, theRowsMissingBeforeARowCountByTheLayoutsPeriod) {
    Recording recording;
    recording.layout = std::make_shared<const StreamLayout>(StreamLayout{{}, 0.5});
    recording.time_s = {0.0, 0.5, 2.0};
    EXPECT_EQ(lostRowsBefore(recording, 0), 0U);
    EXPECT_EQ(lostRowsBefore(recording, 1), 0U);
    EXPECT_EQ(lostRowsBefore(recording, 2), 2U);
}

TEST(TimeAxis, jitterIsNoGapHoweverARowIsAskedFor) {
    Recording recording;
    recording.layout = std::make_shared<const StreamLayout>(StreamLayout{{}, 0.01});
    const double jitter[] = {0.0, 0.3, -0.3, 0.25, -0.28, 0.3, 0.0}; // of the period: steps up to 1.58
    for (int row = 0; row < 200; ++row) {
        recording.time_s.push_back(0.01 * (row + jitter[row % 7] + (row >= 100 ? 2.0 : 0.0)));
    }
    EXPECT_EQ(countLostRows(recording.time_s, 0.01), 2U);
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        EXPECT_EQ(lostRowsBefore(recording, row), row == 100 ? 2U : 0U) << row;
    }
}

/// 20 rows at 1 kHz, 30 at 200 Hz, 20 at 1 kHz again; the rows in `left` did not come.
Recording ofThreeRates(const std::vector<std::size_t>& left = {}) {
    Recording recording;
    recording.layout = std::make_shared<const StreamLayout>(StreamLayout{{}, 0.001});
    double time_s = 0.0;
    for (std::size_t row = 0; row < 70; ++row) {
        if (std::ranges::find(left, row) == left.end()) {
            recording.time_s.push_back(time_s);
        }
        time_s += row >= 19 && row < 49 ? 0.005 : 0.001;
    }
    return recording;
}

const std::vector<RateChange> ThreeRates = {{0.0, 0.001}, {0.024, 0.005}, {0.170, 0.001}};

TEST(TimeAxis, rowsOfASlowerStreamAreNotMissing) {
    Recording recording = ofThreeRates();
    EXPECT_EQ(countLostRows(recording.time_s, 0.001), 30U * 4U) << "what nobody told";
    setRates(recording, ThreeRates);
    EXPECT_EQ(recording.lostRows, 0U);
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        EXPECT_EQ(lostRowsBefore(recording, row), 0U) << row;
    }
}

TEST(TimeAxis, rowsThatAStreamOfAnyRateLostAreMissing) {
    // One of the fast ones, two of the slow ones, the first of the slow ones: four in all.
    Recording recording = ofThreeRates({10, 20, 30, 31});
    setRates(recording, {{0.0, 0.001}, {0.029, 0.005}, {0.170, 0.001}});
    EXPECT_EQ(recording.lostRows, 4U);
    std::uint64_t before = 0;
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        before += lostRowsBefore(recording, row);
    }
    EXPECT_EQ(before, 4U) << "the same, asked for row by row";
}

TEST(TimeAxis, ratesThatMakeNoSenseAreLeftOut) {
    constexpr double Inf = std::numeric_limits<double>::infinity();
    Recording recording = ofThreeRates();
    setRates(recording, {{0.0, 0.001},
                         {0.01, 0.0},
                         {0.012, -1.0},
                         {0.015, Inf},
                         {0.024, 0.005},
                         {0.02, 1.0},
                         {0.170, 0.001},
                         {0.2, 1e-320}});
    ASSERT_EQ(recording.rates.size(), 4U);
    EXPECT_EQ(recording.rates[1].period_s, 0.005);
    EXPECT_EQ(recording.lostRows, 0U) << "the last begins behind the last row";
    Recording none;
    none.layout = recording.layout;
    setRates(none, ThreeRates);
    EXPECT_EQ(none.lostRows, 0U);
}

} // namespace
} // namespace halbench::devices
