#include "control/law/pid.h"

#include "control/base/units.h"

#include <cmath>

namespace halbench::control {

namespace {

constexpr double Never_s = std::numeric_limits<double>::infinity();

bool isFinite(const PidGains& gains) {
    const bool isIntegralFine =
        std::isfinite(gains.integral) || (gains.form != PidForm::Parallel && gains.integral == Never_s);
    return std::isfinite(gains.proportional) && isIntegralFine && std::isfinite(gains.derivative) &&
           (!gains.filter_s || (std::isfinite(*gains.filter_s) && *gains.filter_s >= 0.0));
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
        return failure(ErrorCode::InvalidInput, "an integral time of zero means an infinite integral gain",
                       "without integral action the integral time is infinite");
    }
    const double ki = K / gains.integral;
    const double kd = K * gains.derivative;
    if (gains.form == PidForm::Standard) {
        return Terms{K, ki, kd};
    }
    // (1 + 1/(T_i s))(1 + T_d s/(1 + T_f s)) = 1 + T_d/T_i + 1/(T_i s) + T_d (1 - T_f/T_i) s/(1 + T_f s)
    const double filterShare = gains.filter_s.value_or(0.0) / gains.integral;
    return Terms{K * (1.0 + gains.derivative / gains.integral), ki, kd * (1.0 - filterShare)};
}

/// K + K T_d/T_i = K_P, K/T_i = K_I, K T_d (1 - T_f/T_i) = K_D: a quadratic equation in K.
Result<PidGains> expressedInSeries(const Terms& terms, double filter_s, PidGains result) {
    const double c = terms.ki * filter_s;
    const double square = (terms.kp - c) * (terms.kp - c) - 4.0 * terms.kd * terms.ki;
    if (square < 0.0) {
        return failure(ErrorCode::InvalidInput,
                       "the series form has real zeros only, these gains have complex ones (T_i < 4 T_d)",
                       "use the parallel or the standard form");
    }
    const double root = std::copysign(std::sqrt(square), terms.kp - c);
    const double K = 0.5 * (terms.kp + c + root);
    result.proportional = K;
    result.integral = K / terms.ki;
    result.derivative = terms.kd == 0.0 ? 0.0 : terms.kd / (K - c);
    return result;
}

Result<PidGains> expressed(const Terms& terms, PidForm form, double filter_s) {
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
                           "without proportional gain the time-constant forms do not exist",
                           "use the parallel form");
        }
        result.integral = Never_s;
        return result;
    }
    if (form == PidForm::Series && terms.ki != 0.0) {
        return expressedInSeries(terms, filter_s, result);
    }
    result.proportional = terms.kp;
    result.integral = terms.ki == 0.0 ? Never_s : terms.kp / terms.ki;
    result.derivative = terms.kd / terms.kp;
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
        result = expressed(*terms, form, gains.filter_s.value_or(0.0));
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

Result<TransferFunction> continuousController(const PidGains& gains) {
    const auto parallel = convert(gains, PidForm::Parallel, GainUnit::PerRadian);
    if (!parallel) {
        return failure(parallel.error());
    }
    // (K_P s + K_I)(1 + T_f s) + K_D s^2 over s (1 + T_f s); without integral action s cancels.
    const double kp = parallel->proportional;
    const double ki = parallel->integral;
    const double filter_s = parallel->filter_s.value_or(0.0);
    if (ki == 0.0) {
        return TransferFunction::make({kp * filter_s + parallel->derivative, kp}, {filter_s, 1.0},
                                      TimeBase::continuous());
    }
    return TransferFunction::make({kp * filter_s + parallel->derivative, kp + ki * filter_s, ki},
                                  {filter_s, 1.0, 0.0}, TimeBase::continuous());
}

} // namespace halbench::control
