#pragma once

#include "app/analyses/analysis.h"
#include "app/headless/command_context.h"

namespace halbench::app {

// One function a command; each prints its result and returns the exit code or what stopped it.
CommandResult runDevicesCommand(CommandContext& context, const CommandOptions& options);
CommandResult runDescribeCommand(CommandContext& context, const CommandOptions& options);
CommandResult runGetCommand(CommandContext& context, const CommandOptions& options);
CommandResult runSetCommand(CommandContext& context, const CommandOptions& options);
CommandResult runConfigCommand(CommandContext& context, const CommandOptions& options);
CommandResult runRecordCommand(CommandContext& context, const CommandOptions& options);
CommandResult runMoveCommand(CommandContext& context, const CommandOptions& options);
CommandResult runCalibrateCommand(CommandContext& context, const CommandOptions& options);
CommandResult runIdentifyCommand(CommandContext& context, const CommandOptions& options);
CommandResult runTuneCommand(CommandContext& context, const CommandOptions& options);
CommandResult runAnalyseCommand(CommandContext& context, const CommandOptions& options);
CommandResult runRunCommand(CommandContext& context, const CommandOptions& options);
CommandResult runConvertCommand(CommandContext& context, const CommandOptions& options);
CommandResult runSpectrumCommand(CommandContext& context, const CommandOptions& options);
CommandResult runPlotCommand(CommandContext& context, const CommandOptions& options);
CommandResult runImportCommand(CommandContext& context, const CommandOptions& options);
CommandResult runRecordingsCommand(CommandContext& context, const CommandOptions& options);
CommandResult runRetentionCommand(CommandContext& context, const CommandOptions& options);
CommandResult runOverlayCommand(CommandContext& context, const CommandOptions& options);
CommandResult runServeCommand(CommandContext& context, const CommandOptions& options);
CommandResult runAnalysisCommand(CommandContext& context, const Analysis& analysis,
                                 const CommandOptions& options);

} // namespace halbench::app
