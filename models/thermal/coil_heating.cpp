#include "models/thermal/coil_heating.h"

#include <cmath>

namespace halbench::models {
namespace {

/// (e^x - 1)/x, regular at zero.
double relativeExponential(double x) {
    // Below 1e-4 the next term of the series is 4e-14 of the sum.
    return std::abs(x) < 1e-4 ? 1.0 + x * (0.5 + x / 6.0) : std::expm1(x) / x;
}

} // namespace

void stepCoilHeating(const CoilHeatingConfig& config, CoilHeatingState& state, double current_A,
                     double step_s) {
    stepCoilHeatingSquare(config, state, current_A * current_A, step_s);
}

void stepCoilHeatingSquare(const CoilHeatingConfig& config, CoilHeatingState& state, double square_A2,
                           double step_s) {
    const double power_W = coilResistance_Ohm(config, state) * square_A2;
    const double loss_W = (state.temperature_degC - config.ambient_degC) / config.thermalResistance_K_per_W;
    const double slope_W_per_K = config.resistanceAt25_Ohm * config.copperCoefficient_per_K * square_A2 -
                                 1.0 / config.thermalResistance_K_per_W;
    const double growth = slope_W_per_K * step_s / config.heatCapacity_J_per_K;
    // T' = f(T) with linear f: T(t) = T0 + f(T0) t (e^{f' t} - 1)/(f' t)
    state.temperature_degC +=
        (power_W - loss_W) / config.heatCapacity_J_per_K * step_s * relativeExponential(growth);
}

double coilResistance_Ohm(const CoilHeatingConfig& config, const CoilHeatingState& state) {
    return config.resistanceAt25_Ohm *
           (1.0 + config.copperCoefficient_per_K * (state.temperature_degC - 25.0));
}

double hallTemperature_degC(const CoilHeatingConfig& config, const CoilHeatingState& state) {
    return config.ambient_degC + config.sensorCoupling_ratio * (state.temperature_degC - config.ambient_degC);
}

} // namespace halbench::models
