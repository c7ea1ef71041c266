#pragma once

#include "app/analyses/analysis_plot.h"
#include "app/analyses/spherical/estimator_comparison.h"

#include <string>
#include <vector>

namespace halbench::app {

/// Poses of a comparison along a trajectory, true and estimated: the three angles and the errors over the
/// sample, and the path of the shaft seen along Z. Of all estimators the angles and the path show the one
/// for this device, 'refined' or for the additive model 'closed', and the published search 'swarm'. No plots
/// without kept poses. Source:
/// resources/help/spherical-theory.md sections 9 and 10, figures 8, 12 and 15.
std::vector<AnalysisPlot> trajectoryPlots(const EstimatorComparison& comparison,
                                          models::SphericalDevice device, const std::string& name);

/// "time per pose: tensor 0.21 us, ...; published 1.27 to 1.58 s"; empty where nothing was timed.
std::string timingText(const EstimatorComparison& comparison);

} // namespace halbench::app
