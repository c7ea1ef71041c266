#include "widgets/raster/decimation.h"

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

std::vector<Polyline> finiteStretches(const std::vector<double>& x, const std::vector<double>& y) {
    std::vector<Polyline> stretches(1);
    const std::size_t count = std::min(x.size(), y.size());
    for (std::size_t i = 0; i < count; ++i) {
        if (std::isfinite(x[i]) && std::isfinite(y[i])) {
            if (stretches.back().empty()) {
                stretches.back().reserve(count - i);
            }
            stretches.back().emplace_back(x[i], y[i]);
        } else if (!stretches.back().empty()) {
            stretches.emplace_back();
        }
    }
    if (stretches.back().empty()) {
        stretches.pop_back();
    }
    return stretches;
}

/// Lower and upper extreme of one column, in their order along the curve.
void appendColumn(Polyline& thinned, const Polyline& line, std::size_t begin, std::size_t end) {
    std::size_t lowest = begin;
    std::size_t highest = begin;
    for (std::size_t i = begin; i < end; ++i) {
        lowest = line[i].second < line[lowest].second ? i : lowest;
        highest = line[i].second > line[highest].second ? i : highest;
    }
    thinned.push_back(line[std::min(lowest, highest)]);
    if (lowest != highest) {
        thinned.push_back(line[std::max(lowest, highest)]);
    }
}

Polyline thinned(const Polyline& line, double low, double high, std::size_t columns) {
    const auto columnOf = [&](double x) {
        return std::floor((x - low) / (high - low) * static_cast<double>(columns));
    };
    Polyline result;
    std::size_t begin = 0;
    while (begin < line.size()) {
        const double column = columnOf(line[begin].first);
        std::size_t end = begin + 1;
        while (end < line.size() && columnOf(line[end].first) == column) {
            ++end;
        }
        appendColumn(result, line, begin, end);
        begin = end;
    }
    return result;
}

} // namespace

std::vector<Polyline> decimated(const std::vector<double>& x, const std::vector<double>& y, double low,
                                double high, std::size_t columns) {
    std::vector<Polyline> stretches = finiteStretches(x, y);
    for (Polyline& line : stretches) {
        const auto isIncreasing = [&line] {
            return std::is_sorted(line.begin(), line.end(), [](const auto& left, const auto& right) {
                return left.first < right.first;
            });
        };
        if (line.size() > 2 * columns && high > low && isIncreasing()) {
            line = thinned(line, low, high, columns);
        }
    }
    return stretches;
}

} // namespace halbench::widgets
