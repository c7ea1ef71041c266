#include "app/session/recorder.h"
#include "tests/memory_in_use.h"

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

#include <charconv>
#include <fstream>
#include <thread>

namespace halbench::app {
namespace {

constexpr double Rate_Hz = 1000.0;
constexpr std::uint64_t Day_rows = 86'400'000;
constexpr std::size_t BlockRows = 5000;
constexpr std::size_t Columns = 3;

double valueAt(std::uint64_t row, std::size_t column) {
    return static_cast<double>((row * 7 + column * 131) % 9973);
}

SampleBlockPtr blockAt(const std::shared_ptr<const StreamLayout>& layout, std::uint64_t first) {
    auto block = std::make_shared<SampleBlock>();
    block->layout = layout;
    for (std::uint64_t row = first; row < first + BlockRows; ++row) {
        block->time_s.push_back(static_cast<double>(row) / Rate_Hz);
        for (std::size_t column = 0; column < Columns; ++column) {
            block->values.push_back(valueAt(row, column));
        }
    }
    return block;
}

/// Reads the file as another program would: a line a row, its numbers by the standard library.
std::uint64_t exactRows(const std::string& path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line); // the names
    std::uint64_t row = 0;
    for (; std::getline(file, line); ++row) {
        const char* at = line.data();
        const char* const end = at + line.size();
        for (std::size_t field = 0; field <= Columns; ++field) {
            double value = -1.0;
            at = std::from_chars(at, end, value).ptr + 1; // past the comma
            const double expected = field == 0 ? static_cast<double>(row) / Rate_Hz : valueAt(row, field - 1);
            if (value != expected) {
                ADD_FAILURE() << "row " << row << ": " << line;
                return row;
            }
        }
    }
    return row;
}

TEST(RecorderDay, memoryStaysFlatAndEveryRowIsExactThroughADayAtOneKilohertz) {
    QTemporaryDir folder; // 2 GB at the end
    RecorderConfig config;
    config.path = folder.filePath("day.csv").toStdString();
    config.layout.period_s = 1.0 / Rate_Hz;
    config.layout.columns = {{"a", "T"}, {"b", "T"}, {"c", "A"}};
    const std::string path = config.path;
    const std::size_t waiting_rows = config.queue_rows / 2;
    const auto layout = std::make_shared<const StreamLayout>(config.layout);
    Recorder recorder(std::move(config));
    double early_MB = 0.0;
    for (std::uint64_t first = 0; first < Day_rows; first += BlockRows) {
        recorder.push(blockAt(layout, first));
        while (first > recorder.status().rows + waiting_rows &&
               recorder.status().state == RecorderStatus::State::Recording) {
            std::this_thread::yield(); // faster than any device
        }
        if (first == Day_rows / 24) { // after an hour everything has its final size
            early_MB = memoryInUse_MB();
        }
    }
    const double late_MB = memoryInUse_MB();
    recorder.finish();
    while (recorder.status().state == RecorderStatus::State::Recording ||
           recorder.status().state == RecorderStatus::State::Finishing) {
        std::this_thread::yield();
    }
    const RecorderStatus status = recorder.status();
    ASSERT_EQ(status.state, RecorderStatus::State::Done) << (status.error ? status.error->message : "");
    EXPECT_LT(late_MB - early_MB, 8.0); // the allocator's unevenness; 3 GB went by
    EXPECT_EQ(status.rows, Day_rows);
    EXPECT_EQ(status.droppedRows + status.missingRows + status.gaps, 0U);
    EXPECT_EQ(exactRows(path), Day_rows);
}

} // namespace
} // namespace halbench::app
