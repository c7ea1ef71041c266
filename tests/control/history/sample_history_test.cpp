#include "control/history/sample_history.h"
#include "tests/control/history/history_blocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

const double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t Large = std::size_t{1} << 30;
constexpr double Period_s = 1e-3;

double ramp(std::size_t row, std::size_t column) {
    return static_cast<double>(row) + 1000.0 * static_cast<double>(column);
}

std::vector<HistoryColumn> columnsOf(const SampleHistory& history, const std::string& signal, TimeRange range,
                                     std::size_t count) {
    std::vector<HistoryColumn> columns;
    history.columns(signal, range, count, columns);
    return columns;
}

TEST(SampleHistory, knowsNothingAtFirst) {
    const SampleHistory history(Large);
    EXPECT_TRUE(history.signals().empty());
    EXPECT_FALSE(history.range());
    EXPECT_FALSE(history.latest("a"));
    EXPECT_FALSE(history.valueAt("a", 0.0));
    EXPECT_TRUE(history.extremes("a", {0.0, 1.0}).isEmpty());
    EXPECT_EQ(columnsOf(history, "a", {0.0, 1.0}, 10).size(), 10U);
}

TEST(SampleHistory, givesBackWhatCameIn) {
    SampleHistory history(Large);
    history.append(blockOf(layoutOf({"a", "b"}, 0.01), 0, 100, ramp));
    EXPECT_EQ(history.signals(), (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(history.unit("a"), "T");
    EXPECT_DOUBLE_EQ(history.range()->end_s, 0.99);
    EXPECT_DOUBLE_EQ(history.latest("b")->value, 1099.0);
    EXPECT_DOUBLE_EQ(history.valueAt("a", 0.504)->value, 50.0);
    EXPECT_DOUBLE_EQ(history.valueAt("a", 0.506)->value, 51.0);
    EXPECT_FALSE(history.valueAt("a", 1.1)); // later than anything known
    EXPECT_DOUBLE_EQ(history.extremes("b", {0.1, 0.2}).max, 1020.0);
    EXPECT_EQ(history.rowsIn("a", {0.1, 0.2}), 10U);
}

TEST(SampleHistory, samplesReachBeyondBothEndsOfTheStretch) {
    SampleHistory history(Large);
    history.append(blockOf(layoutOf({"a"}, 0.01), 0, 100, ramp));
    std::vector<TimedValue> samples;
    history.samples("a", {0.105, 0.125}, samples);
    ASSERT_EQ(samples.size(), 4U);
    EXPECT_DOUBLE_EQ(samples.front().value, 10.0);
    EXPECT_DOUBLE_EQ(samples.back().value, 13.0);
}

TEST(SampleHistory, columnsLoseNoSpike) {
    SampleHistory history(Large);
    const auto layout = layoutOf({"a"}, 0.001);
    for (std::size_t first = 0; first < 300'000; first += 100) {
        history.append(blockOf(layout, first, 100, [](std::size_t row, std::size_t) {
            return row == 123'456 ? 9.0 : std::sin(0.001 * static_cast<double>(row));
        }));
    }
    const auto columns = columnsOf(history, "a", {0.0, 300.0}, 1600);
    const std::size_t expected = 123'456 * 1600 / 300'000;
    std::size_t found = 0;
    while (found < columns.size() && columns[found].extremes.max < 8.0) {
        ++found;
    }
    EXPECT_LE(found > expected ? found - expected : expected - found, 1U);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        ASSERT_FALSE(columns[i].extremes.isEmpty());
        EXPECT_EQ(columns[i].isAfterGap, i == 0) << i;
    }
}

TEST(SampleHistory, forgetsOneSignalAndKeepsTheOthers) {
    SampleHistory history(Large);
    const auto layout = layoutOf({"a", "b"}, 0.01);
    history.append(blockOf(layout, 0, 100, ramp));
    const std::uint64_t before = history.revision();
    history.forget("b");
    history.forget("never there");
    EXPECT_GT(history.revision(), before);
    EXPECT_EQ(history.signals(), (std::vector<std::string>{"a"}));
    EXPECT_FALSE(history.contains("b"));
    EXPECT_FALSE(history.valueAt("b", 0.5));
    EXPECT_DOUBLE_EQ(history.valueAt("a", 0.5)->value, 50.0);
    // What comes under the name again is all that it has, even with the very layout of before.
    history.append(blockOf(layout, 100, 100, ramp));
    EXPECT_DOUBLE_EQ(history.range("b")->begin_s, 1.0);
    EXPECT_DOUBLE_EQ(history.range("a")->begin_s, 0.0);
    EXPECT_DOUBLE_EQ(history.latest("b")->value, 1199.0);
    EXPECT_EQ(history.unit("b"), "T");
}

TEST(SampleHistory, rowsTheBoardLostAreAGap) {
    SampleHistory history(Large);
    const auto layout = layoutOf({"a"}, 0.001);
    history.append(blockOf(layout, 0, 5000, ramp));
    SampleBlock late = blockOf(layout, 6000, 4000, ramp);
    late.lostRows = 1000;
    history.append(late);
    EXPECT_EQ(history.lostRows(), 1000U);
    const auto columns = columnsOf(history, "a", {0.0, 10.0}, 100);
    EXPECT_TRUE(columns[55].extremes.isEmpty());
    EXPECT_TRUE(columns[60].isAfterGap);
    EXPECT_FALSE(columns[61].isAfterGap);
    EXPECT_FALSE(history.valueAt("a", 5.5));
}

TEST(SampleHistory, aJumpOfTheClockIsAGapThoughNobodyCountedIt) {
    SampleHistory history(Large);
    const auto layout = layoutOf({"a"}, 0.01);
    history.append(blockOf(layout, 0, 10, ramp));
    history.append(blockOf(layout, 50, 10, ramp));
    std::vector<TimedValue> samples;
    history.samples("a", {0.0, 1.0}, samples);
    ASSERT_EQ(samples.size(), 20U);
    EXPECT_TRUE(samples[10].isAfterGap);
    EXPECT_FALSE(samples[11].isAfterGap);
}

TEST(SampleHistory, aValueThatIsNoNumberIsABreak) {
    SampleHistory history(Large);
    history.append(blockOf(layoutOf({"a", "b"}, 0.001), 0, 10'000, [](std::size_t row, std::size_t column) {
        return column == 0 && row >= 4000 && row < 5000 ? (row % 2 == 0 ? NaN : INFINITY) : 1.0;
    }));
    const auto columns = columnsOf(history, "a", {0.0, 10.0}, 100);
    EXPECT_TRUE(columns[45].extremes.isEmpty());
    EXPECT_TRUE(columns[50].isAfterGap);
    EXPECT_FALSE(columnsOf(history, "b", {0.0, 10.0}, 100)[50].isAfterGap);
    EXPECT_FALSE(history.valueAt("a", 4.5));
}

