#pragma once

#include "app/procedures/base/procedure.h"

#include <string>
#include <vector>

namespace halbench::app {

/// Whether a judgement of a loop takes something for granted that nobody measured
/// (resources/help/tuning.md, "Warnings").
bool restsOnAssumption(const std::vector<Finding>& findings);

/// Whether a stable loop is close to its limit of stability: little margin or damping, or unstable with one
/// more sample of delay. No such loop is called good.
bool isNearStabilityLimit(const std::vector<Finding>& findings);

/// The verdict on a loop in words, the same on the command line and in the window: one that rests on an
/// assumption or near the limit says so. `isRobustnessKnown`: the uncertainty of the motor was judged too.
std::string loopVerdict(Verdict verdict, const std::vector<Finding>& findings, bool isRobustnessKnown);

} // namespace halbench::app
