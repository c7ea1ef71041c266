#include "devices/xcp/clock_fit.h"

#include <algorithm>
#include <cmath>

namespace halbench::devices::xcp {

namespace {

/// Ten minutes at one a second: a crystal's drift follows its temperature within minutes.
constexpr std::size_t MaxReadings = 600;
constexpr std::size_t MinReadings = 6;
constexpr double FastestRatio = 2.0;

/// Student's 97.5 % quantile to 2 % from 4 degrees of freedom on (2.78 at 4, 2.23 at 10, 1.96 for many).
double studentFactor(double freedom) {
    return 1.96 + 2.37 / freedom + 3.6 / (freedom * freedom);
}

/// Sums about the means, so that nothing is lost in large times.
struct Sums {
    double count = 0.0;
    double meanX = 0.0, meanY = 0.0;
    double xx = 0.0, xy = 0.0, yy = 0.0;

    void add(double x, double y) {
        count += 1.0;
        const double dx = x - meanX;
        const double dy = y - meanY;
        meanX += dx / count;
        meanY += dy / count;
        xx += dx * (x - meanX);
        xy += dx * (y - meanY);
        yy += dy * (y - meanY);
    }
};

} // namespace

void ClockFit::add(double sent_s, double answered_s, double board_s) {
    const double host_s = sent_s + (answered_s - sent_s) / 2.0;
    m_readings.push_back({host_s, board_s - host_s, answered_s - sent_s});
    if (m_readings.size() > MaxReadings) {
        m_readings.pop_front();
    }
}

std::optional<ClockDrift> ClockFit::drift() const {
    if (m_readings.size() < MinReadings) {
        return std::nullopt;
    }
    const auto fastest =
        std::min_element(m_readings.begin(), m_readings.end(),
                         [](const Reading& a, const Reading& b) { return a.roundTrip_s < b.roundTrip_s; });
    Sums sums;
    for (const Reading& reading : m_readings) {
        if (reading.roundTrip_s <= FastestRatio * fastest->roundTrip_s) {
            sums.add(reading.host_s, reading.difference_s);
        }
    }
    if (sums.count < static_cast<double>(MinReadings) || !(sums.xx > 0.0)) {
        return std::nullopt;
    }
    const double freedom = sums.count - 2.0;
    const double slope = sums.xy / sums.xx;
    const double residual = std::max(sums.yy - slope * sums.xy, 0.0) / freedom;
    return ClockDrift{1e6 * slope, 1e6 * studentFactor(freedom) * std::sqrt(residual / sums.xx)};
}

} // namespace halbench::devices::xcp
