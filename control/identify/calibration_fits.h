#pragma once

#include "control/base/result.h"

#include <span>
#include <vector>

namespace halbench::control {

/// Readings of both Hall sensors and the currents of their own phases, rotor at rest.
struct StrayRecord {
    std::vector<double> hallA_T;
    std::vector<double> hallB_T;
    std::vector<double> currentA_A;
    std::vector<double> currentB_A;
};

struct StrayFit {
    double coefficient_T_per_A = 0.0;
    double error_T_per_A = 0.0; ///< 1 sigma
    int freedom = 0;
    double residualRms_T = 0.0;
};

/// Field of a phase current at its own sensor from records at standstill, each at its own angle, while a pure
/// d-axis current (no torque) steps through several levels: B = B_rest + k_s i in both channels of every
/// record with one common slope. Errors: Refused (currents that do not change), NotFinite.
/// Source: resources/help/identification.md section 6.
Result<StrayFit> fitStray(std::span<const StrayRecord> records);

/// First motion under a slowly rising current.
struct Breakaway {
    double time_s = 0.0;
    double current_A = 0.0;
};

/// The rotor leaves its rest at `time_s` with a jump of acceleration (static above kinetic friction) and goes
/// on with a rising one: travel = alpha tau^2/2 + beta tau^3/6. The instant is found by least squares on a
/// grid, which removes the delay of any threshold. `moving_rad`: travel that is certainly motion.
/// Errors: Refused (it never moved, or moved from the first sample).
Result<Breakaway> findBreakaway(std::span<const double> time_s, std::span<const double> angle_rad,
                                std::span<const double> current_A, double moving_rad = 0.05);

} // namespace halbench::control
