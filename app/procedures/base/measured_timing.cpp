#include "app/procedures/base/measured_timing.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::app {

MeasuredTiming timingOf(const devices::Catalogue& catalogue, std::span<const ParameterValue> values) {
    MeasuredTiming timing;
    if (const auto period = catalogue.knownConstants.find("T_s"); period != catalogue.knownConstants.end()) {
        timing.period_s = period->second;
    }
    const std::string delay = catalogue.parameterForRole("delay.samples");
    for (const ParameterValue& value : values) {
        if (!delay.empty() && value.name == delay) {
            timing.delay_samples = static_cast<int>(std::lround(value.value));
        }
    }
    return timing;
}

control::LoopTiming timingOr(const MeasuredTiming& measured, control::LoopTiming otherwise) {
    otherwise.period_s = measured.period_s.value_or(otherwise.period_s);
    otherwise.delay_samples = measured.delay_samples.value_or(otherwise.delay_samples);
    return otherwise;
}

bool isSamePeriod(double one_s, double other_s) {
    constexpr double Rounding_ratio = 1e-6; // single precision on a board
    return std::fabs(one_s - other_s) <= Rounding_ratio * std::fabs(other_s);
}

bool isSameTiming(const control::LoopTiming& one, const control::LoopTiming& other) {
    return isSamePeriod(one.period_s, other.period_s) && one.delay_samples == other.delay_samples;
}

Result<void> checkTimingOfModel(const MeasuredTiming& model, const control::LoopTiming& device) {
    const control::LoopTiming own = timingOr(model, device);
    if (isSameTiming(own, device)) {
        return {};
    }
    return failure(ErrorCode::Refused,
                   fmt::format("the motor was measured at {:.4g} s with {} samples of delay, this device has "
                               "{:.4g} s and {}",
                               own.period_s, own.delay_samples, device.period_s, device.delay_samples),
                   "identify the motor with the present delay of the device");
}

} // namespace halbench::app
