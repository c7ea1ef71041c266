#pragma once

#include "app/analyses/analysis.h"
#include "app/cli/command.h"

#include <vector>

namespace halbench::app {

/// All commands, in the order of the help. Each call makes new ones, whose options are not filled in yet.
std::vector<Command> allCommands();

// Each with its options, in the source of its name; several that belong together share one.
Command devicesCommand();    // commands_inspect.cpp
Command describeCommand();   // commands_inspect.cpp
Command getCommand();        // commands_values.cpp
Command setCommand();        // commands_values.cpp
Command configCommand();     // commands_config.cpp
Command recordCommand();     // commands_record.cpp
Command moveCommand();       // commands_move.cpp
Command calibrateCommand();  // commands_calibrate.cpp
Command identifyCommand();   // commands_identify.cpp
Command tuneCommand();       // commands_tuning.cpp
Command analyseCommand();    // commands_analyse.cpp
Command runCommand();        // commands_run.cpp
Command serveCommand();      // commands_serve.cpp
Command convertCommand();    // commands_convert.cpp
Command spectrumCommand();   // commands_spectrum.cpp
Command plotCommand();       // commands_plot.cpp
Command importCommand();     // commands_import.cpp
Command recordingsCommand(); // commands_recordings.cpp
Command overlayCommand();    // commands_overlay.cpp
/// The command of a row of the table of analyses, with its keys as options.
Command analysisCommand(const Analysis& analysis); // commands_analysis.cpp

} // namespace halbench::app
