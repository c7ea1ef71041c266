#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

namespace halbench::control {

/// Smallest and largest of some values; empty until one that is not NaN was added.
struct Extremes {
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();

    bool isEmpty() const { return min > max; }
    void add(double value) { // comparisons with NaN are false
        min = value < min ? value : min;
        max = value > max ? value : max;
    }
    void add(const Extremes& other) {
        min = std::min(min, other.min);
        max = std::max(max, other.max);
    }
};

} // namespace halbench::control
