#pragma once

#include "app/analyses/analysis.h"

namespace halbench::app {

/// `halbench orient`: orientation of the spherical rotor from a recording of nine field readings, by any
/// estimator, with the uncertainty of every pose; compared with the true angles when asked. Source:
/// resources/help/spherical-theory.md sections 5 and 7.
Analysis orientationAnalysis();

} // namespace halbench::app
