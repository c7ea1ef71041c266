#pragma once

#include "control/base/assert.h"
#include "control/base/result.h"

#include <optional>

namespace halbench::control {

/// Whether a system lives in continuous time (variable s) or on samples (variable z), and then at which
/// period. There is no period that means "continuous": the two cannot be confused or mixed.
class TimeBase {
public:
    static TimeBase continuous() { return TimeBase(std::nullopt); }
    /// `period_s` must be positive and finite (checked input comes through `sampledChecked`).
    static TimeBase sampled(double period_s) {
        HB_ASSERT(period_s > 0.0 && period_s < 1e9);
        return TimeBase(period_s);
    }
    /// Errors: NotFinite, OutOfRange.
    static Result<TimeBase> sampledChecked(double period_s);

    bool isContinuous() const { return !m_period_s.has_value(); }
    bool isSampled() const { return m_period_s.has_value(); }
    /// Only for a sampled base.
    double period_s() const {
        HB_ASSERT(m_period_s.has_value());
        return *m_period_s;
    }
    bool operator==(const TimeBase& other) const = default;

private:
    explicit TimeBase(std::optional<double> period_s) : m_period_s(period_s) {}
    std::optional<double> m_period_s;
};

/// The common base of two systems that are to be combined. Error: InvalidInput when they differ.
Result<TimeBase> commonTimeBase(const TimeBase& first, const TimeBase& second);

} // namespace halbench::control
