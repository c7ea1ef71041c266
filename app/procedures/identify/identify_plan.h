#pragma once

#include "app/procedures/excite/spin_drive.h"
#include "app/procedures/identify/identify_procedure.h"

#include <vector>

namespace halbench::app {

/// The motor as a first short run shows it, good to some per cent: decides dwell and currents.
struct PilotEstimate {
    double damping_per_s = 0.0;   ///< c/J
    double friction_rad_s2 = 0.0; ///< K_f/J
    double torque_rad_s2_A = 0.0; ///< phi/J
    double dampingError_per_s = 0.0;

    /// Steady speed at this current; infinite without damping.
    double steadySpeed_rad_s(double current_A) const;
};

/// The published motor, for predictions before anything has moved.
PilotEstimate nominalMotor();

/// The runs after the pilot: in each direction a sweep (highest current first, then all in random order, the
/// first repeated at the end, then a coast-down) and a series of run-ups and coast-downs. Dwell 9 J/c plus
/// the two windows of the steadiness test; without damping only run-ups and coast-downs remain.
std::vector<PlateauRun> planRuns(const IdentifyConfig& config, const std::vector<double>& currents_A,
                                 const PilotEstimate& pilot);

/// The currents of the sweep for this motor: those asked for where the speed limit admits them all and half
/// of them turn it fast enough, else as many, evenly between the slowest usable and the highest admissible.
std::vector<double> suitedCurrents_A(const IdentifyConfig& config, const std::vector<double>& currents_A,
                                     const PilotEstimate& pilot);

/// Pairs of run-up and coast-down under at most `highest_A`, below 75 % of the speed limit all the time. The
/// rotor comes to rest in each pair as far as its friction does it within 4 s. `dwell_s`: least duration of
/// each half.
PlateauRun coastRun(const PilotEstimate& pilot, double highest_A, int pairs, double dwell_s,
                    double speedLimit_rad_s);

} // namespace halbench::app
