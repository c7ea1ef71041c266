#include "control/signals/spectrum.h"

#include "control/base/distributions.h"
#include "control/signals/segment_plan.h"
#include "control/signals/segment_transform.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace halbench::control {
namespace {

constexpr std::size_t MostValues = 50'000'000;

/// From |X_k|^2 to the values of a scale.
class Scaling {
public:
    Scaling(const SegmentTransform& transform, double period_s, SpectrumScale scale) : m_scale(scale) {
        const std::vector<double>& weights = transform.weights();
        const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
        const double squares = std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
        const bool isDensity = scale == SpectrumScale::Density || scale == SpectrumScale::RootDensity;
        m_factor = isDensity ? period_s / squares : 1.0 / (sum * sum);
        m_lastEdge = transform.length() % 2 == 0 ? transform.lines() - 1 : 0;
    }

    /// Zero and half the rate stand for themselves, every other line for two.
    bool isEdge(std::size_t line) const { return line == 0 || line == m_lastEdge; }
    double value(std::size_t line, double power) const {
        const double scaled = m_factor * power *
                              (isEdge(line)                     ? 1.0
                               : m_scale == SpectrumScale::Peak ? 4.0
                                                                : 2.0);
        return m_scale == SpectrumScale::Density ? scaled : std::sqrt(scaled);
    }

private:
    SpectrumScale m_scale;
    double m_factor = 0.0;
    std::size_t m_lastEdge = 0;
};

std::vector<double> lineFrequencies(const SegmentTransform& transform, double period_s) {
    std::vector<double> frequency_Hz(transform.lines());
    for (std::size_t line = 0; line < frequency_Hz.size(); ++line) {
        frequency_Hz[line] = static_cast<double>(line) / (static_cast<double>(transform.length()) * period_s);
    }
    return frequency_Hz;
}

/// Calls take(segment, powers) for each segment.
template <typename Function>
Result<void> transformAll(const SignalView& signal, const SegmentPlan& plan, SegmentTransform& transform,
                          const AbortCheck& checkAbort, const Function& take) {
    for (std::size_t i = 0; i < plan.begins.size(); ++i) {
        if (checkAbort) {
            if (const Result<void> goOn = checkAbort(); !goOn) {
                return goOn;
            }
        }
        take(i, transform.powers(signal.values.subspan(plan.begins[i], plan.rows)));
    }
    return {};
}

double equivalentAverages(const SegmentPlan& plan, const std::vector<double>& weights) {
    const double squares = std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
    std::vector<double> correlations; // rho_1, rho_2 ...
    for (std::size_t lag = plan.shift; lag < plan.rows; lag += plan.shift) {
        const auto shifted = weights.begin() + static_cast<std::ptrdiff_t>(lag);
        const double rho = std::inner_product(shifted, weights.end(), weights.begin(), 0.0) / squares;
        correlations.push_back(rho * rho);
    }
    double count = 0.0;
    double variance = 0.0;
    for (const Stretch& stretch : plan.stretches.pieces) {
        const std::size_t segments = plan.segmentsIn(stretch);
        count += static_cast<double>(segments);
        variance += static_cast<double>(segments);
        for (std::size_t m = 1; m < segments && m <= correlations.size(); ++m) {
            variance += 2.0 * static_cast<double>(segments - m) * correlations[m - 1];
        }
    }
    return count * count / variance;
}

struct IntervalFactors {
    double low;
    double high;
};

/// nu / chi^2 of the two ends.
IntervalFactors intervalFactors(double freedom, double confidence_ratio) {
    const double tail = 0.5 * (1.0 - confidence_ratio);
    return {freedom / chiSquareQuantile(1.0 - tail, freedom), freedom / chiSquareQuantile(tail, freedom)};
}

void fillValues(Spectrum& result, const std::vector<double>& powers, const Scaling& scaling) {
    const IntervalFactors inner =
        intervalFactors(2.0 * result.equivalentAverages, result.config.confidence_ratio);
    const IntervalFactors edge = intervalFactors(result.equivalentAverages, result.config.confidence_ratio);
    for (std::size_t line = 0; line < powers.size(); ++line) {
        const IntervalFactors& factors = scaling.isEdge(line) ? edge : inner;
        result.values.push_back(scaling.value(line, powers[line]));
        result.low.push_back(scaling.value(line, factors.low * powers[line]));
        result.high.push_back(scaling.value(line, factors.high * powers[line]));
    }
}

double rmsOf(const std::vector<double>& powers, const SegmentTransform& transform, double period_s) {
    const Scaling density(transform, period_s, SpectrumScale::Density);
    double integral = 0.0;
    for (std::size_t line = 0; line < powers.size(); ++line) {
        integral += density.value(line, powers[line]);
    }
    return std::sqrt(integral / (static_cast<double>(transform.length()) * period_s));
}

bool isDensity(SpectrumScale scale) {
    return scale == SpectrumScale::Density || scale == SpectrumScale::RootDensity;
}

} // namespace

