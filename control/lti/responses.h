#pragma once

#include "control/base/result.h"
#include "control/lti/state_space.h"
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
/// To an impulse of area one: C exp(A t) B, at 0 the value just after it; a sampled system gets a single
/// sample of 1/T. Error also: InvalidInput for a continuous system that passes the impulse on.
Result<TimeResponse> impulseResponse(const TransferFunction& system, double duration_s, double resolution_s);
/// To t from rest.
Result<TimeResponse> rampResponse(const TransferFunction& system, double duration_s, double resolution_s);

/// How an input runs between the times at which it is given.
enum class InputShape {
    Held,    ///< constant until the next
    Straight ///< on straight lines
};

/// Response of a continuous system with one input and one output from rest at time_s.front() to any input,
/// exact for its shape; even and uneven times alike (each change of the interval costs one matrix
/// exponential). Errors: InvalidInput (lengths, fewer than two times, not ascending, sampled system, several
/// paths).
Result<TimeResponse> respond(const StateSpace& system, const std::vector<double>& time_s,
                             const std::vector<double>& input, InputShape shape);

/// Output of a sampled system from rest for an input sequence at its period. Up to 8 states go four
/// samples at a time through one matrix of fixed size.
std::vector<double> simulate(const TransferFunction& sampledSystem, const std::vector<double>& input);
std::vector<double> simulate(const StateSpace& sampledSystem, const std::vector<double>& input);

} // namespace halbench::control
