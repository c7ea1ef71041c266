#pragma once

#include "app/headless/command_options.h"

#include <string>
#include <vector>

namespace halbench::app {

/// Every file that the command would write, with the sidecars of recordings; not the folder of `run`.
std::vector<std::string> outputsOf(const CommandLine& line);

/// Nothing is overwritten without --force, and a folder that holds something else than the results of a run
/// takes none at all; asked before anything is measured. Error: Usage, naming the file.
Result<void> checkOutputs(const CommandLine& line);

} // namespace halbench::app
