#include "control/lti/time_base.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::control {

Result<TimeBase> TimeBase::sampledChecked(double period_s) {
    if (!std::isfinite(period_s)) {
        return failure(ErrorCode::NotFinite, "the sample period is not a finite number");
    }
    if (period_s <= 0.0 || period_s >= 1e9) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a sample period of {} s is not possible", period_s),
                       "give a positive period in seconds");
    }
    return sampled(period_s);
}

Result<TimeBase> commonTimeBase(const TimeBase& first, const TimeBase& second) {
    if (first == second) {
        return first;
    }
    const auto describe = [](const TimeBase& base) {
        return base.isContinuous() ? std::string("continuous")
                                   : fmt::format("sampled at {} s", base.period_s());
    };
    return failure(ErrorCode::InvalidInput,
                   fmt::format("a system that is {} cannot be combined with one that is {}", describe(first),
                               describe(second)),
                   "discretize one of them first");
}

} // namespace halbench::control
