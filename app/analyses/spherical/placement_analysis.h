#pragma once

#include "app/analyses/analysis.h"

namespace halbench::app {

/// `halbench place`: search for the places of sensors 1 and 2, with the Pareto table and the proof of the
/// winner. Source: resources/help/spherical-theory.md section 6.
Analysis placementAnalysis();

} // namespace halbench::app
