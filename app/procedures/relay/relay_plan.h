#pragma once

#include "app/procedures/relay/relay_procedure.h"

namespace halbench::app {

/// What decides the cycle besides the motor.
struct RelayBoard {
    double period_s = 0.01; ///< of the position loop
    int delaySamples = 0;
    double currentLimit_A = 4.0; ///< as set; the relay is never higher
};

/// The slowest base speed of at least 3 rad/s, and on it the highest relay, with which the loop swings by at
/// least 0.1 rad and the rotor never comes below 40 % of that speed, as an event-exact simulation of the
/// motor with its friction foresees it. Errors: NotFinite, OutOfRange, Refused (a motor that does not damp),
/// naming what to change; of plantFromEstimate.
Result<RelayPlan> planRelay(const RelayConfig& config, const RelayBoard& board);

/// Ultimate gain of 2.5 % to 97.5 % of the motors that the model's data allow; nothing without a covariance.
/// Takes some tenths of a second.
std::optional<std::pair<double, double>> foreseenGain95(const RelayConfig& config, const RelayBoard& board);

} // namespace halbench::app
