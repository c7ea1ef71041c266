#pragma once

#include "app/analyses/analysis.h"
#include "app/headless/command_context.h"

namespace halbench::app {

/// Progress bar, interruption and clock of an analysis that runs under the command line; the context must
/// outlive it.
AnalysisControl analysisControl(CommandContext& context, const Analysis& analysis);

} // namespace halbench::app
