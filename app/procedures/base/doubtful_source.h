#pragma once

#include "app/procedures/base/procedure.h"

#include <vector>

namespace halbench::app {

// A result that rests on a doubtful one is doubtful too: these findings carry the doubt from a measurement to
// the loops that are judged with it. None where the measurement is good. (A refused one is not used at all.)

std::vector<Finding> doubtsOfModel(const DataQuality& quality);
std::vector<Finding> doubtsOfCalibration(const DataQuality& quality);
std::vector<Finding> doubtsOfRelay(const DataQuality& quality);

/// Adds them; the verdict is at best doubtful then.
void addDoubts(DataQuality& quality, const std::vector<Finding>& doubts);

/// The verdict of a design that was applied: a verification that was not good makes it doubtful, with the
/// findings that say why.
void addVerification(DataQuality& quality, const DataQuality& verification);

} // namespace halbench::app