TEST(SampleHistory, timeGoesOnWhenTheDevicesClockStartsAgain) {
    SampleHistory history(Large);
    const auto layout = layoutOf({"a"}, 0.01);
    SampleBlock first = blockOf(layout, 0, 100, ramp);
    first.hostArrival_s = 50.0;
    history.append(first);
    SampleBlock again = blockOf(layoutOf({"a"}, 0.01), 0, 11, ramp); // 0.1 s long, arrived 3 s later
    again.hostArrival_s = 53.0;
    history.append(again);
    EXPECT_NEAR(history.range()->end_s, 0.99 + 3.0, 1e-12);
    std::vector<TimedValue> samples;
    history.samples("a", {0.9, 5.0}, samples);
    EXPECT_TRUE(samples[samples.size() - 11].isAfterGap);
    EXPECT_TRUE(std::is_sorted(samples.begin(), samples.end(),
                               [](const auto& l, const auto& r) { return l.time_s < r.time_s; }));
}

TEST(SampleHistory, aSignalGoesOnInAStreamWithOtherSignalsAndAnotherRate) {
    SampleHistory history(Large);
    history.append(blockOf(layoutOf({"a", "b"}, 0.001), 0, 1000, ramp));
    history.append(blockOf(layoutOf({"c", "a"}, 0.1), 0, 20, ramp));
    EXPECT_EQ(history.signals(), (std::vector<std::string>{"a", "b", "c"}));
    EXPECT_NEAR(history.range("a")->end_s, 0.999 + 0.1 + 1.9, 1e-12);
    EXPECT_NEAR(history.range("b")->end_s, 0.999, 1e-12);
    EXPECT_DOUBLE_EQ(history.latest("a")->value, 1019.0); // its column is another one now
    // Ten times slower samples are still one line: only the change itself is a gap.
    const auto columns = columnsOf(history, "a", {0.0, 3.0}, 300);
    int gaps = 0;
    for (const HistoryColumn& column : columns) {
        gaps += column.isAfterGap ? 1 : 0;
    }
    EXPECT_EQ(gaps, 2);
}

