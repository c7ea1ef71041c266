#pragma once

#include "control/law/filtered_law.h"
#include "control/law/law_run.h"
#include "control/lti/delta_system.h"

namespace halbench::control {

// A filtered loop by the roots of its parts in d = z - 1, for margins, frequency responses and loci: one
// polynomial in z of slow filters beside integrators has no digits left at low frequency. All of it is put
// together from positive terms. The board's own law is one without filters.

/// A part of the loop, numerator over denominator in powers of d.
struct DeltaFactor {
    Polynomial numerator;
    Polynomial denominator;
};
/// By Tustin's rule, pre-warped at the filter's own frequency. Errors: of the filter.
Result<DeltaFactor> deltaFilter(const LoopFilter& filter, double period_s);
/// One section for each filter, as the law runs them. Errors: of a filter.
Result<std::vector<LawSection<double>>> filterSections(const std::vector<LoopFilter>& filters,
                                                       double period_s);
/// k T^2 (b1 d + b1 + b2)/(d (d + 1 - E)), the current held.
DeltaFactor deltaRotor(const PositionPlant& plant, double period_s);

/// F (K_P + I + D) of `filteredController`. Errors: of the law.
Result<DeltaSystem> deltaController(const FilteredLaw& law, double period_s);
/// The loop of `filteredOpenLoop`. Errors: of the inputs.
Result<DeltaSystem> deltaOpenLoop(const PositionPlant& plant, const FilteredLaw& law,
                                  const LoopTiming& timing);
/// Of the filters together for a constant input.
Result<double> filterGainAtRest(const std::vector<LoopFilter>& filters);

} // namespace halbench::control
