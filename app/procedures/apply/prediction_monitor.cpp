#include "app/procedures/apply/prediction_monitor.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

void BandCheck::add(double time_s, double angle_rad) {
    constexpr double Glitch_s = 0.015; // longer than a period of the loop
    const auto after = std::lower_bound(m_band.time_s.begin(), m_band.time_s.end(), time_s - 1e-9);
    if (m_departure || after == m_band.time_s.end()) {
        return;
    }
    const auto i = static_cast<std::size_t>(after - m_band.time_s.begin());
    const std::size_t before = i == 0 ? 0 : i - 1;
    const double low_rad = std::min(m_band.angle_rad.p5[before], m_band.angle_rad.p5[i]);
    const double high_rad = std::max(m_band.angle_rad.p95[before], m_band.angle_rad.p95[i]);
    if (angle_rad >= low_rad && angle_rad <= high_rad) {
        m_outsideSince_s.reset();
        return;
    }
    m_outsideSince_s = m_outsideSince_s.value_or(time_s);
    if (time_s - *m_outsideSince_s >= Glitch_s) {
        m_departure = BandDeparture{*m_outsideSince_s, std::max(low_rad - angle_rad, angle_rad - high_rad)};
    }
}

Error departureError(const BandDeparture& departure) {
    return {ErrorCode::Refused,
            fmt::format("measured motion outside the predicted band at {:.3g} s, by {:.3g} degrees",
                        departure.at_s, radiansToDegrees(departure.beyond_rad)),
            "Old values restored. Identify the motor again, or use lower gains."};
}

Error departureError(const BandDeparture& departure, const devices::AxisSpec& axis) {
    return {ErrorCode::Refused,
            fmt::format("measured motion of axis {} outside the predicted band at {:.3g} s, by {:.3g} {}",
                        axis.id, departure.at_s, departure.beyond_rad, axis.positionUnit),
            "Old values restored. Identify the axes again, or use lower gains."};
}

PredictionMonitor::PredictionMonitor(const ProcedureObserver& observer, MotionEnvelope band)
    : m_observer(observer), m_check(std::move(band)) {}

ProcedureObserver PredictionMonitor::observer() {
    ProcedureObserver watching = listeningIn(m_observer, [this](const SampleBlock& block) { take(block); });
    watching.checkAbort = [this]() -> Result<void> {
        if (m_hasLeft) {
            return failure(departure());
        }
        return m_observer.checkAbort ? m_observer.checkAbort() : Result<void>();
    };
    return watching;
}

Error PredictionMonitor::departure() const {
    return departureError(*m_check.departure());
}

void PredictionMonitor::take(const SampleBlock& block) {
    if (m_layout != block.layout) {
        m_layout = block.layout;
        m_position = block.layout->indexOf("position");
        m_running = block.layout->indexOf("reference.running");
    }
    if (m_position < 0 || m_running < 0) {
        return; // the move itself cannot be judged either, and says so
    }
    for (std::size_t row = 0; row < block.rows() && !m_hasLeft; ++row) {
        const double angle_rad = block.value(row, static_cast<std::size_t>(m_position));
        const bool isRunning = block.value(row, static_cast<std::size_t>(m_running)) > 0.5;
        if (!isRunning && !m_start_s) {
            m_rest_rad = angle_rad;
        } else if (isRunning && m_rest_rad) {
            m_start_s = m_start_s.value_or(block.time_s[row]);
            m_check.add(block.time_s[row] - *m_start_s, angle_rad - *m_rest_rad);
            m_hasLeft = m_check.departure().has_value();
        }
    }
}

} // namespace halbench::app