// As when a derived signal comes and goes: the device keeps its layout, another one was there in between.
TEST(SampleHistory, aSignalStaysInOrderWhenItsFirstStreamComesBack) {
    SampleHistory history(Large);
    const auto alone = layoutOf({"a"}, Period_s);
    const auto together = layoutOf({"a", "b"}, Period_s);
    const auto row = [](std::size_t r, std::size_t) { return static_cast<double>(r); };
    history.append(blockOf(alone, 0, 100, row));
    history.append(blockOf(together, 100, 100, row));
    history.append(blockOf(alone, 200, 100, row));
    history.append(blockOf(alone, 300, 100, row));
    EXPECT_EQ(history.latest("a")->value, 399.0);
    EXPECT_EQ(history.range("a")->end_s, 399.0 * Period_s);
    std::vector<TimedValue> samples;
    history.samples("a", {0.0, 1e3}, samples);
    ASSERT_EQ(samples.size(), 400U);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        ASSERT_EQ(samples[i].value, static_cast<double>(i));
    }
}

// Two events that take turns are two streams and stay two.
TEST(SampleHistory, streamsOfOtherSignalsTakeTurns) {
    SampleHistory history(Large);
    const auto fast = layoutOf({"a"}, Period_s);
    const auto slow = layoutOf({"b"}, 10.0 * Period_s);
    const auto one = [](std::size_t, std::size_t) { return 1.0; };
    for (std::size_t turn = 0; turn < 10; ++turn) {
        history.append(blockOf(fast, 100 * turn, 100, one));
        history.append(blockOf(slow, 10 * turn, 10, one));
    }
    const SampleStatistics statistics = history.statistics("a", {0.0, 1e3});
    EXPECT_EQ(statistics.moments.count(), 1000U);
    EXPECT_EQ(statistics.gaps, 0U);
}

