#include "app/workbench/signals/signal_stretch.h"

#include <algorithm>
#include <cmath>

namespace halbench::app {

SignalStretch lastStretch(const control::SampleHistory& history, const std::string& signal, double length_s,
                          std::size_t mostRows) {
    SignalStretch stretch;
    stretch.unit = history.unit(signal);
    const auto held = history.range(signal);
    if (!held) {
        return stretch;
    }
    control::TimeRange range{std::max(held->begin_s, held->end_s - length_s), held->end_s};
    const std::size_t rows = history.rowsIn(signal, range);
    if (rows > mostRows) { // before anything is copied
        range.begin_s =
            range.end_s - range.length_s() * static_cast<double>(mostRows) / static_cast<double>(rows);
    }
    std::vector<control::TimedValue> samples;
    history.samples(signal, range, samples);
    stretch.time_s.reserve(samples.size());
    stretch.values.reserve(samples.size());
    for (const control::TimedValue& sample : samples) {
        if (sample.time_s >= range.begin_s) {
            if (sample.isAfterGap && !stretch.time_s.empty()) {
                stretch.gaps.push_back(stretch.time_s.size());
            }
            stretch.time_s.push_back(sample.time_s);
            stretch.values.push_back(sample.value);
        }
    }
    return stretch;
}

SignalStretch withOpenGaps(SignalStretch stretch) {
    if (stretch.gaps.empty()) {
        return stretch;
    }
    std::vector<double> steps_s;
    for (std::size_t i = 1; i < stretch.time_s.size(); ++i) {
        steps_s.push_back(stretch.time_s[i] - stretch.time_s[i - 1]);
    }
    const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2);
    std::nth_element(steps_s.begin(), middle, steps_s.end());
    const double least_s = 2.0 * *middle;
    double by_s = 0.0;
    double before_s = stretch.time_s.front();
    auto gap = stretch.gaps.begin();
    for (std::size_t i = 1; i < stretch.time_s.size(); ++i) {
        const double step_s = stretch.time_s[i] - before_s;
        before_s = stretch.time_s[i];
        if (gap != stretch.gaps.end() && *gap == i) {
            by_s += std::max(0.0, least_s - step_s);
            ++gap;
        }
        stretch.time_s[i] += by_s;
    }
    return stretch;
}

SignalPair pairUp(const SignalStretch& x, const SignalStretch& y) {
    SignalPair pair;
    std::size_t k = 0;
    for (std::size_t i = 0; i < x.time_s.size(); ++i) {
        while (k < y.time_s.size() && y.time_s[k] < x.time_s[i]) {
            ++k;
        }
        const bool isSameRow = k < y.time_s.size() && y.time_s[k] == x.time_s[i];
        if (isSameRow && std::isfinite(x.values[i]) && std::isfinite(y.values[k])) {
            pair.x.push_back(x.values[i]);
            pair.y.push_back(y.values[k]);
        }
    }
    return pair;
}

} // namespace halbench::app
