#pragma once

#include "app/procedures/apply/apply_axes.h"
#include "app/procedures/tune/tune_axes.h"

#include <string>

namespace halbench::app {

/// Gains and what they promise, axis by axis, for people.
std::string axisGainsText(const TuneAxesResult& result);
/// The same of an analysis, without the gains.
std::string axisAnalysisText(const TuneAxesResult& result);

/// How the verification of each axis agreed with its prediction, and the verdict of the whole command.
std::string appliedAxesText(const ApplyAxesResult& result, Verdict verdict);

} // namespace halbench::app
