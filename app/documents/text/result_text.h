#pragma once

#include "app/documents/text/json_value.h"
#include "app/procedures/base/procedure.h"
#include "control/identify/joint_estimate.h"

#include <string>
#include <string_view>

namespace halbench::app {

/// Findings as lines for people.
std::string findingLines(const DataQuality& quality);

/// The same of a loop, with its verdict in the words of the window.
std::string loopFindingLines(const DataQuality& quality, bool isRobustnessKnown);

/// The numbers of a result for people: the heading, then one a line with six digits and the unit that its
/// name ends with ("rise_time_s"). What is no number but absent is "none"; of parts within it nothing.
std::string figureLines(std::string_view heading, const JsonValue& figures);

/// "c = 0.00123 N*m*s/rad  [0.0012, 0.00126]  identified"
std::string estimateLine(std::string_view name, const control::Estimate& estimate);

} // namespace halbench::app
