#pragma once

#include "control/lti/delta_system.h"
#include "control/lti/transfer_function.h"

#include <functional>
#include <vector>

namespace halbench::control {

/// Ascending frequencies at which a system is looked at so that nothing happens between two of them: 200 a
/// decade from far below the slowest to far above the fastest pole or zero, closer around lightly damped
/// ones; a sampled system ends exactly at its Nyquist frequency.
struct FrequencyScan {
    std::vector<double> frequency_rad_s;
    /// Points below the first were left out: coefficients of z have lost their digits there to cancellation
    /// (sampled integrators and slow filters at very low frequency).
    bool isCut = false;
};
FrequencyScan frequencyScan(const TransferFunction& system);
/// Never cut: in d nothing cancels.
FrequencyScan frequencyScan(const DeltaSystem& system);
/// The frequencies alone.
std::vector<double> scanFrequencies(const TransferFunction& system);

/// Zero of a function between two points of opposite sign, to the rounding of x; where it jumps from one sign
/// to the other, the jump. Some ten values of a smooth function, never more than 200.
double rootBetween(const std::function<double(double)>& function, double low, double high);

/// Place of the smallest value inside an interval that holds one minimum, by golden section.
double goldenMinimum(const std::function<double(double)>& function, double low, double high);

/// Place of the smallest value over ascending points: the best point, refined between its neighbours.
double scanMinimum(const std::function<double(double)>& function, const std::vector<double>& points);

} // namespace halbench::control
