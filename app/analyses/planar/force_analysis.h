#pragma once

#include "app/analyses/analysis.h"

namespace halbench::app {

/// `halbench forces`: force constants of the coil models, the errors of the published model against a device
/// of another one, and the published numbers recomputed. Source: resources/help/planar-theory.md sections 5
/// and 10.
Analysis forceAnalysis();

} // namespace halbench::app
