#include "devices/recording/time_axis.h"

#include "control/base/row_grid.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

namespace halbench::devices {

namespace {

constexpr std::size_t PeriodRows = 1000; // rows whose spacing decides what the nominal period is
constexpr std::uint64_t MostLost = 1'000'000'000'000'000'000; // of a broken axis
// Rows before one that tell on which grid it stands.
constexpr std::size_t RowsBefore = 32;

/// Rows of one rate.
struct Stretch {
    std::size_t begin = 0;
    std::size_t end = 0;
    double period_s = 0.0;
};

/// The rows missing before `row`, which the grid takes; those behind it up to `end` are known.
std::uint64_t takeRow(RowGrid& grid, std::span<const double> time_s, std::size_t row) {
    const std::uint64_t missing = grid.missingBefore(time_s.subspan(row));
    grid.take(time_s[row], missing);
    return missing;
}

std::size_t firstRowFrom(const Recording& recording, double time_s) {
    const auto row = std::ranges::lower_bound(recording.time_s, time_s);
    return static_cast<std::size_t>(row - recording.time_s.begin());
}

/// The stretch in which a time lies.
Stretch stretchAt(const Recording& recording, double time_s) {
    const std::vector<RateChange>& rates = recording.rates;
    const auto next = std::ranges::upper_bound(rates, time_s, {}, &RateChange::time_s);
    const bool isFirst = next == rates.begin();
    return {isFirst ? 0 : firstRowFrom(recording, std::prev(next)->time_s),
            next == rates.end() ? recording.rows() : firstRowFrom(recording, next->time_s),
            isFirst ? recording.layout->period_s : std::prev(next)->period_s};
}

/// Before the first row of a stretch that follows another.
std::uint64_t lostBetween(const Recording& recording, const Stretch& stretch) {
    const double before_s = recording.time_s[stretch.begin - 1];
    const double period_s = std::max(stretchAt(recording, before_s).period_s, stretch.period_s);
    return rowsMissingAtChange(recording.time_s[stretch.begin] - before_s, period_s);
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

void setRates(Recording& recording, const std::vector<RateChange>& rates) {
    if (rates.empty() || recording.rows() == 0) {
        return;
    }
    recording.rates.clear();
    for (const RateChange& rate : rates) {
        const bool isLater = recording.rates.empty() || rate.time_s > recording.rates.back().time_s;
        if (rate.period_s > 0.0 && std::isfinite(rate.period_s) && std::isfinite(rate.time_s) && isLater) {
            recording.rates.push_back(rate);
        }
    }
    recording.lostRows = 0;
    for (std::size_t row = 0; row < recording.rows();) {
        const Stretch stretch = stretchAt(recording, recording.time_s[row]);
        const auto begin = recording.time_s.begin();
        const std::vector<double> time_s(begin + static_cast<std::ptrdiff_t>(row),
                                         begin + static_cast<std::ptrdiff_t>(stretch.end));
        const std::uint64_t between = row > 0 ? lostBetween(recording, stretch) : 0;
        recording.lostRows =
            std::min(recording.lostRows + between + countLostRows(time_s, stretch.period_s), MostLost);
        row = stretch.end;
    }
}

std::uint64_t lostRowsBefore(const Recording& recording, std::size_t row) {
    const std::vector<double>& time_s = recording.time_s;
    const double shortest_s = recording.rates.empty() ? recording.layout->period_s : 0.0;
    if (row == 0 || !(time_s[row] - time_s[row - 1] > shortest_s)) {
        return 0;
    }
    const Stretch stretch = stretchAt(recording, time_s[row]);
    if (row == stretch.begin) {
        return lostBetween(recording, stretch);
    }
    RowGrid grid(stretch.period_s);
    std::uint64_t missing = 0;
    for (std::size_t i = row - std::min(row - stretch.begin, RowsBefore); i <= row; ++i) {
        missing = takeRow(grid, std::span(time_s).first(stretch.end), i);
    }
    return missing;
}

} // namespace halbench::devices
