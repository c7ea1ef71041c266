#include "tests/widgets/live_data.h"
#include "widgets/live_plot/stale_text.h"

#include <gtest/gtest.h>

namespace halbench::widgets {
namespace {

TEST(StaleWords, aFreshSignalHasNoneAndOneWithoutValuesToo) {
    control::SampleHistory history{std::size_t{1} << 24};
    EXPECT_EQ(staleWords(history, "hall.a", "all old"), QString());
    appendMotor(history, 3.0);
    EXPECT_EQ(staleWords(history, "hall.a", {}), QString());
    EXPECT_EQ(staleWords(history, "no such signal", "all old"), QString());
}

TEST(StaleWords, repeatWhatHoldsForAll) {
    control::SampleHistory history{std::size_t{1} << 24};
    appendMotor(history, 3.0);
    EXPECT_EQ(staleWords(history, "hall.a", "all old"), "all old");
}

} // namespace
} // namespace halbench::widgets
