#pragma once

namespace halbench::models {

/// Heating of one phase winding by its own current:
///   C_th dT/dt = R25 (1 + alpha (T - 25)) i^2 - (T - T_amb)/R_th.
/// Source: resources/help/htm-theory.md section 9. With these values: time constant 480 s, 79.7 degC at 2 A
/// of rotating amplitude, no equilibrium above 3.36 A rms in a phase.
struct CoilHeatingConfig {
    double heatCapacity_J_per_K = 32.0;
    double thermalResistance_K_per_W = 15.0;
    double resistanceAt25_Ohm = 1.5;
    double copperCoefficient_per_K = 0.00393;
    double ambient_degC = 25.0;
    double sensorCoupling_ratio = 0.5; ///< share of the coil's rise over ambient that its Hall sensor follows
};

struct CoilHeatingState {
    double temperature_degC = 25.0;
};

/// Exact step for a current that is constant over it; the equation is linear in T. `step_s` may be longer
/// than the mechanical step: heat accelerated on request is the same call with more seconds.
void stepCoilHeating(const CoilHeatingConfig& config, CoilHeatingState& state, double current_A,
                     double step_s);

/// The same for a given mean square of the current, A^2, e.g. I^2/2 for a rotating amplitude I.
void stepCoilHeatingSquare(const CoilHeatingConfig& config, CoilHeatingState& state, double square_A2,
                           double step_s);

/// R_a at the present temperature, ohm.
double coilResistance_Ohm(const CoilHeatingConfig& config, const CoilHeatingState& state);

/// Temperature of the Hall sensor beside this coil: ambient + coupling (T_coil - ambient).
double hallTemperature_degC(const CoilHeatingConfig& config, const CoilHeatingState& state);

} // namespace halbench::models
