#pragma once

#include "control/lti/dead_time.h"
#include "control/lti/delta_system.h"
#include "control/lti/transfer_function.h"

#include <complex>
#include <functional>
#include <optional>
#include <vector>

namespace halbench::control {

/// An open loop looked at once over frequencies between which nothing happens, and how to look again.
struct LoopScan {
    std::function<std::complex<double>(double)> at;
    std::vector<double> frequency_rad_s;
    std::vector<std::complex<double>> value;
    bool endsAtNyquist = false;
    /// L towards rest and, where it has one, towards infinite frequency: ends of the curve that no grid
    /// holds. An integrating loop has an infinite real one.
    std::optional<std::complex<double>> atRest = {};
    std::optional<std::complex<double>> atInfinity = {};
    /// Where frequencies were left out: below this one nothing is known of the loop.
    std::optional<double> knownFrom_rad_s = {};
};

LoopScan scanLoop(const TransferFunction& openLoop);
/// All frequencies, with all digits.
LoopScan scanLoop(const DeltaSystem& openLoop);

/// The grid of the rational part, closed up so that the dead time turns the phase by at most 0.25 rad from
/// point to point. It ends where |L| stays below 0.01, or after 200 turns of the dead time.
LoopScan scanLoop(const DeadTimeSystem& openLoop);

} // namespace halbench::control
