#pragma once

#include "app/figures/loop_curves.h"

namespace halbench::app {

/// The z plane of the sampled loop: where the closed loop's poles are, and the ways on which they come there
/// from the open loop's and go on as the gain rises to RootLocusMost_ratio times the proposed. Of the other
/// loops only the poles.
widgets::Figure rootLocusFigure(const AnalysisResult& predicted, const std::optional<AnalysisResult>& present,
                                const std::vector<NamedLoop>& others = {});

} // namespace halbench::app
