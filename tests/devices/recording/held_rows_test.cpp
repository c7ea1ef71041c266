#include "devices/recording/held_rows.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

std::shared_ptr<const StreamLayout> layout() {
    StreamLayout made;
    made.columns = {{"a", "A"}, {"b", "A"}};
    made.period_s = 0.25; // a power of two: sums of it are exact
    return std::make_shared<const StreamLayout>(made);
}

/// Rows first ... first + count - 1 of the stream; row i comes at i periods and says i and -i.
SampleBlockPtr block(const std::shared_ptr<const StreamLayout>& of, int first, int count,
                     std::uint64_t lostRows = 0) {
    auto made = std::make_shared<SampleBlock>();
    made->layout = of;
    made->lostRows = lostRows;
    for (int row = first; row < first + count; ++row) {
        made->time_s.push_back(row * of->period_s);
        made->values.insert(made->values.end(), {double(row), -double(row)});
    }
    return made;
}

std::vector<double> numbers(const std::vector<TimedBlock>& blocks, double shift_s = 0.0) {
    std::vector<double> rows;
    for (const TimedBlock& one : blocks) {
        for (std::size_t row = 0; row < one.rows(); ++row) {
            rows.push_back(one.block->value(row, 0));
            EXPECT_EQ(one.block->value(row, 1), -one.block->value(row, 0));
            EXPECT_EQ(one.time_s(row), 0.25 * one.block->value(row, 0) + shift_s);
        }
    }
    return rows;
}

TEST(HeldRows, givesEveryRowFromATimeOnOnceWhereverBlocksEnd) {
    for (const int size : {1, 2, 3, 7, 40}) {
        const auto of = layout();
        HeldRows held(100.0);
        for (int first = 0; first < 40; first += size) {
            held.add(block(of, first, std::min(size, 40 - first)));
        }
        for (int begin = 0; begin < 40; ++begin) {
            std::vector<double> expected;
            for (int row = begin; row < 40; ++row) {
                expected.push_back(row);
            }
            EXPECT_EQ(numbers(held.from(begin * 0.25)), expected) << size << " " << begin;
            EXPECT_EQ(numbers(held.from(begin * 0.25 - 0.1)), expected) << size << " " << begin;
        }
        EXPECT_TRUE(held.from(10.0).empty());
    }
}

TEST(HeldRows, aMomentIsOneOfTheAxisAndNotOfTheBlocks) {
    const auto of = layout();
    HeldRows held(100.0);
    for (int first = 0; first < 40; first += 4) {
        held.add({block(of, first, 4), 8.0});
    }
    EXPECT_EQ(held.oldest_s(), 8.0);
    EXPECT_EQ(held.newest_s(), 8.0 + 39 * 0.25);
    EXPECT_EQ(numbers(held.from(8.0 + 37 * 0.25), 8.0), (std::vector<double>{37, 38, 39}));
}

TEST(HeldRows, keepsItsLengthAndNotMuchMore) {
    const auto of = layout();
    HeldRows held(2.0);
    for (int first = 0; first < 1000; first += 4) {
        held.add(block(of, first, 4));
        // Two seconds with both ends, the newest block, and the rest of the oldest.
        ASSERT_LE(held.rows(), 8U + 1U + 4U + 3U);
    }
    EXPECT_EQ(held.newest_s(), 999 * 0.25);
    EXPECT_LE(*held.oldest_s(), 999 * 0.25 - 2.0);
    EXPECT_EQ(numbers(held.from(997 * 0.25)), (std::vector<double>{997, 998, 999}));
}

TEST(HeldRows, keepsItsLengthBeforeWhereverAnEventIsInTheNewestBlock) {
    const auto of = layout();
    HeldRows held(2.0);
    for (int first = 0; first < 400; first += 20) {
        held.add(block(of, first, 20));
        if (first >= 20) { // right behind the row before the block, two seconds earlier
            EXPECT_LE(*held.oldest_s(), (first - 1) * 0.25 - 2.0);
        }
    }
}

TEST(HeldRows, memoryIsBoundedWhateverTheLength) {
    const auto of = layout();
    HeldRows held(1e9, 30 * 3 * sizeof(double));
    for (int first = 0; first < 1000; first += 10) {
        held.add(block(of, first, 10));
        ASSERT_LE(held.bytes(), 30 * 3 * sizeof(double));
    }
    EXPECT_EQ(held.rows(), 30U);
    EXPECT_EQ(*held.oldest_s(), 970 * 0.25);
}

TEST(HeldRows, aGapInsideStaysAGapAndThereIsNoneBeforeTheFirstRow) {
    const auto of = layout();
    HeldRows held(100.0);
    held.add(block(of, 0, 4));
    held.add(block(of, 8, 0, 4)); // says what is lost before there is a row
    held.add(block(of, 10, 4, 2));
    const auto all = held.from(0.0);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].block->lostRows, 0U);
    EXPECT_EQ(all[1].block->lostRows, 6U);
    const auto late = held.from(10 * 0.25);
    ASSERT_EQ(late.size(), 1U);
    EXPECT_EQ(late[0].block->lostRows, 0U);
    EXPECT_EQ(numbers(late), (std::vector<double>{10, 11, 12, 13}));
}

TEST(HeldRows, aClockThatStartsAgainLeavesOnlyWhatCameSince) {
    const auto of = layout();
    HeldRows held(100.0);
    held.add(block(of, 50, 4));
    held.add(block(of, 0, 4));
    EXPECT_EQ(numbers(held.from(-1.0)), (std::vector<double>{0, 1, 2, 3}));
    held.clear();
    EXPECT_FALSE(held.newest_s());
    EXPECT_EQ(held.bytes(), 0U);
}

} // namespace
} // namespace halbench::devices
