#include "app/workbench/signals/stream_time_offsets.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

TEST(StreamTimeOffsets, areNoneBeforeARowCame) {
    const StreamTimeOffsets shifts;
    EXPECT_EQ(shifts.at(3.0), 0.0);
    EXPECT_EQ(shifts.newest(), 0.0);
}

TEST(StreamTimeOffsets, eachStretchHasItsOwn) {
    StreamTimeOffsets shifts;
    shifts.note(0.0, 0.0);
    shifts.note(0.1, 0.0);
    shifts.note(5.0, 0.004); // a stream that began anew
    shifts.note(5.1, 0.004);
    shifts.note(9.0, 9.0); // the clock began again
    EXPECT_EQ(shifts.at(-1.0), 0.0);
    EXPECT_EQ(shifts.at(4.999), 0.0);
    EXPECT_EQ(shifts.at(5.0), 0.004);
    EXPECT_EQ(shifts.at(8.9), 0.004);
    EXPECT_EQ(shifts.at(9.0), 9.0);
    EXPECT_EQ(shifts.at(1e6), 9.0);
    EXPECT_EQ(shifts.newest(), 9.0);
}

TEST(StreamTimeOffsets, aMomentAtTheFirstRowOfAStretchIsOfThatStretchWhateverTheRounding) {
    StreamTimeOffsets shifts;
    shifts.note(0.0, 0.0);
    shifts.note(86400.1 + 0.2, 7.0); // 86400.3 has another last bit
    EXPECT_EQ(shifts.at(86400.3), 7.0);
    shifts.note(90000.0, 7.0 + 1e-11);
    EXPECT_EQ(shifts.newest(), 7.0) << "the same, but for its rounding";
}

TEST(StreamTimeOffsets, aClearedHistoryBeginsAnew) {
    StreamTimeOffsets shifts;
    shifts.note(0.0, 0.0);
    shifts.note(5.0, 5.0);
    shifts.note(0.0, 0.0);
    EXPECT_EQ(shifts.at(6.0), 0.0);
}

} // namespace
} // namespace halbench::app
