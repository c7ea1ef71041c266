#pragma once

#include "app/headless/command_context.h"
#include "app/procedures/frequency/frequency_procedure.h"

namespace halbench::app {

/// `identify` has two kinds of options: those of the sweep and those of --frequency. Errors: Usage, naming
/// one that belongs to the other kind.
Result<void> checkFrequencyOptions(const CommandOptions& options);

/// Errors: Usage, UnknownName, NotFinite, naming the option. Ranges are the procedure's.
Result<FrequencyConfig> frequencyConfigFrom(const CommandOptions& options);

/// identify DEVICE --frequency
CommandResult runFrequencyCommand(CommandContext& context, const CommandOptions& options);

} // namespace halbench::app
