#pragma once

#include "control/law/position_loop.h"

namespace halbench::control {

/// Answer of the linear sampled loop at rest (no friction, no current limit) to a load that appears at once
/// and stays, given as the torque current that is worth as much: the rotor sees i + load, the law only the
/// angle. Exact between the samples.
struct LoadStep {
    std::vector<double> time_s;
    std::vector<double> angle_rad; ///< from the reference, in the direction of the load
    std::vector<double> current_A; ///< of the law; it ends at -load
    double peak_rad = 0.0;         ///< farthest, with its sign
    double peakTime_s = 0.0;
    double final_rad = 0.0; ///< where it comes to rest: load/K_P, and 0 with integral action
    /// From here on the angle stays within a tenth of the peak around `final_rad`; absent when it did not.
    std::optional<double> recoveryTime_s;
};

/// The loop must be stable for `final_rad` to mean anything. Errors: of the inputs; OutOfRange (extent);
/// Refused (an unstable loop that grows beyond all numbers).
Result<LoadStep> loadStep(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing,
                          double load_A, double duration_s, int pointsPerSample = 10);

} // namespace halbench::control
