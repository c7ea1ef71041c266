#pragma once

#include "app/procedures/identify/identify_procedure.h"
#include "widgets/figure/figure.h"

#include <optional>

namespace halbench::app {

/// The pictures of an identification, in a report and in the window alike.

/// Plateaus of the sweep with the fitted line of each direction, residuals below; nothing without plateaus or
/// when the line was not decided.
std::optional<widgets::Figure> steadySpeedFigure(const IdentifyResult& result);

/// Joint 95 % region of c and K_f, else of c/phi and K_f/phi; nothing when the covariance holds neither.
struct JointRegion {
    widgets::Figure figure;
    double correlation = 0.0;
};
std::optional<JointRegion> jointRegion(const IdentifyResult& result);

} // namespace halbench::app
