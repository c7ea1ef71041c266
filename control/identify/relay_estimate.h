#pragma once

#include "control/base/result.h"
#include "control/identify/frequency_fit.h"

#include <complex>
#include <span>
#include <utility>

namespace halbench::control {

/// Samples of a loop that swings by itself around a steady motion, what settles before them left out.
struct CycleRows {
    double period_s = 0.01;            ///< of the samples
    std::span<const double> reference; ///< the motion it swings around; slow against the cycle
    std::span<const double> input;     ///< u of the plant, as commanded
    std::span<const double> output;    ///< y of the plant
};

/// The fundamental of a limit cycle in what the controller commanded and what was measured.
struct LimitCyclePoint {
    double frequency_rad_s = 0.0;      ///< mean
    double frequencyScatter_ratio = 0; ///< standard deviation from block to block over the mean
    std::complex<double> plant;        ///< Y/U at that frequency
    double radius = 0.0;               ///< 95 % circle of confidence around `plant`, of what scatters
    double amplitude = 0.0;            ///< of the output's fundamental
    double input = 0.0;                ///< of the input's
    double growth_ratio = 1.0;         ///< output's amplitude in the last third over that in the first
    int cycles = 0;
    int blocks = 0;
};

/// The record is cut into blocks of two whole cycles; in each, mean, drift and five harmonics are fitted to u
/// and to y - r. A block that is slower or faster than the mean is brought to the mean frequency by the shape
/// of a free inertia, H = (z + 1)/(z - 1)^2, which the plant follows in so narrow a band. Then
///
///     G = sum Y_b conj(U_b) / sum |U_b|^2,    radius^2 = F_0.95(2, 2(B-1)) s^2 / sum |U_b|^2
///
/// with s^2 = sum |Y_b - G U_b|^2/(B - 1) over B blocks. It holds whatever makes the cycle: no describing
/// function is in it. Errors: InvalidInput (lengths), NotFinite, Refused (fewer than 16 cycles: nothing
/// swings).
Result<LimitCyclePoint> estimateLimitCycle(const CycleRows& rows);

/// Where proportional control of a sampled loop is on its limit.
struct UltimateGain {
    double gain = 0.0; ///< K_u = 1/|G| where the phase of G z^-d is -180 degrees
    double frequency_rad_s = 0.0;
};

/// Of a rotor behind a current that is held and `delay_samples` late. Errors: Refused for one that does not
/// damp: it swings at any gain.
Result<UltimateGain> ultimateGain(const SampledPlantModel& rotor, double period_s, int delay_samples);

/// What is known beside the cycle itself.
struct CycleLoop {
    double period_s = 0.01;
    int delay_samples = 0;
    double lag_s = 0.0;           ///< of the currents behind their command
    double gainError_ratio = 0.0; ///< 95 % of what scales the current and no response can show
    double mostPhase_deg = 10.0;  ///< a cycle farther from -180 degrees says nothing of that place
};

/// The ultimate gain as a cycle near -180 degrees tells it.
struct UltimateEstimate {
    UltimateGain at;
    std::pair<double, double> gain95;
    std::pair<double, double> period95_s;
    double phase_deg = 0.0; ///< of G z^-d at the cycle's own frequency
    std::pair<double, double> phase95_deg;
    SampledPlantModel rotor; ///< the one rotor that has this G at this frequency
};

/// A relay that is not symmetric swings near -180 degrees and not at it; there one degree is 17 % of gain
/// on a rotor that hardly damps. G is one complex number, a rotor has two constants (a, k): the one rotor
/// that has this G is followed to -180 degrees. The intervals are what the circle of confidence makes of
/// that. Errors: Refused (too far from -180 degrees, no rotor has this G, the circle bounds nothing).
Result<UltimateEstimate> ultimateOfCycle(const LimitCyclePoint& cycle, const CycleLoop& loop);

} // namespace halbench::control
