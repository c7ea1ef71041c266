#pragma once

#include "control/analysis/margins.h"

#include <optional>
#include <utility>
#include <vector>

namespace halbench::control {

/// An open loop that was measured: each point with the radius of its circle of confidence.
struct MeasuredLoop {
    FrequencyResponse response;
    std::vector<double> radius; ///< one a point, of the same confidence
};

/// A margin that was measured, or why it is not known.
struct MeasuredMargin {
    enum class Withheld {
        No,
        NoCrossing, ///< the loop crosses nowhere between the measured points
        Gap,        ///< it crosses where neighbours are too far apart to be joined
        Uncertain   ///< its interval is wider than allowed
    };
    Withheld withheld = Withheld::NoCrossing;
    std::optional<double> frequency_rad_s;             ///< where it crosses
    std::optional<double> value;                       ///< absent when withheld
    std::optional<std::pair<double, double>> interval; ///< also of an uncertain one
};

struct MeasuredMargins {
    MeasuredMargin phase_deg;
    MeasuredMargin gain_dB;
    std::vector<Crossing> crossings;
};

/// Largest half widths of an interval that is still told.
struct MarginTolerance {
    double phase_deg = 2.0;
    double gain_dB = 1.0;
};

/// The smallest margins on the measured points, each with its interval. With rho = radius/|L| at the crossing
/// and the slopes m = dln|L|/dln w, f = dphase/dln w there, an error of ln L within a circle of rho moves the
/// crossing too: the phase margin by at most rho sqrt(1 + (f/m)^2), the logarithm of the gain margin by at
/// most rho sqrt(1 + (m/f)^2). What straight lines between the points miss, an eighth of the change of slope
/// times their distance, is added to rho. Help: resources/help/htm-theory.md 7.6.
MeasuredMargins measuredMargins(const MeasuredLoop& loop, const MarginTolerance& tolerance);

} // namespace halbench::control
