#include "control/lti/frequency_response.h"

#include "control/base/assert.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::control {

std::vector<double> logarithmicFrequencies(double from_rad_s, double to_rad_s, int count) {
    HB_ASSERT(from_rad_s > 0.0 && to_rad_s > from_rad_s && count >= 2);
    std::vector<double> result(static_cast<std::size_t>(count));
    const double ratio_log = std::log(to_rad_s / from_rad_s);
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] =
            from_rad_s * std::exp(ratio_log * static_cast<double>(i) / static_cast<double>(count - 1));
    }
    result.back() = to_rad_s;
    return result;
}

namespace {

/// Not through std::function: a rational value costs little more than such a call.
Result<FrequencyResponse> valuesOf(const auto& atFrequency, const TimeBase& base,
                                   const std::vector<double>& frequency_rad_s) {
    FrequencyResponse response{frequency_rad_s, {}};
    response.value.reserve(frequency_rad_s.size());
    // The Nyquist frequency itself is allowed; its rounding must not turn it away.
    const double limit_rad_s = base.isSampled() ? Pi / base.period_s() * (1.0 + 1e-12) : HUGE_VAL;
    for (const double frequency : frequency_rad_s) {
        if (!(frequency > 0.0 && frequency <= limit_rad_s)) {
            return failure(ErrorCode::OutOfRange,
                           fmt::format("{} rad/s is outside the frequency range of the system", frequency));
        }
        response.value.push_back(atFrequency(frequency));
    }
    return response;
}

} // namespace

Result<FrequencyResponse> frequencyResponse(const std::function<std::complex<double>(double)>& atFrequency,
                                            const TimeBase& timeBase,
                                            const std::vector<double>& frequency_rad_s) {
    return valuesOf(atFrequency, timeBase, frequency_rad_s);
}

Result<FrequencyResponse> frequencyResponse(const TransferFunction& system,
                                            const std::vector<double>& frequency_rad_s) {
    return valuesOf([&system](double w) { return system.atFrequency(w); }, system.timeBase(),
                    frequency_rad_s);
}

std::vector<double> magnitude_dB(const FrequencyResponse& response) {
    std::vector<double> result;
    result.reserve(response.value.size());
    for (const auto& value : response.value) {
        result.push_back(20.0 * std::log10(std::abs(value)));
    }
    return result;
}

std::vector<double> phase_deg(const FrequencyResponse& response) {
    std::vector<double> result;
    result.reserve(response.value.size());
    for (const auto& value : response.value) {
        double phase = radiansToDegrees(std::arg(value));
        if (result.empty()) {
            phase = phase > 0.0 ? phase - 360.0 : phase;
        } else {
            phase += 360.0 * std::round((result.back() - phase) / 360.0);
        }
        result.push_back(phase);
    }
    return result;
}

} // namespace halbench::control
