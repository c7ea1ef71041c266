#pragma once

#include "app/recordings/run_comparison.h"
#include "widgets/figure/figure.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halbench::app {

/// What of the runs is drawn, and how.
struct OverlayView {
    std::string signal;
    RunAlignment alignment;
    widgets::Axis y;
    double factor = 1.0;                             ///< from SI to the unit of `y`
    std::optional<std::pair<double, double>> span_s; ///< of the time since the moment; absent: all
    std::size_t columns = 2000;                      ///< stretches of which the extremes are kept
};

/// One curve a run over the time since the moment, thinned to the extremes of equal stretches: no spike is
/// lost. Runs without the moment, or without the signal in that span, are left out. Linear in the rows of the
/// span.
widgets::Figure overlayFigure(const std::vector<ComparedRun>& runs, const OverlayView& view);

} // namespace halbench::app
