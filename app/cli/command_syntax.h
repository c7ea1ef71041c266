#pragma once

#include "app/headless/command_options.h"

#include <CLI/CLI.hpp>

namespace halbench::app {

// The parts of the command line's syntax, each for one kind of command.

/// A command that understands the global options behind its name too.
CLI::App* addCommand(CLI::App& app, const char* name, const char* help);

/// An option that names a recording to be written: .csv, and nothing stands there that is no file.
CLI::Option* addRecordingOut(CLI::App* command, const char* name, std::string& path, const char* help);

/// Commands that work on recordings: convert, spectrum, plot, import, recordings, overlay.
void addRecordingCommands(CLI::App& app, CommandOptions& options);

/// The commands of the table of analyses, with their keys as options.
void addAnalysisCommands(CLI::App& app, CommandOptions& options);

} // namespace halbench::app
