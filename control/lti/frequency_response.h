#pragma once

#include "control/base/result.h"
#include "control/lti/transfer_function.h"

#include <complex>
#include <functional>
#include <vector>

namespace halbench::control {

/// A response known at frequencies only: computed from a model, or measured.
struct FrequencyResponse {
    std::vector<double> frequency_rad_s; ///< strictly increasing
    std::vector<std::complex<double>> value;
};

/// `count` >= 2 frequencies evenly spread on a logarithmic axis, both ends included.
std::vector<double> logarithmicFrequencies(double from_rad_s, double to_rad_s, int count);

/// Values of any response over frequencies that its time base allows. Errors: OutOfRange for a frequency that
/// is not positive or lies above the Nyquist frequency.
Result<FrequencyResponse> frequencyResponse(const std::function<std::complex<double>(double)>& atFrequency,
                                            const TimeBase& timeBase,
                                            const std::vector<double>& frequency_rad_s);
Result<FrequencyResponse> frequencyResponse(const TransferFunction& system,
                                            const std::vector<double>& frequency_rad_s);

std::vector<double> magnitude_dB(const FrequencyResponse& response);
/// Unwrapped: neighbours differ by less than 180 degrees; the first value lies in (-360, 0] as the phase of a
/// loop with integrators does.
std::vector<double> phase_deg(const FrequencyResponse& response);

} // namespace halbench::control
