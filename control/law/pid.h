#pragma once

#include "control/base/result.h"
#include "control/lti/transfer_function.h"

#include <limits>
#include <optional>
#include <string_view>

namespace halbench::control {

/// How three numbers make a controller, e = error, s = derivative:
///   Parallel:  K_P + K_I/s + K_D s          proportional = K_P, integral = K_I, derivative = K_D
///   Standard:  K (1 + 1/(T_i s) + T_d s)    proportional = K,   integral = T_i, derivative = T_d
///   Series:    K (1 + 1/(T_i s))(1 + T_d s)  likewise
/// With a filter on the derivative, s stands for s/(1 + filter_s s) where K_D or T_d multiplies it; in the
/// series form that reaches into the other terms, and the conversion counts it in:
///   K_P = K (1 + T_d/T_i),  K_I = K/T_i,  K_D = K T_d (1 - filter_s/T_i).
enum class PidForm { Parallel, Standard, Series };

/// The angle unit a gain divides by; the published loop most likely mixed the two up
/// (resources/help/htm-theory.md, 6.7).
enum class GainUnit { PerRadian, PerDegree };

std::string_view pidFormName(PidForm form); ///< "parallel", "standard", "series"

/// Gains with everything needed to read them. In the time forms an infinite T_i means no integral action.
struct PidGains {
    PidForm form = PidForm::Parallel;
    GainUnit unit = GainUnit::PerRadian;
    double proportional = 0.0;
    double integral = 0.0;
    double derivative = 0.0;
    /// Time constant of the filter on the derivative; absent = backward difference over one sample.
    std::optional<double> filter_s;

    bool operator==(const PidGains&) const = default;
};

/// The one conversion between forms and units: the same controller in another notation.
/// Errors: NotFinite; InvalidInput when the target cannot express it (series: T_i < 4 T_d has complex zeros;
/// time forms: K = 0 with K_I or K_D not zero).
Result<PidGains> convert(const PidGains& gains, PidForm form, GainUnit unit);

/// The continuous controller, error to output, of any form. Errors: as of `convert`; InvalidInput for
/// derivative action without a filter (the board's difference has one of its own: `sampledController`).
Result<TransferFunction> continuousController(const PidGains& gains);

} // namespace halbench::control
