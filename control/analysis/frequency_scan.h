#pragma once

#include "control/lti/transfer_function.h"

#include <functional>
#include <vector>

namespace halbench::control {

/// Ascending frequencies at which a system is looked at so that nothing happens between two of them: 200 a
/// decade from far below the slowest to far above the fastest pole or zero, closer around lightly damped
/// ones; a sampled system ends exactly at its Nyquist frequency. Points where the denominator has lost its
/// digits to cancellation (sampled integrators at very low frequency) are left out.
std::vector<double> scanFrequencies(const TransferFunction& system);

/// Zero of a function between two points of opposite sign, to the rounding of x; where it jumps from one sign
/// to the other, the jump. Some ten values of a smooth function, never more than 200.
double rootBetween(const std::function<double(double)>& function, double low, double high);

/// Place of the smallest value inside an interval that holds one minimum, by golden section.
double goldenMinimum(const std::function<double(double)>& function, double low, double high);

/// Place of the smallest value over ascending points: the best point, refined between its neighbours.
double scanMinimum(const std::function<double(double)>& function, const std::vector<double>& points);

} // namespace halbench::control
