#include "control/identify/thermal_bins.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {

namespace {

constexpr std::size_t Group = 5; // bins: longer than a turn or a period of what moves the motor
constexpr double LoadChange_ratio = 0.05;
constexpr double LeastLoadChange_A2 = 0.01; // 15 mW in 1.5 ohm

} // namespace

void ThermalBins::clear() {
    *this = {};
}

void ThermalBins::close() {
    if (m_open.samples > 0) {
        const auto count = static_cast<double>(m_open.samples);
        m_open.time_s /= count;
        m_open.mean_degC /= count;
        if (m_currents > 0) {
            m_open.square_A2 = m_squares_A2 / static_cast<double>(m_currents);
        }
        m_bins.push_back(m_open);
    }
    if (m_bins.size() > Most) {
        m_bins.pop_front();
    }
    m_open = {};
    m_squares_A2 = 0.0;
    m_currents = 0;
}

void ThermalBins::add(double time_s, double temperature_degC, double current_A) {
    if (!std::isfinite(time_s) || !std::isfinite(temperature_degC)) {
        return;
    }
    if (m_newest_degC && (time_s < m_last_s || time_s - m_last_s > LongestGap_s)) {
        clear();
    }
    if (!m_newest_degC) {
        m_begin_s = time_s;
    }
    if (time_s >= m_begin_s + Width_s) {
        close();
        m_begin_s += Width_s * std::floor((time_s - m_begin_s) / Width_s);
    }
    if (m_newest_degC) {
        const double step_K = std::abs(temperature_degC - *m_newest_degC);
        m_open.stepSquares_K2 += step_K * step_K;
        m_open.leastStep_K = step_K > 0.0 ? std::min(m_open.leastStep_K, step_K) : m_open.leastStep_K;
    }
    m_open.time_s += time_s;
    m_open.mean_degC += temperature_degC;
    ++m_open.samples;
    if (std::isfinite(current_A)) {
        m_squares_A2 += current_A * current_A;
        ++m_currents;
    }
    m_last_s = time_s;
    m_newest_degC = temperature_degC;
}

std::vector<ThermalBin> atSteadyLoad(const std::deque<ThermalBin>& bins) {
    std::size_t begin = bins.size();
    double sum_A2 = 0.0;
    double groups = 0.0;
    while (begin > 0) {
        const std::size_t from = begin > Group ? begin - Group : 0;
        double square_A2 = 0.0;
        for (std::size_t i = from; i < begin; ++i) {
            square_A2 += bins[i].square_A2 / static_cast<double>(begin - from);
        }
        if (!std::isfinite(square_A2)) {
            break; // nobody knows the load
        }
        const double mean_A2 = groups > 0.0 ? sum_A2 / groups : square_A2;
        if (std::abs(square_A2 - mean_A2) > LoadChange_ratio * mean_A2 + LeastLoadChange_A2) {
            break;
        }
        sum_A2 += square_A2;
        groups += 1.0;
        begin = from;
    }
    return {bins.begin() + static_cast<std::ptrdiff_t>(begin), bins.end()};
}

} // namespace halbench::control
