#pragma once

#include "control/base/result.h"
#include "control/law/law_run.h"
#include "control/law/pid.h"
#include "control/law/position_loop.h"
#include "control/lti/transfer_function.h"

#include <cstddef>
#include <variant>
#include <vector>

namespace halbench::control {

/// The figures of `filters.h`, one struct a kind.
struct LeadFilter {
    double frequency_rad_s = 0.0;
    double phase_deg = 0.0;

    bool operator==(const LeadFilter&) const = default;
};
struct LagFilter {
    double frequency_rad_s = 0.0;
    double ratio = 1.0;

    bool operator==(const LagFilter&) const = default;
};
struct NotchFilter {
    double frequency_rad_s = 0.0;
    double depth_ratio = 0.0;
    double damping_ratio = 0.0;

    bool operator==(const NotchFilter&) const = default;
};
struct LowPassFilter {
    double corner_rad_s = 0.0;
    int order = 1;

    bool operator==(const LowPassFilter&) const = default;
};
/// One that is given as it runs, at the period of the loop.
struct SectionFilter {
    LawSection<double> section;

    bool operator==(const SectionFilter&) const = default;
};
using LoopFilter = std::variant<LeadFilter, LagFilter, NotchFilter, LowPassFilter, SectionFilter>;

/// A controller with two inputs: r the reference, y the measured angle, and F the filters in series:
///     u = F [ K_P (b r - y) + I (r - y) + D (c r - y) ],   I = T_s K_I/(z - 1)
/// D is the derivative with the filter `gains.filter_s` = T_f by the backward difference,
///     D = K_D (z - 1)/((T_s + T_f) z - T_f):
/// with T_f = 0 it is the difference of the board's law, and its pole T_f/(T_s + T_f) is never negative,
/// where Tustin's would ring at every T_f < T_s/2. The filters are taken over by Tustin, pre-warped at their
/// own frequency: there they do what they are for, and no stable filter becomes an unstable one. The default
/// weights are those of the board, which sees no speed of a reference that jumps.
struct FilteredLaw {
    PidGains gains;                  ///< of any form; `filter_s` counts
    double proportionalWeight = 1.0; ///< b
    double derivativeWeight = 0.0;   ///< c
    std::vector<LoopFilter> filters;

    bool operator==(const FilteredLaw&) const = default;
};

/// In series: margins are computed of so many and no more, and boards have as many sections at most. Of four
/// equal filters roots keep 1e-4 of their place, of six narrow notches near Nyquist some left the unit circle
/// by rounding alone.
constexpr std::size_t MostFilters = 4;

/// Whether the plain law is all of it.
bool isBoardLaw(const FilteredLaw& law);

/// The gains of a checked law: parallel form, per radian, with their filter. Errors: NotFinite; OutOfRange (a
/// weight outside 0 ... 1, a filter that is not possible or not below Nyquist or too slow, more than four);
/// InvalidInput (a form that cannot be expressed; b < 1 without integral action, which would leave the motor
/// at b times the reference).
Result<PidGains> checkedGains(const FilteredLaw& law, double period_s);

/// One filter before it is sampled, and the frequency that keeps its place then; a section has neither.
Result<TransferFunction> continuousFilter(const LoopFilter& filter);
double frequencyOf_rad_s(const LoopFilter& filter);
/// Errors: OutOfRange (a figure, a frequency not below Nyquist or too slow, a section that is not stable).
Result<TransferFunction> sampledFilter(const LoopFilter& filter, double period_s);

/// F alone.
Result<TransferFunction> filtersInSeries(const std::vector<LoopFilter>& filters, double period_s);

/// From the error of the angle to the current, F (K_P + I + D): what decides stability and margins.
Result<TransferFunction> filteredController(const FilteredLaw& law, double period_s);
/// From the reference to the current, F (b K_P + I + c D).
Result<TransferFunction> filteredReferencePath(const FilteredLaw& law, double period_s);

/// Controller, delay and held plant in series. Errors of all: of the inputs.
Result<TransferFunction> filteredOpenLoop(const PositionPlant& plant, const FilteredLaw& law,
                                          const LoopTiming& timing);
/// From the reference to the angle at the samples.
Result<TransferFunction> filteredClosedLoop(const PositionPlant& plant, const FilteredLaw& law,
                                            const LoopTiming& timing);

} // namespace halbench::control
