#pragma once

#include "app/analyses/analysis.h"

namespace halbench::app {

/// `halbench coverage`: where in the workspace three sensors all read enough, with a proof or a
/// counterexample, and the angle error to expect. Source: resources/help/spherical-theory.md section 6.
Analysis coverageAnalysis();

} // namespace halbench::app
