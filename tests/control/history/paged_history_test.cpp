#include "tests/control/history/history_twins.h"

namespace halbench::control {
namespace {

TEST(PagedHistory, drawsTheSameEnvelopesAndSamples) {
    Twins twins;
    recordTrouble(twins);
    ASSERT_GT(twins.pages->pages(), 40U);
    ASSERT_EQ(twins.plain.range(), twins.paged.range());
    Random random(5);
    std::vector<HistoryColumn> plainColumns;
    std::vector<HistoryColumn> pagedColumns;
    std::vector<TimedValue> plainSamples;
    std::vector<TimedValue> pagedSamples;
    for (int i = 0; i < 300; ++i) {
        const TimeRange range = someRange(random, *twins.plain.range());
        const std::string signal = twins.plain.signals()[static_cast<std::size_t>(i) % 4];
        ASSERT_EQ(twins.plain.rowsIn(signal, range), twins.paged.rowsIn(signal, range));
        const auto count = static_cast<std::size_t>(1.0 + 2000.0 * random.uniform());
        twins.plain.columns(signal, range, count, plainColumns);
        twins.paged.columns(signal, range, count, pagedColumns);
        expectSame(plainColumns, pagedColumns);
        twins.plain.samples(signal, range, plainSamples);
        twins.paged.samples(signal, range, pagedSamples);
        expectSame(plainSamples, pagedSamples);
    }
    EXPECT_EQ(twins.paged.damagedParts(), 0U);
}

TEST(PagedHistory, answersTheSameToStatisticsAndCursors) {
    Twins twins;
    recordTrouble(twins);
    Random random(6);
    for (int i = 0; i < 300; ++i) {
        const TimeRange range = someRange(random, *twins.plain.range());
        const std::string signal = twins.plain.signals()[static_cast<std::size_t>(i) % 4];
        const SampleStatistics plain = twins.plain.statistics(signal, range);
        const SampleStatistics paged = twins.paged.statistics(signal, range);
        ASSERT_EQ(plain.extremes.min, paged.extremes.min);
        ASSERT_EQ(plain.extremes.max, paged.extremes.max);
        ASSERT_EQ(plain.moments.count(), paged.moments.count());
        ASSERT_EQ(plain.moments.missing(), paged.moments.missing());
        ASSERT_EQ(plain.moments.mean(), paged.moments.mean());
        ASSERT_EQ(plain.moments.deviation(), paged.moments.deviation());
        ASSERT_EQ(plain.gaps, paged.gaps);
        const auto one = twins.plain.valueAt(signal, range.begin_s);
        const auto other = twins.paged.valueAt(signal, range.begin_s);
        ASSERT_EQ(one.has_value(), other.has_value());
        ASSERT_TRUE(!one || (one->value == other->value && one->time_s == other->time_s));
    }
}

TEST(PagedHistory, looksAtAllOfItWithoutReadingAnythingButItsEnds) {
    Twins twins;
    const auto layout = layoutOf({"a", "b", "c"}, 0.001);
    for (std::size_t first = 0; first < 1'000'000; first += 10'000) {
        twins.append(blockOf(layout, first, 10'000, [](std::size_t row, std::size_t) {
            return std::sin(1e-4 * static_cast<double>(row));
        }));
    }
    twins.pages->reads = 0;
    std::vector<HistoryColumn> columns;
    for (const char* signal : {"a", "b", "c"}) {
        twins.paged.columns(signal, {0.0, 1000.0}, 300, columns);
        twins.paged.statistics(signal, {0.0, 1000.0});
    }
    EXPECT_LE(twins.pages->reads, 1U); // 244 chunks; 300 columns of 3333 rows are made of groups of 256
}

TEST(PagedHistory, memoryStaysWithinTheBudget) {
    Twins twins;
    const auto layout = layoutOf({"a", "b", "c"}, 0.001);
    std::vector<HistoryColumn> columns;
    for (std::size_t first = 0; first < 600'000; first += 1000) {
        twins.append(blockOf(layout, first, 1000,
                             [](std::size_t row, std::size_t) { return 1.0 * static_cast<double>(row); }));
        twins.paged.columns(
            "b", {0.001 * static_cast<double>(first / 2), 0.001 * static_cast<double>(first / 2) + 9.0}, 500,
            columns);
        ASSERT_LE(twins.paged.bytes(), Tiny);
    }
    // Nothing was dropped: 1.5 KB of each chunk of 170 KB stay in memory.
    EXPECT_EQ(twins.paged.range(), twins.plain.range());
}

TEST(PagedHistory, whatStaysInMemoryOfPagesIsBoundedToo) {
    SampleHistory history(Tiny);
    auto pages = std::make_shared<MemoryPages>();
    history.setStore(pages);
    const auto layout = layoutOf({"a", "b", "c"}, 0.001);
    for (std::size_t first = 0; first < 2'500'000; first += 4096) {
        history.append(blockOf(layout, first, 4096, [](std::size_t, std::size_t) { return 2.0; }));
        ASSERT_LE(history.bytes(), Tiny);
    }
    EXPECT_GT(history.range()->begin_s, 1.0); // the oldest are dropped
    EXPECT_LT(history.range()->begin_s, 2000.0);
    EXPECT_EQ(pages->pages() * SampleChunk::Rows * 8 * 4, history.pagedBytes());
}

TEST(PagedHistory, aFullStoreLosesTheOldestPagesFirst) {
    SampleHistory history(Tiny);
    auto pages = std::make_shared<MemoryPages>();
    pages->capacity_bytes = 10 * SampleChunk::detailBytesFor(3);
    history.setStore(pages);
    const auto layout = layoutOf({"a", "b", "c"}, 0.001);
    for (std::size_t first = 0; first < 200'000; first += 1000) {
        history.append(blockOf(layout, first, 1000,
                               [](std::size_t row, std::size_t) { return 1.0 * static_cast<double>(row); }));
    }
    EXPECT_EQ(pages->pages(), 10U);
    EXPECT_NEAR(history.range()->begin_s, 200.0 - 12.5 * 4.096, 4.1);
    EXPECT_EQ(history.valueAt("a", 170.0)->value, 170'000.0); // out of the store
}

TEST(PagedHistory, aStoreThatFailedIsAsGoodAsNone) {
    SampleHistory history(Tiny);
    auto pages = std::make_shared<MemoryPages>();
    history.setStore(pages);
    const auto layout = layoutOf({"a", "b", "c"}, 0.001);
    for (std::size_t first = 0; first < 200'000; first += 1000) {
        pages->hasFailed = first >= 100'000;
        history.append(blockOf(layout, first, 1000,
                               [](std::size_t row, std::size_t) { return 1.0 * static_cast<double>(row); }));
        ASSERT_LE(history.bytes(), Tiny);
    }
    EXPECT_EQ(pages->pages(), 0U); // the oldest were there
    EXPECT_DOUBLE_EQ(history.range()->end_s, 199.999);
    EXPECT_LT(history.range()->length_s(), 4 * 4.096);
}

TEST(PagedHistory, whatCouldNotBeWrittenIsDroppedWhenItsTurnComes) {
    SampleHistory history(Tiny);
    auto pages = std::make_shared<MemoryPages>();
    pages->lost = {3};
    history.setStore(pages);
    const auto layout = layoutOf({"a", "b", "c"}, 0.001);
    for (std::size_t first = 0; first < 200'000; first += 1000) {
        history.append(blockOf(layout, first, 1000,
                               [](std::size_t row, std::size_t) { return 1.0 * static_cast<double>(row); }));
        ASSERT_LE(history.bytes(), Tiny);
    }
    EXPECT_GT(history.range()->begin_s, 4 * 4.096 - 0.001);
    EXPECT_EQ(history.valueAt("a", 100.0)->value, 100'000.0);
}

TEST(PagedHistory, aSlowStoreKeepsRowsInMemoryUntilItHasThem) {
    Twins twins;
    twins.pages->keepsAtOnce = false;
    const auto layout = layoutOf({"a", "b", "c"}, 0.001);
    const auto value = [](std::size_t row, std::size_t) { return 1.0 * static_cast<double>(row); };
    twins.append(blockOf(layout, 0, 4 * 4096 - 1, value)); // the fourth chunk is not full
    EXPECT_EQ(twins.paged.pagedBytes(), 0U);
    EXPECT_TRUE(twins.paged.isBusy());
    EXPECT_EQ(twins.paged.valueAt("a", 1.0)->value, 1000.0);
    twins.pages->keepAll();
    twins.append(blockOf(layout, 4 * 4096 - 1, 100, value));
    EXPECT_GT(twins.paged.pagedBytes(), 0U);
    EXPECT_FALSE(twins.paged.isBusy());
    EXPECT_EQ(twins.paged.valueAt("a", 1.0)->value, 1000.0);
    EXPECT_EQ(twins.paged.range(), twins.plain.range());
}

TEST(PagedHistory, aDamagedPageIsAGapAndTimeKeepsItsOrder) {
    Twins twins;
    const auto layout = layoutOf({"a", "b", "c"}, 0.001);
    twins.append(blockOf(layout, 0, 100'000,
                         [](std::size_t row, std::size_t) { return 1.0 * static_cast<double>(row); }));
    twins.pages->damaged = {5}; // rows 20480 ... 24575
    EXPECT_FALSE(twins.paged.valueAt("a", 22.0));
    EXPECT_EQ(twins.paged.valueAt("a", 20.4)->value, 20'400.0);
    std::vector<TimedValue> samples;
    twins.paged.samples("a", {20.0, 25.0}, samples);
    ASSERT_EQ(samples.size(), 5003U); // rows 19999 ... 25001
    for (std::size_t i = 1; i < samples.size(); ++i) {
        ASSERT_GT(samples[i].time_s, samples[i - 1].time_s);
        const std::size_t row = i + 19'999;
        // Between the times that stayed in memory, 64 rows apart, the rows of an even clock are found again.
        ASSERT_NEAR(samples[i].time_s, 0.001 * static_cast<double>(row), 1e-9);
        ASSERT_EQ(std::isnan(samples[i].value), row >= 20'480 && row < 24'576) << row;
    }
    std::vector<HistoryColumn> columns;
    twins.paged.columns("a", {20.0, 25.0}, 50, columns);
    EXPECT_TRUE(columns[20].extremes.isEmpty());
    EXPECT_TRUE(columns[45].isAfterGap); // row 24576 is in it
    EXPECT_EQ(twins.paged.statistics("a", {21.0, 22.0}).moments.missing(), 1001U);
    EXPECT_GT(twins.paged.damagedParts(), 0U);
}

TEST(PagedHistory, clearGivesEverythingBackToTheStore) {
    Twins twins;
    recordTrouble(twins);
    twins.paged.clear();
    EXPECT_EQ(twins.pages->pages(), 0U);
    EXPECT_FALSE(twins.paged.range());
    recordTrouble(twins); // and it begins again
    EXPECT_GT(twins.pages->pages(), 40U);
    twins.paged.setStore(nullptr);
    EXPECT_EQ(twins.pages->pages(), 0U);
}

} // namespace
} // namespace halbench::control