Result<Spectrum> spectrum(const SignalView& signal, const SpectrumConfig& config,
                          const AbortCheck& checkAbort) {
    const Result<SegmentPlan> plan = planSegments(signal, config, isDensity(config.scale));
    if (!plan) {
        return failure(plan.error());
    }
    SegmentTransform transform(config.window, plan->rows, config.removesMean);
    std::vector<double> mean(transform.lines(), 0.0);
    const double share = 1.0 / static_cast<double>(plan->begins.size());
    const auto add = [&](std::size_t, const std::vector<double>& powers) {
        for (std::size_t line = 0; line < powers.size(); ++line) {
            mean[line] += share * powers[line];
        }
    };
    if (const Result<void> done = transformAll(signal, *plan, transform, checkAbort, add); !done) {
        return failure(done.error());
    }
    Spectrum result;
    result.config = config;
    result.unit = spectrumUnit(signal.unit, config.scale);
    result.period_s = plan->stretches.period_s;
    result.frequency_Hz = lineFrequencies(transform, result.period_s);
    result.segmentRows = plan->rows;
    result.segments = plan->begins.size();
    result.equivalentAverages = equivalentAverages(*plan, transform.weights());
    result.gaps = plan->stretches.gaps;
    result.missingValues = plan->stretches.missingValues;
    result.usedRows = plan->usedRows();
    result.rms = rmsOf(mean, transform, result.period_s);
    fillValues(result, mean, Scaling(transform, result.period_s, config.scale));
    return result;
}

std::string spectrumUnit(const std::string& unit, SpectrumScale scale) {
    const std::string base = unit == "degC" ? "K" : unit;
    if (!isDensity(scale)) {
        return base;
    }
    const bool isSquared = scale == SpectrumScale::Density;
    if (base.empty()) {
        return isSquared ? "1/Hz" : "1/sqrt(Hz)";
    }
    const bool isCompound = base.find_first_of("*/^") != std::string::npos;
    const std::string factor = isCompound ? "(" + base + ")" : base;
    return isSquared ? factor + "^2/Hz" : factor + "/sqrt(Hz)";
}

std::vector<std::size_t> highestPeaks(const Spectrum& spectrum, std::size_t count) {
    const std::vector<double>& values = spectrum.values;
    const std::size_t reach = figuresOf(spectrum.config.window).halfLobe_lines;
    std::vector<std::size_t> peaks;
    for (std::size_t line = 1; line + 1 < values.size(); ++line) {
        const std::size_t begin = line < reach ? 0 : line - reach;
        const std::size_t end = std::min(line + reach + 1, values.size());
        bool isHighest = values[line] > 0.0;
        for (std::size_t other = begin; other < end && isHighest; ++other) {
            isHighest = other == line || values[other] < values[line] ||
                        (values[other] == values[line] && other > line);
        }
        if (isHighest) {
            peaks.push_back(line);
        }
    }
    std::stable_sort(peaks.begin(), peaks.end(),
                     [&values](std::size_t a, std::size_t b) { return values[a] > values[b]; });
    const double smallest = spectrum.config.scale == SpectrumScale::Density ? 1e-12 : 1e-6;
    const auto isLow = [&](std::size_t line) { return values[line] < smallest * values[peaks.front()]; };
    peaks.erase(std::find_if(peaks.begin(), peaks.end(), isLow), peaks.end());
    peaks.resize(std::min(peaks.size(), count));
    return peaks;
}

Result<Spectrogram> spectrogram(const SignalView& signal, const SpectrumConfig& config,
                                const AbortCheck& checkAbort) {
    const Result<SegmentPlan> plan = planSegments(signal, config, true);
    if (!plan) {
        return failure(plan.error());
    }
    SegmentTransform transform(config.window, plan->rows, config.removesMean);
    if (plan->begins.size() > MostValues / transform.lines()) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("{} segments of {} lines exceed the size of a spectrogram",
                                   plan->begins.size(), transform.lines()),
                       "reduce the overlap, or use a part of the recording");
    }
    Spectrogram result;
    result.unit = spectrumUnit(signal.unit, config.scale);
    result.frequency_Hz = lineFrequencies(transform, plan->stretches.period_s);
    result.values.reserve(plan->begins.size() * transform.lines());
    const Scaling scaling(transform, plan->stretches.period_s, config.scale);
    const auto add = [&](std::size_t segment, const std::vector<double>& powers) {
        const std::size_t begin = plan->begins[segment];
        result.time_s.push_back(0.5 * (signal.time_s[begin] + signal.time_s[begin + plan->rows - 1]));
        for (std::size_t line = 0; line < powers.size(); ++line) {
            result.values.push_back(scaling.value(line, powers[line]));
        }
    };
    if (const Result<void> done = transformAll(signal, *plan, transform, checkAbort, add); !done) {
        return failure(done.error());
    }
    return result;
}

} // namespace halbench::control
