#include "app/procedures/base/coil_temperature_monitor.h"

#include <algorithm>
#include <limits>

namespace halbench::app {

namespace {

using Verdict = control::LimitForecast::Verdict;

constexpr double OldestCurrent_s = 0.1;  // a current of longer ago is not that of a temperature
constexpr double LeastHeating_A2 = 0.01; // 15 mW in 1.5 ohm, 0.2 K in the end

/// Smaller is more urgent; seconds where there are any.
double urgency(const control::LimitForecast& forecast) {
    switch (forecast.verdict) {
    case Verdict::AtLimit:
        return -1.0;
    case Verdict::Reached:
    case Verdict::NotBefore:
        return forecast.earliest_s.value_or(0.0);
    case Verdict::Withheld:
        return 2.0 * control::LimitForecast::Longest_s;
    case Verdict::NotReached:
        break;
    }
    return 3.0 * control::LimitForecast::Longest_s;
}

} // namespace

CoilTemperatureMonitor::CoilTemperatureMonitor(const devices::Catalogue& catalogue) {
    const char* const letters[] = {"a", "b"};
    for (std::size_t i = 0; i < m_coils.size(); ++i) {
        m_coils[i].temperature = catalogue.signalForRole(std::string("coil_temperature.") + letters[i]);
        m_coils[i].current = catalogue.signalForRole(std::string("current.") + letters[i]);
    }
}

void CoilTemperatureMonitor::add(std::size_t coil, double time_s, double temperature_degC, double current_A) {
    m_coils[coil].bins.add(time_s, temperature_degC, current_A);
}

void CoilTemperatureMonitor::add(std::size_t coil, std::span<const control::TimedValue> temperatures_degC,
                                 std::span<const control::TimedValue> currents_A) {
    std::size_t next = 0;
    for (const control::TimedValue& temperature : temperatures_degC) {
        while (next < currents_A.size() && currents_A[next].time_s <= temperature.time_s) {
            ++next;
        }
        const bool isKnown = next > 0 && temperature.time_s - currents_A[next - 1].time_s <= OldestCurrent_s;
        add(coil, temperature.time_s, temperature.value,
            isKnown ? currents_A[next - 1].value : std::numeric_limits<double>::quiet_NaN());
    }
}

void CoilTemperatureMonitor::take(const SampleBlock& block) {
    for (std::size_t i = 0; i < m_coils.size(); ++i) {
        const Coil& coil = m_coils[i];
        const int temperature = coil.temperature.empty() ? -1 : block.layout->indexOf(coil.temperature);
        const int current = coil.current.empty() ? -1 : block.layout->indexOf(coil.current);
        for (std::size_t row = 0; temperature >= 0 && row < block.rows(); ++row) {
            add(i, block.time_s[row], block.value(row, static_cast<std::size_t>(temperature)),
                current < 0 ? std::numeric_limits<double>::quiet_NaN()
                            : block.value(row, static_cast<std::size_t>(current)));
        }
    }
}

std::vector<CoilForecast> CoilTemperatureMonitor::forecasts(double limit_degC) const {
    std::vector<CoilForecast> forecasts;
    for (const Coil& coil : m_coils) {
        if (const auto newest_degC = coil.bins.newest_degC()) {
            auto forecast = control::forecastLimit(control::atSteadyLoad(coil.bins.bins()), limit_degC);
            if (forecast.stretch_s == 0.0) { // less than a second of it, but it was measured
                forecast.now_degC = *newest_degC;
                forecast.verdict =
                    *newest_degC >= limit_degC ? control::LimitForecast::Verdict::AtLimit : forecast.verdict;
            }
            forecasts.push_back({coil.temperature, forecast});
        }
    }
    return forecasts;
}

bool CoilTemperatureMonitor::isHeated(const std::string& temperature) const {
    return std::any_of(m_coils.begin(), m_coils.end(), [&](const Coil& coil) {
        return coil.temperature == temperature && !coil.bins.bins().empty() &&
               coil.bins.bins().back().square_A2 >= LeastHeating_A2;
    });
}

std::vector<CoilForecast> CoilTemperatureMonitor::tellingForecasts(double limit_degC) const {
    std::vector<CoilForecast> all = forecasts(limit_degC);
    const auto tellsNothing = [this](const CoilForecast& coil) {
        const Verdict verdict = coil.forecast.verdict;
        return verdict != Verdict::AtLimit && (verdict == Verdict::Withheld || !isHeated(coil.signal));
    };
    all.erase(std::remove_if(all.begin(), all.end(), tellsNothing), all.end());
    return all;
}

const CoilForecast* mostUrgent(const std::vector<CoilForecast>& forecasts) {
    const auto found = std::min_element(forecasts.begin(), forecasts.end(),
                                        [](const CoilForecast& one, const CoilForecast& other) {
                                            return urgency(one.forecast) < urgency(other.forecast);
                                        });
    return found == forecasts.end() ? nullptr : &*found;
}

std::optional<double> temperatureLimit_degC(devices::Device& device) {
    const std::string name = device.catalogue().parameterForRole("limit.temperature");
    if (!name.empty()) {
        const std::string names[] = {name};
        const auto values = device.readParameters(names);
        if (values && !values->empty()) {
            return values->front();
        }
    }
    const auto& constants = device.catalogue().knownConstants;
    const auto known = constants.find("T_limit_degC");
    return known == constants.end() ? std::nullopt : std::optional(known->second);
}

} // namespace halbench::app
