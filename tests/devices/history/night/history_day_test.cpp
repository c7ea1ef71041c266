#include "control/history/sample_history.h"
#include "devices/history/page_file.h"
#include "tests/memory_in_use.h"

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::devices {
namespace {

constexpr double Rate_Hz = 10'000.0;
constexpr std::uint64_t Day_rows = 864'000'000;
constexpr std::size_t BlockRows = 5000;
constexpr std::size_t Budget_bytes = std::size_t{64} << 20;

double valueAt(std::uint64_t row, std::size_t column) {
    return static_cast<double>((row * 7 + column * 131) % 9973);
}

void fill(SampleBlock& block, std::uint64_t first) {
    for (std::size_t row = 0; row < BlockRows; ++row) {
        block.time_s[row] = static_cast<double>(first + row) / Rate_Hz;
        block.values[2 * row] = valueAt(first + row, 0);
        block.values[2 * row + 1] = valueAt(first + row, 1);
    }
}

TEST(HistoryDay, memoryStaysFlatAndTimesExactThroughADayAtTenKilohertz) {
    QTemporaryDir folder;
    PageFileConfig config;
    config.folder = folder.path().toStdString();
    config.limit_bytes = std::uint64_t{512} << 20;
    config.spare_bytes = 0;
    const auto file = std::make_shared<PageFile>(config);
    control::SampleHistory history(Budget_bytes);
    history.setStore(file);
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{"a", "T"}, {"b", "T"}};
    layout->period_s = 1.0 / Rate_Hz;
    SampleBlock block;
    block.layout = layout;
    block.time_s.resize(BlockRows);
    block.values.resize(2 * BlockRows);
    double early_MB = 0.0;
    for (std::uint64_t first = 0; first < Day_rows; first += BlockRows) {
        fill(block, first);
        history.append(block);
        while (history.isBusy()) { // faster than any device
            file->waitUntilIdle();
            history.settle();
        }
        ASSERT_LE(history.bytes(), Budget_bytes);
        if (first == Day_rows / 24) { // after an hour everything has its final size
            early_MB = memoryInUse_MB();
        }
    }
    EXPECT_LT(memoryInUse_MB() - early_MB, 8.0); // the allocator's unevenness; 26 GB went by
    EXPECT_FALSE(file->trouble());
    EXPECT_LE(file->bytes(), config.limit_bytes);
    const control::TimeRange held = *history.range();
    EXPECT_EQ(held.end_s, static_cast<double>(Day_rows - 1) / Rate_Hz);
    EXPECT_GT(held.length_s(), 1200.0); // 29 octets a row: half a gigabyte is half an hour
    std::vector<control::TimedValue> samples;
    history.samples("b", {held.begin_s + 1.0, held.begin_s + 2.0}, samples); // on the disk
    ASSERT_GE(samples.size(), 10'000U);
    for (const control::TimedValue& sample : samples) {
        const auto row = static_cast<std::uint64_t>(std::llround(sample.time_s * Rate_Hz));
        ASSERT_EQ(sample.time_s, static_cast<double>(row) / Rate_Hz);
        ASSERT_EQ(sample.value, valueAt(row, 1));
    }
    EXPECT_EQ(history.statistics("a", held).gaps, 0U);
}

} // namespace
} // namespace halbench::devices
