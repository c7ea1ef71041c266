#pragma once

#include "app/cli/command.h"

#include <string>
#include <vector>

namespace halbench::app {

/// A command line as the user wrote it.
struct CommandLine {
    GlobalOptions global;
    std::string command; ///< "get"; "version", "help" for --version and --help or no arguments
    std::function<CommandResult(CommandContext&)> run; ///< none of "version" and "help"
    CommandOutputs outputs;
    std::string helpText;
};

/// Options that count before the others are read: whether --json was asked for, colours, terminal.
ConsoleStyle styleFromArguments(const std::vector<std::string>& arguments);

/// Errors: Usage, naming what was not understood.
Result<CommandLine> parseCommandLine(const std::vector<std::string>& arguments);

} // namespace halbench::app
