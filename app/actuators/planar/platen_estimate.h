#pragma once

#include "app/actuators/planar/platen_equations.h"
#include "app/procedures/identify/axes_identification.h"

namespace halbench::app {

/// A constant that the user knows, exact: the moving mass or the inertia about the vertical.
struct GivenPlaten {
    std::optional<double> mass_kg;
    std::optional<double> inertia_kg_m2;
};

/// Model of the chosen axes, constants and ratios with 95 % intervals, and the findings: contradictions
/// between the board's constants and the measured ones, what is not identifiable and what would fix it.
AxesIdentifyResult platenEstimate(const PlatenFit& fit, const PlatenBoard& board, const GivenPlaten& given,
                                  const std::vector<devices::AxisSpec>& axes, const MeasuredTiming& timing);

} // namespace halbench::app
