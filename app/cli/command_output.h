#pragma once

#include "app/documents/text/json_value.h"
#include "app/headless/command_context.h"

#include <string>

namespace halbench::app {

/// A result and how it is told.
struct CommandOutput {
    JsonValue document;
    std::string text;
    std::string out; ///< file that the user wants it in; empty: none
};

/// An error of writing a file that says which file it was, also where its folder was the obstacle.
Result<void> namingFile(const std::string& path, Result<void> written);

/// Ends a command with `error`, a file beside its result that could not be written, which does not take with
/// it what was measured: that is in `out`, else it is printed, and under --json it is the `result` of the
/// error's document.
CommandResult endWithResult(CommandContext& context, const CommandOutput& result, const Error& error);

} // namespace halbench::app
