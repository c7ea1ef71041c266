#pragma once

#include "app/analyses/analysis.h"

namespace halbench::app {

/// `halbench readings`: the nine readings of ideal sensors along one angle, as the published figures show
/// them. Source: resources/help/spherical-theory.md sections 4 and 10.
Analysis readingsAnalysis();

} // namespace halbench::app
