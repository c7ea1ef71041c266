#pragma once

#include "app/actuators/actuator.h"
#include "app/cli/commands.h"
#include "app/documents/text/result_text.h"
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
Result<void> checkStore(const CommandOptions& options, const devices::Device& device);

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

/// The sweep, directions and given constants of `identify` as written on the command line, for the actuator
/// that is identified. Errors: Usage, UnknownName, NotFinite, OutOfRange, naming the option; FileSystem,
/// InvalidInput of --bare.
Result<IdentifyConfig> identifyConfigFrom(const CommandOptions& options, const Actuator& actuator);
/// The signals of --derive. Errors: InvalidInput, naming the option.
Result<std::vector<devices::DerivedSignal>> derivedOption(const std::vector<std::string>& texts);

std::string identificationText(const IdentifyOutcome& outcome);

} // namespace halbench::app
