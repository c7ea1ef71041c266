#pragma once

#include "control/base/result.h"
#include "control/lti/transfer_function.h"

#include <vector>

namespace halbench::control {

struct TimeResponse {
    std::vector<double> time_s;
    std::vector<double> value;
};

/// Response to a unit step from rest. A sampled system answers at its own period and ignores `resolution_s`;
/// a continuous one is computed exactly at multiples of it. Errors: OutOfRange (duration, resolution).
Result<TimeResponse> stepResponse(const TransferFunction& system, double duration_s, double resolution_s);

/// Output of a sampled system from rest for an input sequence at its period.
std::vector<double> simulate(const TransferFunction& sampledSystem, const std::vector<double>& input);

} // namespace halbench::control
