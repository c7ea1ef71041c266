#pragma once

namespace halbench::models {

/// Transconductance amplifier on a coil: the current follows its target with first order while the voltage it
/// takes stays within the supply, and at the supply's voltage otherwise:
///   i' = w (i_target - i)   or   L i' = +-V_supply - R i - e,
///   i_target = clamp(demand, +-limit) - e/R_out,
/// e: voltage that motion induces in the coil. Source: resources/help/planar-theory.md section 8.
struct CurrentSourceConfig {
    double bandwidth_rad_s = 43310.0; ///< w
    double inductance_H = 1.28e-3;
    double supply_V = 24.0;
    double output_Ohm = 2e3; ///< R_out
    double limit_A = 1.0;
};

struct SourceCurrent {
    double atEnd_A = 0.0;
    double mean_A = 0.0; ///< exact average over the step
};

/// Exact for demand, resistance and induced voltage that are constant over the step.
SourceCurrent stepCurrentSource(const CurrentSourceConfig& config, double current_A, double demand_A,
                                double resistance_Ohm, double induced_V, double step_s);

} // namespace halbench::models
