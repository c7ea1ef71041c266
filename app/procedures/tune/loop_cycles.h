#pragma once

#include "app/procedures/tune/analyse.h"

#include <optional>
#include <vector>

namespace halbench::app {

/// An oscillation that friction and current limit let the loop keep up, by harmonic balance
/// (control/assess/friction_cycles.h; help: resources/help/tuning.md, "Limit cycles and hunting").
struct PredictedCycle {
    double amplitude_rad = 0.0; ///< half of peak to peak
    double frequency_Hz = 0.0;
    /// Otherwise a threshold: less comes to rest, more grows into the next larger one.
    bool isStable = false;
    /// What the balance is good for off the published motor (control/assess/friction_cycles.h).
    double accuracy_ratio = 0.5;
};

/// In ascending amplitude; empty: none. Nothing for a law with the micro-step assist, a second relay that the
/// balance does not know, and for a motor without friction.
std::optional<std::vector<PredictedCycle>>
predictCycles(const control::PositionPlant& plant, const LoopLaw& law, const LoopConditions& conditions);

/// The threshold and the swing that a law falls into, for a warning; nothing when it comes to rest.
std::optional<Finding> cycleWarning(const std::vector<PredictedCycle>& cycles);

/// Seconds until the integral moves a rotor that rests at half of the friction band; hunting is that again
/// and again. Infinite without an integral.
double releaseTime_s(const control::PositionPlant& plant, const control::PositionLaw& law,
                     double frictionBand_rad);

} // namespace halbench::app
