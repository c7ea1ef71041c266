#pragma once

#include "app/cli/identify_options.h"
#include "app/headless/command_context.h"
#include "app/procedures/relay/relay_procedure.h"

namespace halbench::app {

/// Options of `identify --relay` without it, and others with it. Error: Usage, naming one.
Result<void> checkRelayOptions(const IdentifyOptions& options);

/// Errors: Usage, NotFinite, naming the option; of the model's file. Ranges are the procedure's.
Result<RelayConfig> relayConfigFrom(const IdentifyOptions& options);

/// Plan of the experiment as text, before anything moves.
std::string relayPlanText(const RelayPlan& plan);

/// identify DEVICE --relay
CommandResult runRelayCommand(CommandContext& context, const IdentifyOptions& options);

} // namespace halbench::app
