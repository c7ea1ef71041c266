#pragma once

#include <algorithm>

namespace halbench::models {

/// Analogue temperature sensor on a coil: V = 750 mV + 10 mV/K (T + error - 25), range -40 ... 125 degC.
/// Source: resources/help/htm-theory.md sections 2, 3.4 (T = 0.1 V_T[mV] - 50) and 9 (error +-1 K, at most 2
/// K).
struct TemperatureSensorConfig {
    double voltageAt25_V = 0.75;
    double sensitivity_V_per_K = 0.01;
    double error_K = 0.0;
    double lowest_degC = -40.0;
    double highest_degC = 125.0;
};

inline double temperatureVoltage_V(const TemperatureSensorConfig& config, double temperature_degC) {
    const double seen_degC =
        std::clamp(temperature_degC + config.error_K, config.lowest_degC, config.highest_degC);
    return config.voltageAt25_V + config.sensitivity_V_per_K * (seen_degC - 25.0);
}

inline double temperatureOfVoltage_degC(const TemperatureSensorConfig& config, double voltage_V) {
    return 25.0 + (voltage_V - config.voltageAt25_V) / config.sensitivity_V_per_K;
}

} // namespace halbench::models