TEST(SampleHistory, memoryIsFlatOnceTheBudgetIsFull) {
    const std::size_t budget = 20 * SampleChunk::bytesFor(2);
    SampleHistory history(budget);
    const auto layout = layoutOf({"a", "b"}, 0.001);
    for (std::size_t first = 0; first < 400'000; first += 500) {
        history.append(blockOf(layout, first, 500, ramp));
        ASSERT_LE(history.bytes(), budget);
    }
    EXPECT_GT(history.bytes(), budget * 9 / 10);
    EXPECT_DOUBLE_EQ(history.latest("a")->value, 399'999.0);
    EXPECT_GT(history.range()->begin_s, 300.0);
    EXPECT_DOUBLE_EQ(history.valueAt("a", 350.0)->value, 350'000.0);
}

TEST(SampleHistory, oldStreamsGoFirstAndTheirSignalsStayKnown) {
    SampleHistory history(2 * SampleChunk::bytesFor(2));
    history.append(blockOf(layoutOf({"old"}, 0.001), 0, 100, ramp));
    const auto layout = layoutOf({"a", "b"}, 0.001);
    history.append(blockOf(layout, 0, 20'000, ramp));
    EXPECT_TRUE(history.contains("old"));
    EXPECT_FALSE(history.latest("old"));
    EXPECT_TRUE(history.unit("old").empty());
    EXPECT_TRUE(history.latest("a"));
}

TEST(SampleHistory, clearForgetsEverythingAndSaysSo) {
    SampleHistory history(Large);
    history.append(blockOf(layoutOf({"a"}, 0.01), 0, 100, ramp));
    const std::uint64_t revision = history.revision();
    history.clear();
    EXPECT_NE(history.revision(), revision);
    EXPECT_FALSE(history.range());
    history.append(blockOf(layoutOf({"a"}, 0.01), 0, 10, ramp));
    EXPECT_DOUBLE_EQ(history.range()->end_s, 0.09);
}

TEST(SampleHistory, blocksWithoutRowsOrColumnsAreHarmless) {
    SampleHistory history(Large);
    history.append(SampleBlock{});
    history.append(blockOf(layoutOf({}, 0.01), 0, 3, ramp));
    SampleBlock empty = blockOf(layoutOf({"a"}, 0.01), 0, 0, ramp);
    empty.lostRows = 4;
    history.append(empty);
    EXPECT_FALSE(history.range());
    EXPECT_EQ(history.lostRows(), 4U);
}

/// A block changed by hand is the second route to the same history.
TEST(SampleHistory, columnsBesideABlockGiveTheHistoryOfABlockThatIsChanged) {
    const auto layout = layoutOf({"a", "b"}, 0.01);
    const auto longer = layoutOf({"a", "b", "sum"}, 0.01);
    SampleHistory beside(Large);
    SampleHistory changed(Large);
    for (std::size_t first = 0; first < 10'000; first += 250) {
        const SampleBlock block = blockOf(layout, first, 250, ramp);
        BlockColumns columns;
        columns.shift_s = 7.5;
        columns.layout = longer;
        columns.added.emplace_back();
        SampleBlock copy = block;
        copy.layout = longer;
        copy.values.clear();
        for (std::size_t row = 0; row < block.rows(); ++row) {
            const double hidden = row % 3 == 0 ? NaN : block.value(row, 1);
            columns.replaced[1].push_back(hidden);
            columns.added[0].push_back(block.value(row, 0) + hidden);
            copy.time_s[row] += 7.5;
            copy.values.insert(copy.values.end(), {block.value(row, 0), hidden, columns.added[0].back()});
        }
        beside.append(block, columns);
        changed.append(copy);
    }
    ASSERT_EQ(beside.range(), changed.range());
    EXPECT_EQ(beside.range()->begin_s, 7.5);
    for (const char* name : {"a", "b", "sum"}) {
        std::vector<TimedValue> one;
        std::vector<TimedValue> other;
        ASSERT_TRUE(beside.samples(name, *beside.range(), one));
        ASSERT_TRUE(changed.samples(name, *beside.range(), other));
        ASSERT_EQ(one.size(), 10'000U);
        ASSERT_EQ(one.size(), other.size());
        for (std::size_t row = 0; row < one.size(); ++row) {
            ASSERT_EQ(one[row].time_s, other[row].time_s);
            ASSERT_TRUE(one[row].value == other[row].value ||
                        (std::isnan(one[row].value) && std::isnan(other[row].value)));
        }
        EXPECT_EQ(beside.extremes(name, *beside.range()).max, changed.extremes(name, *beside.range()).max);
    }
}

} // namespace
} // namespace halbench::control
