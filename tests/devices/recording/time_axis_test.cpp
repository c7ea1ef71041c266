#include "devices/recording/time_axis.h"

#include <gtest/gtest.h>

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

} // namespace
} // namespace halbench::devices
