#pragma once

#include "app/cli/command_syntax.h"
#include "app/documents/text/result_text.h"
#include "app/headless/command_context.h"
#include "devices/acquisition/derived_signals.h"

#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::app {

/// Writes a result where the user wants it: into `out` when it is not empty, else `text` or (under --json)
/// the document on stdout; under --json the document is on stdout in both cases.
Result<void> deliver(CommandContext& context, const JsonValue& document, const std::string& text,
                     const std::string& out);

/// Keeps what a device that is not simulated has before it is changed for good, and says where
/// (resources/help/command-line.md, "Configuration files"). Errors: FileSystem; then nothing may be changed.
Result<void> backUp(CommandContext& context, const devices::Device& device,
                    const std::map<std::string, double>& values);
/// The same with the values read first. Errors: also of the device.
Result<void> backUp(CommandContext& context, devices::Device& device);
/// --save needs a device that has something to store in. Error: Usage.
Result<void> checkStore(bool isSaved, const std::string& uri, const devices::Device& device);

/// FILE.csv, FILE.mf4 or replay:FILE; nothing for a device.
std::optional<std::string> recordingPath(const std::string& text);

/// Exit code of an estimate: 1 when it was refused.
ExitCode exitCodeFor(const DataQuality& quality);

/// An option and whether it stands on the command line.
struct NamedOption {
    const char* option;
    bool isGiven;
};
/// The first that is given is refused. Error: Usage.
Result<void> refuseGiven(std::initializer_list<NamedOption> options, const char* message, const char* hint);

/// --derive
void addDerive(CommandSyntax& syntax, std::vector<std::string>& derived);
/// The signals of --derive. Errors: InvalidInput, naming the option.
Result<std::vector<devices::DerivedSignal>> derivedOption(const std::vector<std::string>& texts);

/// --calibration
void addCalibration(CommandSyntax& syntax, std::string& path);

} // namespace halbench::app
