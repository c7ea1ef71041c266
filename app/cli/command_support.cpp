#include "app/cli/command_support.h"

#include "app/documents/configuration_comparison.h"
#include "app/documents/result_header.h"
#include "app/documents/text/output_file.h"
#include "devices/device_uri.h"
#include "devices/formats/recording_file.h"

#include <fmt/format.h>

#include <filesystem>

namespace halbench::app {

Result<void> deliver(CommandContext& context, const JsonValue& document, const std::string& text,
                     const std::string& out) {
    if (!out.empty()) {
        const Result<std::string> json = toJsonText(document);
        if (!json) {
            return failure(json.error());
        }
        if (const Result<void> written = writeFile(out, *json); !written) {
            return written;
        }
        context.console.log(LogLevel::Info, "wrote " + out);
    } else {
        context.console.print(text);
    }
    return context.console.printDocument(document);
}

std::optional<std::string> recordingPath(const std::string& text) {
    const Result<devices::DeviceUri> uri = devices::parseDeviceUri(text);
    if (!uri) {
        const bool isFile =
            std::filesystem::path(text).extension() == ".csv" || devices::isMdf4Recording(text);
        return isFile ? std::optional<std::string>(text) : std::nullopt;
    }
    return uri->scheme == "replay" ? std::optional<std::string>(uri->address) : std::nullopt;
}

ExitCode exitCodeFor(const DataQuality& quality) {
    return quality.verdict == Verdict::Refused ? ExitCode::CheckFailed : ExitCode::Done;
}

Result<void> refuseGiven(std::initializer_list<NamedOption> options, const char* message, const char* hint) {
    for (const NamedOption& named : options) {
        if (named.isGiven) {
            return failure(ErrorCode::Usage, fmt::format("{} {}", named.option, message), hint);
        }
    }
    return {};
}

Result<void> backUp(CommandContext& context, const devices::Device& device,
                    const std::map<std::string, double>& values) {
    if (device.info().isSimulated) {
        return {}; // new in every process: there is nothing to lose
    }
    const Configuration before = configurationOf(device.info(), device.catalogue(), values, wallTime());
    const Result<std::string> path = backUpConfiguration(before, backupFolder());
    if (!path) {
        return failure(path.error());
    }
    context.console.log(LogLevel::Info, "what the device had before is kept in " + *path);
    return {};
}

Result<void> backUp(CommandContext& context, devices::Device& device) {
    if (device.info().isSimulated) {
        return {};
    }
    const Result<std::map<std::string, double>> values = readSettings(device);
    if (!values) {
        return failure(values.error());
    }
    return backUp(context, device, *values);
}

Result<void> checkStore(bool isSaved, const std::string& uri, const devices::Device& device) {
    if (!isSaved || !device.info().isSimulated) {
        return {};
    }
    return failure(ErrorCode::Usage,
                   "--save: a simulated device is new in every process and has nothing to store in",
                   "keep one running with 'halbench serve " + uri + " --tcp 127.0.0.1:0'");
}

Result<std::vector<devices::DerivedSignal>> derivedOption(const std::vector<std::string>& texts) {
    std::vector<devices::DerivedSignal> list;
    for (const std::string& text : texts) {
        Result<devices::DerivedSignal> derived = devices::parseDerivedSignal(text);
        if (!derived) {
            const Error& error = derived.error();
            return failure(error.code, "--derive: " + error.message, error.hint);
        }
        list.push_back(*std::move(derived));
    }
    return list;
}

void addDerive(CommandSyntax& syntax, std::vector<std::string>& derived) {
    syntax.repeatable("--derive", derived,
                      "A signal computed from others, e.g. 'field = sqrt(hall.a^2 + hall.b^2)'; repeatable",
                      "'NAME [UNIT] = EXPRESSION'");
}

void addCalibration(CommandSyntax& syntax, std::string& path) {
    syntax.option("--calibration", path, "How well the stray field is known, from calibrate --out",
                  "CAL.json");
}

} // namespace halbench::app
