#pragma once

#include "control/analysis/margins.h"
#include "control/analysis/step_metrics.h"
#include "control/base/result.h"
#include "control/law/pid.h"
#include "control/lti/transfer_function.h"

#include <complex>
#include <optional>
#include <vector>

namespace halbench::control {

/// A rotor under torque current: psi'' + a psi' = k (i - i_f sgn psi'). The three numbers are ratios, so that
/// a motor whose absolute constants are unknown can still be tuned (resources/help/htm-theory.md 7.1).
struct PositionPlant {
    double dampingRate_1_s = 0.0;           ///< a = c/J
    double accelerationGain_rad_s2_A = 0.0; ///< k = phi/J
    double breakawayCurrent_A = 0.0;        ///< i_f = K_f/phi
};

/// The board's law of resources/help/htm-theory.md 8.4 (with zero extras: 3.6), once per sample:
///   u = K_P e + x + K_D (ref' - (psi[k] - psi[k-1])/T_s)
///       + inertia ref'' + viscous ref' + coulomb sat(ref'/coulombSpeed)
///       + (|ref'| < stictionSpeed and |e| > stictionThreshold) stictionCurrent sgn e
///   x += T_s K_I e
struct PositionLaw {
    PidGains gains;
    double inertia_A_s2_rad = 0.0;
    double viscous_A_s_rad = 0.0;
    double coulomb_A = 0.0;
    double coulombSpeed_rad_s = 0.02;
    double stictionCurrent_A = 0.0;
    double stictionThreshold_rad = 0.16 * 3.14159265358979323846 / 180.0;
    double stictionSpeed_rad_s = 0.02;

    bool operator==(const PositionLaw&) const = default;
};

/// What surrounds the law on the board.
struct LoopTiming {
    double period_s = 0.01;
    int delay_samples = 0; ///< between sampling the angle and the current: 0, 1 or 2

    bool operator==(const LoopTiming&) const = default;
};

/// The one place where these inputs are judged. Errors: NotFinite, OutOfRange.
Result<void> checkPlant(const PositionPlant& plant);
Result<void> checkTiming(const LoopTiming& timing);

/// k/(s^2 + a s), and with the current held over the period (b1 z + b2)/((z-1)(z-E)) (htm-theory.md 3.7).
TransferFunction continuousPlant(const PositionPlant& plant);
TransferFunction sampledPlant(const PositionPlant& plant, double period_s);

/// K_P + T_s K_I/(z-1) + K_D (z-1)/(T_s z): what the law does to a measured angle.
Result<TransferFunction> sampledController(const PidGains& gains, double period_s);

/// Controller, delay and held plant in series. Errors: of the inputs.
Result<TransferFunction> sampledOpenLoop(const PositionPlant& plant, const PidGains& gains,
                                         const LoopTiming& timing);
/// (K_P + K_I/s + K_D s) k/(s^2 + a s), the books' loop without sampling.
Result<TransferFunction> continuousOpenLoop(const PositionPlant& plant, const PidGains& gains);

std::vector<std::complex<double>> closedLoopPoles(const TransferFunction& openLoop);
/// Largest modulus of a closed-loop pole of a sampled loop: stable below 1.
double poleRadius(const TransferFunction& openLoop);

/// Largest K_P that keeps the sampled loop stable with the given K_D and K_I = 0 (17.27 A/rad for the
/// published motor without delay).
double proportionalLimit_A_per_rad(const PositionPlant& plant, const LoopTiming& timing,
                                   double derivative_A_s_per_rad = 0.0);

/// Half width of the band in which friction holds the rotor at a resting reference, before the integral moves
/// it. The micro-step assist i_a acts beyond its threshold e_a only, so that what rests is
///     |e| <= max((i_f - i_a)/K_P, min(e_a, i_f/K_P)),
/// i_f/K_P without an assist (help: resources/help/tuning.md, "What the friction leaves").
double frictionBand_rad(const PositionPlant& plant, const PositionLaw& law);
/// The same of numbers: K_P in A/rad, above 0.
double frictionBand_rad(double breakaway_A, double proportional_A_per_rad, double assist_A,
                        double assistThreshold_rad);

/// Answer of the linear sampled loop (no friction, no current limit) to a reference step, exact between the
/// samples.
struct LoopStep {
    std::vector<double> time_s;
    std::vector<double> response_rad;
    std::vector<double> current_A;
    StepMetrics metrics;
};
Result<LoopStep> linearStep(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing,
                            double amplitude_rad, double duration_s, int pointsPerSample = 10);

} // namespace halbench::control
