#pragma once

#include "control/identify/thermal_bins.h"

#include <optional>
#include <string_view>
#include <utility>

namespace halbench::control {

/// When a temperature reaches a limit if the load stays as it is.
///
/// A coil is taken as one body with a constant load, T' = s - b (T - T_now), so that
///   T(t) = T_now + s (1 - e^(-b t))/b  and  t_limit = -ln(1 - b (L - T_now)/s)/b.
/// T_now, s and b are fitted to the stretch of steady load (groups of its seconds, least squares in T_now and
/// s for each b). Nothing of the motor is assumed but copper: its resistance rises by kappa per kelvin, so
/// that b >= -kappa s, and b < 0 is a runaway. The interval is the union, over all b that the data do not
/// refuse at 95 %, of the 95 % intervals at that b: it covers at least as often. The variance of a group is
/// the larger of that of the residuals and of what the sensor's noise and step explain; neighbours that
/// follow each other, and a sensor whose steps no noise breaks up, make fewer groups of them.
struct LimitForecast {
    enum class Verdict {
        Reached,    ///< within `interval95_s`
        NotReached, ///< at this load it never is
        NotBefore,  ///< `earliest_s` at the earliest; whether at all is not known yet
        AtLimit,    ///< it is there
        Withheld    ///< `reason` says why
    };
    enum class Reason {
        None,
        TooShort,     ///< less than LeastStretch_s at one load
        NoStep,       ///< not by one step of its sensor
        NotFirstOrder ///< it does not go as one body at a constant load does
    };
    static constexpr double LeastStretch_s = 20.0;
    static constexpr double Longest_s = 86400.0; ///< what is farther away counts as never

    Verdict verdict = Verdict::Withheld;
    Reason reason = Reason::None;
    double now_degC = 0.0;
    double limit_degC = 0.0;
    double stretch_s = 0.0;                                ///< of steady load that it is from
    std::optional<double> time_s;                          ///< Reached: the likeliest
    std::optional<std::pair<double, double>> interval95_s; ///< Reached
    std::optional<double> earliest_s;                      ///< Reached, NotBefore
    std::optional<std::pair<double, double>> final95_degC; ///< NotReached: where it settles, if known
};

/// "reached", "not_reached", "not_before", "at_limit", "withheld"
std::string_view forecastVerdictName(LimitForecast::Verdict verdict);
/// "" or "too_short", "no_step", "not_first_order"
std::string_view forecastReasonName(LimitForecast::Reason reason);

/// `bins` oldest first, as atSteadyLoad() gives them.
LimitForecast forecastLimit(std::span<const ThermalBin> bins, double limit_degC);

} // namespace halbench::control
