#include "models/sensors/hall_sensor.h"

#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

constexpr double ReferenceTemperature_degC = 25.0;

double sensitivity_V_per_T(const HallConfig& config, double temperature_degC) {
    return config.sensitivity_V_per_T *
           (1.0 + config.sensitivityTemperature_per_K * (temperature_degC - ReferenceTemperature_degC));
}

} // namespace

Result<void> checkHallConfig(const HallConfig& config) {
    for (const double value :
         {config.placement_rad, config.field_T, config.gain_ratio, config.offset_T, config.stray_T_per_A,
          config.noise_T, config.quiescent_V, config.sensitivity_V_per_T, config.sensitivityTemperature_per_K,
          config.clipLow_V, config.clipHigh_V}) {
        if (!std::isfinite(value)) {
            return failure(ErrorCode::NotFinite, "A Hall sensor setting is not a finite number.");
        }
    }
    if (config.noise_T < 0.0 || config.sensitivity_V_per_T <= 0.0 || config.clipLow_V >= config.clipHigh_V) {
        return failure(ErrorCode::OutOfRange,
                       "A Hall sensor needs a positive sensitivity, noise of at least zero and a lower clip "
                       "voltage below the upper one.");
    }
    const bool hasOnlyOvertones =
        std::all_of(config.harmonics.begin(), config.harmonics.end(), [](const FieldHarmonic& harmonic) {
            return harmonic.order >= 1 && std::isfinite(harmonic.cosine_ratio) &&
                   std::isfinite(harmonic.sine_ratio);
        });
    if (!hasOnlyOvertones) {
        return failure(ErrorCode::OutOfRange,
                       "A field harmonic needs an order of at least 1 and finite amplitudes.",
                       "A constant belongs into the offset.");
    }
    return {};
}

std::array<HallConfig, 2> hallPair(const HallConfig& nominal, double quadrature_rad) {
    HallConfig a = nominal;
    a.placement_rad = 0.0;
    HallConfig b = nominal;
    b.placement_rad = 0.5 * Pi - quadrature_rad;
    return {a, b};
}

double hallField_T(const HallConfig& config, double angle_rad, double ownPhaseCurrent_A) {
    const double theta = angle_rad - config.placement_rad;
    double shape = std::cos(theta);
    for (const FieldHarmonic& harmonic : config.harmonics) {
        shape += harmonic.cosine_ratio * std::cos(harmonic.order * theta) +
                 harmonic.sine_ratio * std::sin(harmonic.order * theta);
    }
    return config.field_T * config.gain_ratio * shape + config.stray_T_per_A * ownPhaseCurrent_A +
           config.offset_T;
}

double hallVoltage_V(const HallConfig& config, double angle_rad, double ownPhaseCurrent_A,
                     double sensorTemperature_degC, Random& noise) {
    double field_T = hallField_T(config, angle_rad, ownPhaseCurrent_A);
    if (config.noise_T > 0.0) {
        field_T += config.noise_T * noise.gaussian();
    }
    return hallVoltageOfField_V(config, field_T, sensorTemperature_degC);
}

double hallVoltageOfField_V(const HallConfig& config, double field_T, double sensorTemperature_degC) {
    const double voltage_V =
        config.quiescent_V + sensitivity_V_per_T(config, sensorTemperature_degC) * field_T;
    return std::clamp(voltage_V, config.clipLow_V, config.clipHigh_V);
}

double hallFieldOfVoltage_T(const HallConfig& config, double voltage_V, double reportedTemperature_degC) {
    return (voltage_V - config.quiescent_V) / sensitivity_V_per_T(config, reportedTemperature_degC);
}

} // namespace halbench::models
