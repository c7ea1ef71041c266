#pragma once

#include "control/base/result.h"

#include <string>
#include <vector>

namespace halbench::app {

/// Files that a command would write, as its options name them; an empty name is an output that is not asked
/// for.
struct CommandOutputs {
    std::vector<std::string> files;
    std::vector<std::string> recordings; ///< a .csv has a sidecar beside it
    /// Files that the command reads, where it says itself that it would replace one of them.
    std::vector<std::string> inputs = {};
    std::string folder = {}; ///< of the results of `run`
};

/// Every file that would be written, with the sidecars of recordings; not the folder.
std::vector<std::string> writtenFiles(const CommandOutputs& outputs);

/// Nothing is overwritten without --force, two results never share a file, and a folder that holds something
/// else than the results of a run takes none at all; asked before anything is measured. Error: Usage, naming
/// the file.
Result<void> checkOutputs(const CommandOutputs& outputs, bool mayOverwrite);

} // namespace halbench::app
