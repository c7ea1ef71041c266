#pragma once

#include "app/analyses/analysis.h"

namespace halbench::app {

/// All analyses of all actuators, in the order of the help.
const std::vector<Analysis>& analyses();
/// nullptr when there is none of this name.
const Analysis* findAnalysis(std::string_view name);

} // namespace halbench::app
