#include "widgets/live_plot/axes/value_range.h"

#include "widgets/language/display_units.h"

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

/// Steps an automatic axis is rounded to: fine enough to use the height, coarse enough to change rarely.
constexpr int AutoSteps = 8;
/// Air between data and frame.
constexpr double Margin_ratio = 0.04;
/// Shrinks when the data need less than this part ...
constexpr double Calm_ratio = 0.6;
/// ... for so many frames: three seconds.
constexpr int CalmFrames = 90;

} // namespace

double niceStep(double length, int count) {
    const double least = length / std::max(count, 1);
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double multiple : {1.0, 2.0, 5.0}) {
        if (multiple * power >= least * (1.0 - 1e-9)) {
            return multiple * power;
        }
    }
    return 10.0 * power;
}

std::vector<double> ticksOf(const ValueRange& range, double step) {
    std::vector<double> ticks;
    const double slack = 1e-9 * step;
    const double first = std::ceil((range.low - slack) / step);
    const double last = std::floor((range.high + slack) / step);
    for (double i = first; i <= last && ticks.size() < 1000; i += 1.0) {
        ticks.push_back(i * step);
    }
    return ticks;
}

int decimalsOf(double step) {
    return std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
}

QString tickText(double value, int decimals) {
    const double smallest = std::pow(10.0, -decimals);
    const double shown = std::abs(value) < 0.5 * smallest ? 0.0 : value;
    if (decimals > 6 || std::abs(value) >= 1e7) {
        return shown == 0.0 ? QStringLiteral("0") : numberText(shown, 4);
    }
    return fixedText(shown, decimals);
}

ValueRange AutoRange::around(const ValueRange& data) const {
    const double middle = 0.5 * (data.low + data.high);
    // Doubles next to a large value lie apart; never magnify those.
    const double smallest = std::max({m_smallestLength, 1e-9 * std::abs(middle), 1e-300});
    const double half = std::max(0.5 * data.length() * (1.0 + 2.0 * Margin_ratio), 0.5 * smallest);
    const double step = niceStep(2.0 * half, AutoSteps);
    return {step * std::floor((middle - half) / step), step * std::ceil((middle + half) / step)};
}

void AutoRange::fit(const ValueRange& data) {
    m_range = around(data);
    m_calmFrames = 0;
    m_hasData = true;
}

void AutoRange::update(const ValueRange& data) {
    if (!m_hasData) {
        fit(data);
        return;
    }
    const bool isTooFine = m_range.length() < (1.0 - 1e-9) * m_smallestLength;
    if (isTooFine || !m_range.contains(data)) {
        m_range = around({std::min(m_range.low, data.low), std::max(m_range.high, data.high)});
        m_calmFrames = 0;
        return;
    }
    if (around(data).length() > Calm_ratio * m_range.length()) {
        m_calmFrames = 0;
        return;
    }
    m_recent = m_calmFrames == 0
                   ? data
                   : ValueRange{std::min(m_recent.low, data.low), std::max(m_recent.high, data.high)};
    if (++m_calmFrames >= CalmFrames) {
        fit(m_recent);
    }
}

} // namespace halbench::widgets
