#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace halbench::widgets {

using Polyline = std::vector<std::pair<double, double>>;

/// The curve's finite stretches, each thinned to the smallest and largest value of every one of `columns`
/// equal parts of [low, high] once it has more than two points a column. Extremes are never lost. Curves
/// whose x is not increasing are passed unthinned.
std::vector<Polyline> decimated(const std::vector<double>& x, const std::vector<double>& y, double low,
                                double high, std::size_t columns);

} // namespace halbench::widgets
