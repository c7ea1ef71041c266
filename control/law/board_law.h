#pragma once

#include "control/law/filtered_law.h"
#include "control/law/law_run.h"
#include "control/law/position_loop.h"

#include <complex>
#include <vector>

namespace halbench::control {

/// A reference that the position law follows, with its speed and acceleration.
template <typename Number>
struct LawReference {
    Number value_rad = Number(0);
    Number speed_rad_s = Number(0);
    Number acceleration_rad_s2 = Number(0);
};
using ReferencePoint = LawReference<double>;

/// The position law of a board as its parameters state it. The two literal forms are demonstrations
/// (resources/help/htm-theory.md 6.6); they know K_P and the limit alone.
template <typename Number>
struct BoardLaw {
    enum class Form { Positional, LiteralDifference, LiteralClampedMemory };
    Form form = Form::Positional;
    Number kp_A_per_rad = Number(10);
    Number ki_A_per_rad_s = Number(0.1);
    Number kd_As_per_rad = Number(0);
    Number referenceWeight = Number(1);           ///< b
    Number derivativeReferenceWeight = Number(0); ///< c
    Number derivativeFilter_s = Number(0);        ///< T_f
    std::vector<LawSection<Number>> sections;     ///< F
    Number inertia_As2_per_rad = Number(0);
    Number viscous_As_per_rad = Number(0);
    Number coulomb_A = Number(0);
    Number coulombSpeed_rad_s = Number(0.02);
    Number stiction_A = Number(0);
    Number stictionThreshold_rad = Number(0);
    Number stictionSpeed_rad_s = Number(0.02);
    Number limit_A = Number(4);
    Number period_s = Number(0.01);
    int delaySamples = 0; ///< between the sample and its current; 2 at most on a board

    LawEquation<Number> equation() const {
        return {kp_A_per_rad,       ki_A_per_rad_s, kd_As_per_rad, referenceWeight, derivativeReferenceWeight,
                derivativeFilter_s, period_s,       sections};
    }

    bool operator==(const BoardLaw&) const = default;
};

using SampledPositionLaw = BoardLaw<double>;

/// The law that a board runs for these gains, weights and filters; `extras` are the parts of the law beside
/// its gains. Errors: of `checkedGains` and `checkTiming`; OutOfRange (the limit).
Result<BoardLaw<double>> boardLaw(const FilteredLaw& law, const PositionLaw& extras, const LoopTiming& timing,
                                  double currentLimit_A);

/// The gains, weights and filters of a board's law: the inverse. Filters have their names where they have one
/// (`namedFilter`).
FilteredLaw filteredLaw(const BoardLaw<double>& law);

/// From the error of the angle to the current, F (K_P + I + D), without the delay.
std::complex<double> feedbackResponse(const BoardLaw<double>& law, double frequency_rad_s);
/// What friction and integral see at rest: K_P times the gain of the filters for a constant.
double proportionalAtRest_A_per_rad(const BoardLaw<double>& law);

} // namespace halbench::control
