#include "devices/acquisition/time_axis.h"

#include <algorithm>
#include <cmath>

namespace halbench::devices {

namespace {

constexpr std::size_t PeriodRows = 1000; // rows whose spacing decides what the nominal period is
constexpr double GapFactor = 1.5;        // a step longer than this many periods has lost rows

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
    double lost = 0.0;
    for (std::size_t i = 1; i < time_s.size(); ++i) {
        const double step_s = time_s[i] - time_s[i - 1];
        if (period_s > 0.0 && step_s > GapFactor * period_s) {
            lost += std::min(std::round(step_s / period_s) - 1.0, 1e15);
        }
    }
    return static_cast<std::uint64_t>(std::min(lost, 1e18));
}

std::uint64_t lostRowsBefore(const Recording& recording, std::size_t row) {
    const double period_s = recording.layout->period_s;
    if (row == 0 || period_s <= 0.0) {
        return 0;
    }
    const double steps = (recording.time_s[row] - recording.time_s[row - 1]) / period_s;
    return steps > GapFactor ? static_cast<std::uint64_t>(std::min(std::round(steps) - 1.0, 1e15)) : 0;
}

} // namespace halbench::devices
