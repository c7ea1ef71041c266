#pragma once

#include "app/analyses/analysis.h"

namespace halbench::app {

/// `halbench estimators`: every estimator on the same poses of a chosen device: errors and failures, so that
/// models are crossed. Source: resources/help/spherical-theory.md sections 4, 5, 7 and 9.
Analysis estimatorAnalysis();

} // namespace halbench::app
