#include "app/procedures/move/row_figures.h"

#include "app/procedures/excite/table_reference.h"

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

/// The first sample at or behind a time.
std::size_t sampleAt(const MoveResponse& response, double time_s) {
    const auto found = std::lower_bound(response.time_s.begin(), response.time_s.end(), time_s - 1e-9);
    return static_cast<std::size_t>(found - response.time_s.begin());
}

/// A rest in a row: where, from when to when, and how near counts as settled.
struct RowRest {
    double value;
    double from_s, to_s;
    double window;
};

std::optional<double> settlingTimeOf(const MoveResponse& response, const RowRest& rest) {
    const std::size_t first = sampleAt(response, rest.from_s);
    const std::size_t last = std::min(sampleAt(response, rest.to_s), response.time_s.size() - 1);
    if (!(rest.window > 0.0) || rest.to_s <= rest.from_s || first >= last) {
        return std::nullopt;
    }
    std::size_t settled = last + 1;
    while (settled > first && std::fabs(rest.value - response.position[settled - 1]) <= rest.window) {
        --settled;
    }
    return settled <= last ? std::optional(std::max(0.0, response.time_s[settled] - rest.from_s))
                           : std::nullopt;
}

} // namespace

std::vector<RowFigures> measureRows(const MoveResponse& response, const MoveConfig& config,
                                    const std::string& axis) {
    constexpr double Settled_ratio = 0.02;
    std::vector<RowFigures> figures;
    const TabledMotion* tabled = config.reference.table.get();
    const auto column = tabled != nullptr ? tabled->table.columnOf(axis) : std::nullopt;
    if (!column) {
        return figures;
    }
    double previous = 0.0;
    for (std::size_t row = 0; row < tabled->table.rows.size(); ++row) {
        const double arrival_s = tabled->motion.arrivals_s()[row];
        const std::size_t sample = sampleAt(response, arrival_s);
        if (sample >= response.time_s.size()) {
            break;
        }
        const bool isLast = row + 1 == tabled->table.rows.size();
        const double value = tabled->table.rows[row][*column];
        const double window = config.settlingWindow.value_or(Settled_ratio * std::fabs(value - previous));
        const RowRest rest{value, arrival_s,
                           isLast ? response.time_s.back() : tabled->motion.departures_s()[row], window};
        figures.push_back({tabled->table.lines[row], arrival_s,
                           response.reference[sample] - response.position[sample],
                           settlingTimeOf(response, rest)});
        previous = value;
    }
    return figures;
}

} // namespace halbench::app
