#pragma once

#include "app/batch/command_context.h"

namespace halbench::app {

// One function a command; each prints its result and returns the exit code or what stopped it.
CommandResult runDevicesCommand(CommandContext& context, const CommandOptions& options);
CommandResult runDescribeCommand(CommandContext& context, const CommandOptions& options);
CommandResult runGetCommand(CommandContext& context, const CommandOptions& options);
CommandResult runSetCommand(CommandContext& context, const CommandOptions& options);

} // namespace halbench::app
