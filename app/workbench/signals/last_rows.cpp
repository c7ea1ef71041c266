#include "app/workbench/signals/last_rows.h"

#include "app/workbench/signals/signal_stretch.h"

#include <cmath>
#include <memory>

namespace halbench::app {
namespace {

/// A stretch and how far it was looked through.
struct Column {
    SignalStretch stretch;
    std::size_t next = 0;

    /// NaN where there is no value at this time. Times rise from call to call.
    double valueAt(double time_s) {
        while (next < stretch.time_s.size() && stretch.time_s[next] < time_s) {
            ++next;
        }
        const bool isSameRow = next < stretch.time_s.size() && stretch.time_s[next] == time_s;
        return isSameRow ? stretch.values[next] : std::nan("");
    }
};

} // namespace

Recording lastRows(const control::SampleHistory& history, const std::vector<std::string>& signals,
                   double length_s, std::size_t mostRows) {
    Recording rows;
    auto layout = std::make_shared<StreamLayout>();
    std::vector<Column> columns;
    for (const std::string& signal : signals) {
        columns.push_back({lastStretch(history, signal, length_s, mostRows)});
        layout->columns.push_back({signal, columns.back().stretch.unit});
    }
    rows.layout = layout;
    if (columns.empty()) {
        return rows;
    }
    const std::vector<double> time_s = columns.front().stretch.time_s;
    std::vector<double> row(columns.size());
    for (const double at_s : time_s) {
        bool isWhole = true;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            row[i] = columns[i].valueAt(at_s);
            isWhole = isWhole && std::isfinite(row[i]);
        }
        if (isWhole) {
            rows.time_s.push_back(at_s);
            rows.values.insert(rows.values.end(), row.begin(), row.end());
        }
    }
    return rows;
}

} // namespace halbench::app
