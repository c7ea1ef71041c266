#pragma once

#include "app/procedures/identify/identify_estimate.h"

namespace halbench::app {

/// Findings about the line of steady speeds: outliers, lack of fit, runs of residuals, one plateau that
/// decides, and plateaus that contradict the rest of the motion (resources/help/identification.md section 5).
void judgeSteadyLine(IdentifyResult& result, const IdentifyFits& fits);

} // namespace halbench::app
