#pragma once

#include "control/base/result.h"

#include <string>
#include <vector>

namespace halbench::app {

/// Files that a command would write, as its options name them; an empty name is an output that is not asked
/// for.
struct CommandOutputs {
    std::vector<std::string> files;
    std::vector<std::string> recordings;  ///< a .csv has a sidecar beside it
    std::string folder = {};              ///< of the results of `run`
    std::vector<std::string> inputs = {}; ///< that are there, as namedInputs() finds them
};

/// Every file that would be written, with the sidecars of recordings; not the folder.
std::vector<std::string> writtenFiles(const CommandOutputs& outputs);

/// Files that are there and that the values of a command line name, apart from the outputs themselves: a
/// path, the file of an address (replay:FILE, ?a2l=FILE), of an assignment or of a reference
/// (table,file=FILE). A recording comes with its sidecar.
std::vector<std::string> namedInputs(const CommandOutputs& outputs, std::vector<std::string> values);

/// Results never take the place of a file that they are made of, whatever its other name is and whatever
/// --force says. A run writes no .toml; any other file in its folder may be replaced. Error: Usage, naming
/// it.
Result<void> checkKeepsInputs(const CommandOutputs& outputs);

/// Inputs stay as they are, nothing else is overwritten without --force, two results never share a file, and
/// a folder that holds something else than the results of a run takes none at all; asked before anything is
/// measured. Error: Usage, naming the file.
Result<void> checkOutputs(const CommandOutputs& outputs, bool mayOverwrite);

} // namespace halbench::app
