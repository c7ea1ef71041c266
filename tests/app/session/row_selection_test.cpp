#include "app/session/row_selection.h"
#include "control/base/random.h"
#include "devices/recording/time_axis.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {
namespace {

std::shared_ptr<const StreamLayout> layoutOf(double period_s) {
    return std::make_shared<const StreamLayout>(StreamLayout{{{"a", "A"}}, period_s});
}

/// Rows at these times; the value is the time.
TimedBlock blockAt(const std::shared_ptr<const StreamLayout>& layout, std::vector<double> times_s,
                   std::uint64_t lost = 0) {
    auto block = std::make_shared<SampleBlock>();
    block->layout = layout;
    block->values = times_s;
    block->time_s = std::move(times_s);
    block->lostRows = lost;
    return TimedBlock(block);
}

std::vector<double> evenTimes(double from_s, double step_s, int rows) {
    std::vector<double> times_s;
    for (int row = 0; row < rows; ++row) {
        times_s.push_back(from_s + step_s * row);
    }
    return times_s;
}

struct Taken {
    std::size_t rows = 0;
    std::uint64_t missing = 0;
    void add(const std::vector<SampleBlock>& parts) {
        for (const SampleBlock& part : parts) {
            rows += part.rows();
            missing += part.lostRows;
        }
    }
};

TEST(RowSelection, aSlowerStreamForAWhileLosesNothingAndIsTold) {
    RowSelection selection(layoutOf(0.001), std::nullopt);
    Taken taken;
    taken.add(selection.take(blockAt(layoutOf(0.001), evenTimes(7.0, 0.001, 100))));
    const auto slow = layoutOf(0.005);
    taken.add(selection.take(blockAt(slow, evenTimes(7.103, 0.005, 40))));
    taken.add(selection.take(blockAt(slow, evenTimes(7.303, 0.005, 40))));
    taken.add(selection.take(blockAt(layoutOf(0.001), evenTimes(7.501, 0.001, 100))));
    EXPECT_EQ(taken.rows, 280U);
    EXPECT_EQ(taken.missing, 0U);
    const std::vector<RateChange> rates = selection.rates();
    ASSERT_EQ(rates.size(), 3U);
    EXPECT_EQ(rates[0].time_s, 0.0);
    EXPECT_EQ(rates[0].period_s, 0.001);
    EXPECT_NEAR(rates[1].time_s, 0.103, 1e-12);
    EXPECT_EQ(rates[1].period_s, 0.005);
    EXPECT_NEAR(rates[2].time_s, 0.501, 1e-12);
    EXPECT_EQ(rates[2].period_s, 0.001);
}

TEST(RowSelection, oneRateThroughoutIsNotTold) {
    RowSelection selection(layoutOf(0.01), std::nullopt);
    const auto dense = layoutOf(0.001);
    Taken taken;
    taken.add(selection.take(blockAt(dense, evenTimes(0.0, 0.001, 200))));
    taken.add(selection.take(blockAt(layoutOf(0.01), evenTimes(0.2, 0.01, 20)))); // as dense as what was kept
    EXPECT_EQ(taken.rows, 40U);
    EXPECT_EQ(taken.missing, 0U);
    EXPECT_TRUE(selection.rates().empty());
}

// A board starts its streams in any phase, on ticks of 125 us, and rows may be missing between them. What the
// file says of its gaps is what a reader counts on its axis.
TEST(RowSelection, aReaderCountsTheSameRowsWhateverThePhaseOfTheStreams) {
    Random random(5);
    const auto ticks_s = [&random] { return 0.000125 * static_cast<double>(1 + random.below(60)); };
    for (int trial = 0; trial < 400; ++trial) {
        const double begin_s = ticks_s();
        RowSelection selection(layoutOf(0.001), std::nullopt);
        Recording recording;
        Taken taken;
        double next_s = begin_s;
        for (const double period_s : {0.001, trial % 2 == 0 ? 0.001 : 0.005, 0.001}) {
            const auto parts = selection.take(blockAt(layoutOf(period_s), evenTimes(next_s, period_s, 40)));
            next_s += 39 * period_s + ticks_s();
            taken.add(parts);
            for (const SampleBlock& part : parts) {
                recording.layout = part.layout;
                recording.time_s.insert(recording.time_s.end(), part.time_s.begin(), part.time_s.end());
            }
        }
        recording.lostRows = devices::countLostRows(recording.time_s, 0.001);
        devices::setRates(recording, selection.rates());
        ASSERT_EQ(recording.lostRows, taken.missing) << trial;
    }
}

TEST(RowSelection, aPauseBetweenStreamsIsMissingRowsOfTheSlowerOne) {
    RowSelection selection(layoutOf(0.001), std::nullopt);
    Taken taken;
    taken.add(selection.take(blockAt(layoutOf(0.001), evenTimes(0.0, 0.001, 10))));
    // 0.009 to 0.109 are 20 steps of the slower stream: 19 rows would lie between.
    taken.add(selection.take(blockAt(layoutOf(0.005), evenTimes(0.109, 0.005, 10))));
    EXPECT_EQ(taken.missing, 19U);
}

TEST(RowSelection, rowsThatTheStreamLostAreMissingAtEveryRate) {
    const auto stream = layoutOf(0.001);
    RowSelection every(layoutOf(0.001), std::nullopt);
    RowSelection tenth(layoutOf(0.01), std::nullopt);
    Taken all;
    Taken some;
    for (const TimedBlock& block :
         {blockAt(stream, evenTimes(0.0, 0.001, 95)), blockAt(stream, evenTimes(0.125, 0.001, 95), 30)}) {
        all.add(every.take(block));
        some.add(tenth.take(block));
    }
    EXPECT_EQ(all.missing, 30U);
    EXPECT_EQ(some.missing, 3U) << "0.1, 0.11 and 0.12 s";
    EXPECT_EQ(some.rows, 10U + 9U) << "0 to 0.09, and 0.13 to 0.21 s: the phase is kept";
}

// A task that is held up stamps rows late, by up to 25 periods, and catches up: no row is lost.
TEST(RowSelection, rowsThatCameLateAreNotMissing) {
    const auto stream = layoutOf(0.001);
    RowSelection selection(layoutOf(0.001), std::nullopt);
    Taken taken;
    double stamp_s = 0.0;
    for (int first = 0; first < 1000; first += 10) {
        std::vector<double> times_s;
        for (int row = first; row < first + 10; ++row) {
            const double held_s = row % 97 == 60 ? 0.0253 : 0.0;
            stamp_s = std::max(0.001 * row + 0.00002 * (row % 3) + held_s, stamp_s + 0.0001);
            times_s.push_back(stamp_s);
        }
        taken.add(selection.take(blockAt(stream, std::move(times_s))));
    }
    EXPECT_EQ(taken.rows, 1000U);
    EXPECT_EQ(taken.missing, 0U);
}

TEST(RowSelection, blocksThatWereDroppedAreMissing) {
    const auto stream = layoutOf(0.01);
    RowSelection selection(layoutOf(0.01), std::nullopt);
    Taken taken;
    taken.add(selection.take(blockAt(stream, {0.0, 0.0104, 0.0196, 0.0301, 0.0398})));
    taken.add(selection.take(blockAt(stream, {0.1003, 0.1097, 0.1201}), true));
    EXPECT_EQ(taken.missing, 5U) << "0.05 to 0.09, though the stamps scatter";
}

TEST(RowSelection, nothingIsTakenFromTheEndOn) {
    RowSelection selection(layoutOf(0.01), 0.05);
    Taken taken;
    taken.add(selection.take(blockAt(layoutOf(0.01), evenTimes(0.0, 0.01, 20))));
    EXPECT_EQ(taken.rows, 5U);
    EXPECT_NEAR(selection.last_s(), 0.04, 1e-12);
}

} // namespace
} // namespace halbench::app
