#include "widgets/live_plot/axes/sensor_step.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace halbench::widgets {
namespace {

constexpr std::size_t MostValues = 20;
constexpr double Same_ratio = 1e-3;
constexpr double Slack_ratio = 0.02; ///< of a step: single precision and corrections of a sensor

/// In rising order. A history keeps values in single precision of a block's
/// range: what lies closer together than a thousandth of all is one value.
std::vector<double> differentValues(std::span<const control::TimedValue> samples) {
    std::vector<double> values;
    for (const control::TimedValue& sample : samples) {
        if (std::isfinite(sample.value)) {
            values.push_back(sample.value);
        }
    }
    std::sort(values.begin(), values.end());
    if (values.empty()) {
        return {};
    }
    const double same = Same_ratio * (values.back() - values.front());
    const auto end = std::unique(values.begin(), values.end(),
                                 [same](double kept, double next) { return next - kept <= same; });
    values.erase(end, values.end());
    return values;
}

/// The least difference of values in rising order, of which all differences are whole multiples.
std::optional<double> commonStep(const std::vector<double>& values) {
    double step = values[1] - values[0];
    for (std::size_t i = 2; i < values.size(); ++i) {
        step = std::min(step, values[i] - values[i - 1]);
    }
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double steps = (values[i] - values[i - 1]) / step;
        if (std::abs(steps - std::round(steps)) > Slack_ratio * std::max(1.0, steps)) {
            return std::nullopt;
        }
    }
    return step;
}

/// Up to the next sample that comes after a gap.
std::size_t lengthWithoutGap(std::span<const control::TimedValue> samples) {
    const auto next = std::find_if(samples.begin() + 1, samples.end(),
                                   [](const control::TimedValue& sample) { return sample.isAfterGap; });
    return static_cast<std::size_t>(next - samples.begin());
}

} // namespace

std::optional<double> sensorStep(std::span<const control::TimedValue> samples) {
    if (differentValues(samples).size() > MostValues) {
        return std::nullopt;
    }
    std::optional<double> least;
    while (!samples.empty()) {
        const std::size_t length = lengthWithoutGap(samples);
        const std::vector<double> values = differentValues(samples.first(length));
        samples = samples.subspan(length);
        if (values.size() < 2) {
            continue;
        }
        const std::optional<double> step = values.size() > MostValues ? std::nullopt : commonStep(values);
        if (!step) {
            return std::nullopt;
        }
        least = std::min(least.value_or(*step), *step);
    }
    return least;
}

} // namespace halbench::widgets
