#include "control/assess/loop_rows.h"

#include <gtest/gtest.h>

#include <utility>

namespace halbench::control {
namespace {

TEST(LoopRows, areMillisecondsOrPartsOfThePeriod) {
    const auto seen = [](double period_s) {
        const LoopRows rows(period_s);
        EXPECT_EQ(rows.time_s(0), 0.0);
        EXPECT_DOUBLE_EQ(rows.time_s(7 * rows.perPeriod()), 7.0 * period_s);
        EXPECT_DOUBLE_EQ(rows.time_s(1), rows.interval_s());
        return std::pair(rows.perPeriod(), rows.interval_s());
    };
    EXPECT_EQ(seen(0.01), std::pair(10L, 1e-3));
    EXPECT_EQ(seen(0.001), std::pair(1L, 1e-3));
    EXPECT_EQ(seen(1.5e-3), std::pair(2L, 0.75e-3));
    EXPECT_EQ(seen(2.5e-3), std::pair(3L, 2.5e-3 / 3.0));
    EXPECT_EQ(seen(4e-4), std::pair(1L, 4e-4));
    EXPECT_EQ(LoopRows(0.01).time_s(123), 0.123); // to the bit
    EXPECT_TRUE(isWholeMilliseconds(3.0 * 0.001));
    EXPECT_FALSE(isWholeMilliseconds(1e-4));
    EXPECT_FALSE(isWholeMilliseconds(1.0005e-3));
}

} // namespace
} // namespace halbench::control
