#include "devices/recording/time_axis.h"

#include "control/base/row_grid.h"

#include <algorithm>
#include <span>

namespace halbench::devices {

namespace {

constexpr std::size_t PeriodRows = 1000; // rows whose spacing decides what the nominal period is
constexpr std::uint64_t MostLost = 1'000'000'000'000'000'000; // of a broken axis
// Rows before one that tell on which grid it stands.
constexpr std::size_t RowsBefore = 32;

/// The rows missing before `row`, which the grid takes.
std::uint64_t takeRow(RowGrid& grid, const std::vector<double>& time_s, std::size_t row) {
    const std::uint64_t missing = grid.missingBefore(std::span(time_s).subspan(row));
    grid.take(time_s[row], missing);
    return missing;
}

} // namespace

double nominalPeriod(const std::vector<double>& time_s) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < std::min(time_s.size(), PeriodRows); ++i) {
        steps.push_back(time_s[i] - time_s[i - 1]);
    }
    if (steps.empty()) {
        return 0.0;
    }
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

std::uint64_t countLostRows(const std::vector<double>& time_s, double period_s) {
    RowGrid grid(period_s);
    std::uint64_t lost = 0;
    for (std::size_t row = 0; row < time_s.size(); ++row) {
        lost = std::min(lost + takeRow(grid, time_s, row), MostLost);
    }
    return lost;
}

std::uint64_t lostRowsBefore(const Recording& recording, std::size_t row) {
    const std::vector<double>& time_s = recording.time_s;
    const double period_s = recording.layout->period_s;
    if (row == 0 || !(time_s[row] - time_s[row - 1] > period_s)) {
        return 0;
    }
    RowGrid grid(period_s);
    std::uint64_t missing = 0;
    for (std::size_t i = row - std::min(row, RowsBefore); i <= row; ++i) {
        missing = takeRow(grid, time_s, i);
    }
    return missing;
}

} // namespace halbench::devices
