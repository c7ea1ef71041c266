#pragma once

#include "app/analyses/analysis.h"

namespace halbench::app {

/// "differences": the published criteria of placement over a lattice of places, with every reduction over the
/// poses, the places that are best and the rank of the published one.
Analysis differencesAnalysis();

} // namespace halbench::app
