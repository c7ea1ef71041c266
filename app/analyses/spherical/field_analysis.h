#pragma once

#include "app/analyses/analysis.h"

namespace halbench::app {

/// "field": the rotor's flux density on a circle about its shaft, with and without further harmonics.
Analysis fieldAnalysis();

} // namespace halbench::app
