#pragma once

#include "app/analyses/analysis_plot.h"
#include "widgets/figure/figure.h"

#include <vector>

namespace halbench::app {

/// Figure of one plot of an analysis, for a report.
widgets::Figure analysisFigure(const AnalysisPlot& plot);

/// One picture of the first plot with the panels of those that share its horizontal axis. Precondition: there
/// is a plot.
widgets::Figure analysisPicture(const std::vector<AnalysisPlot>& plots);

} // namespace halbench::app
