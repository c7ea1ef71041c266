#pragma once

#include "app/headless/command_context.h"

#include <string>

namespace halbench::app {

/// Options of `recordings`.
struct RecordingsOptions {
    std::string input; ///< FOLDER
    std::string search;
    std::string retain; ///< the next line only with it
    bool isDeleted = false, isTrashed = false;
};

/// `recordings --retain`: what is beyond the limits, and with --delete or --trash its removal.
CommandResult runRetentionCommand(CommandContext& context, const RecordingsOptions& options);

} // namespace halbench::app
