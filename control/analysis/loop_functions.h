#pragma once

#include "control/base/result.h"
#include "control/lti/delta_system.h"
#include "control/lti/transfer_function.h"

#include <optional>

namespace halbench::control {

/// The four closed-loop functions of plant P and controller C with L = P C (all must be stable):
/// S = 1/(1+L) errors, PS = P/(1+L) from load to output, CS = C/(1+L) from noise to actuator, T = L/(1+L).
/// Built over the common characteristic polynomial without cancelling anything, so an unstable cancellation
/// stays visible.
struct LoopFunctions {
    TransferFunction S;
    TransferFunction PS;
    TransferFunction CS;
    TransferFunction T;
};

/// Errors: InvalidInput (mixed time bases, algebraic loop).
Result<LoopFunctions> loopFunctions(const TransferFunction& plant, const TransferFunction& controller);

struct ResponsePeak {
    double magnitude_ratio = 0.0;
    double frequency_rad_s = 0.0;
};

/// Largest magnitude over frequency, e.g. the resonant peak of T. One that lies at rest or at infinity is
/// told with the lowest or highest frequency looked at.
ResponsePeak peakMagnitude(const TransferFunction& system);

/// Lowest frequency where the magnitude has fallen to 1/sqrt(2) of the static gain (absent when it never
/// does).
std::optional<double> bandwidth_rad_s(const TransferFunction& closedLoop);
/// The same of T = L/(1+L), from the open loop.
std::optional<double> closedBandwidth_rad_s(const DeltaSystem& openLoop);

} // namespace halbench::control
