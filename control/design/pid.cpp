#include "control/design/pid.h"

#include "control/base/units.h"

#include <cmath>

namespace halbench::control {

namespace {

constexpr double Never_s = std::numeric_limits<double>::infinity();

bool isFinite(const PidGains& gains) {
    const bool isIntegralFine =
        std::isfinite(gains.integral) || (gains.form != PidForm::Parallel && gains.integral == Never_s);
    return std::isfinite(gains.proportional) && isIntegralFine && std::isfinite(gains.derivative) &&
           (!gains.filter_s || std::isfinite(*gains.filter_s));
}

struct Terms {
    double kp = 0.0;
    double ki = 0.0;
    double kd = 0.0;
};

Result<Terms> parallelTerms(const PidGains& gains) {
    const double K = gains.proportional;
    if (gains.form == PidForm::Parallel) {
        return Terms{K, gains.integral, gains.derivative};
    }
    if (gains.integral == 0.0) {
        return failure(ErrorCode::InvalidInput, "an integral time of zero is an infinite integral gain",
                       "no integral action is an infinite integral time");
    }
    const double ki = K / gains.integral;
    const double kd = K * gains.derivative;
    if (gains.form == PidForm::Standard) {
        return Terms{K, ki, kd};
    }
    // (1 + 1/(T_i s))(1 + T_d s) = 1 + T_d/T_i + 1/(T_i s) + T_d s
    return Terms{K * (1.0 + gains.derivative / gains.integral), ki, kd};
}

Result<PidGains> expressed(const Terms& terms, PidForm form) {
    PidGains result;
    result.form = form;
    if (form == PidForm::Parallel) {
        result.proportional = terms.kp;
        result.integral = terms.ki;
        result.derivative = terms.kd;
        return result;
    }
    if (terms.kp == 0.0) {
        if (terms.ki != 0.0 || terms.kd != 0.0) {
            return failure(ErrorCode::InvalidInput,
                           "a controller without proportional gain cannot be written with times",
                           "keep the parallel form");
        }
        result.integral = Never_s;
        return result;
    }
    const double integralTime_s = terms.ki == 0.0 ? Never_s : terms.kp / terms.ki;
    const double derivativeTime_s = terms.kd / terms.kp;
    result.proportional = terms.kp;
    result.integral = integralTime_s;
    result.derivative = derivativeTime_s;
    if (form == PidForm::Series && terms.ki != 0.0) {
        const double discriminant = 1.0 - 4.0 * derivativeTime_s / integralTime_s;
        if (discriminant < 0.0) {
            return failure(ErrorCode::InvalidInput,
                           "the series form has real zeros only, these gains have complex ones (T_i < 4 T_d)",
                           "keep the parallel or the standard form");
        }
        const double share = 0.5 * (1.0 + std::sqrt(discriminant)); // K_series/K
        result.proportional = terms.kp * share;
        result.integral = integralTime_s * share;
        result.derivative = derivativeTime_s / share;
    }
    return result;
}

double unitFactor(GainUnit from, GainUnit to) {
    if (from == to) {
        return 1.0;
    }
    return from == GainUnit::PerDegree ? 180.0 / Pi : Pi / 180.0;
}

} // namespace

std::string_view pidFormName(PidForm form) {
    switch (form) {
    case PidForm::Standard:
        return "standard";
    case PidForm::Series:
        return "series";
    case PidForm::Parallel:
        break;
    }
    return "parallel";
}

Result<PidGains> convert(const PidGains& gains, PidForm form, GainUnit unit) {
    if (!isFinite(gains)) {
        return failure(ErrorCode::NotFinite, "a gain is not a finite number");
    }
    Result<PidGains> result = gains;
    if (form != gains.form) {
        const auto terms = parallelTerms(gains);
        if (!terms) {
            return failure(terms.error());
        }
        result = expressed(*terms, form);
        if (!result) {
            return result;
        }
    }
    const double factor = unitFactor(gains.unit, unit);
    result->unit = unit;
    result->filter_s = gains.filter_s;
    result->proportional *= factor;
    if (form == PidForm::Parallel) {
        result->integral *= factor;
        result->derivative *= factor;
    }
    return result;
}

} // namespace halbench::control
