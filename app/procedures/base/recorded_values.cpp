#include "app/procedures/base/recorded_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {

Result<void> checkRecordedValues(const Recording& recording, const std::string& signal,
                                 const std::vector<double>& values, std::size_t first) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
    const auto missing =
        std::find_if(begin, values.end(), [](double value) { return !std::isfinite(value); });
    if (missing == values.end()) {
        return {};
    }
    const auto row = static_cast<std::size_t>(missing - values.begin());
    const auto all = std::count_if(missing, values.end(), [](double value) { return !std::isfinite(value); });
    constexpr std::size_t HeaderLines = 1; // of our CSV files
    return failure(ErrorCode::NotFinite,
                   fmt::format("{} has no value at {:.6g} s (row {}, {} such rows)", signal,
                               recording.time_s[row], row + 1, all),
                   fmt::format("remove these rows (the first is line {} of a CSV file) or enter their values",
                               row + 1 + HeaderLines));
}

} // namespace halbench::app
