#include "app/cli/command_support.h"

#include "app/documents/configuration_comparison.h"
#include "app/documents/result_header.h"
#include "app/documents/text/output_file.h"
#include "app/procedures/tune/loop_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

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

ExitCode exitCodeFor(const DataQuality& quality) {
    return quality.verdict == Verdict::Refused ? ExitCode::CheckFailed : ExitCode::Done;
}

namespace {

std::string linesOf(const std::vector<Finding>& findings) {
    std::string text;
    for (const Finding& finding : findings) {
        text += fmt::format("  {}: {}; {}\n", finding.code, finding.message, finding.hint);
    }
    return text;
}

struct UnitSuffix {
    std::string_view suffix, unit;
};
/// An ending that is the end of another one comes after it.
constexpr std::array UnitSuffixes = {
    UnitSuffix{"_rad_s", "rad/s"}, UnitSuffix{"_rad", "rad"}, UnitSuffix{"_degC", "degC"},
    UnitSuffix{"_deg", "deg"},     UnitSuffix{"_ratio", ""},  UnitSuffix{"_percent", "%"},
    UnitSuffix{"_A", "A"},         UnitSuffix{"_s", "s"},
};

std::string figureLine(std::string name, const JsonValue& value) {
    std::string_view unit;
    for (const UnitSuffix& known : UnitSuffixes) {
        if (name.size() > known.suffix.size() && std::string_view(name).ends_with(known.suffix)) {
            unit = known.unit;
            name.resize(name.size() - known.suffix.size());
            break;
        }
    }
    std::replace(name.begin(), name.end(), '_', ' ');
    if (!value.isNumber()) {
        return fmt::format("  {:<24} none\n", name);
    }
    return fmt::format("  {:<24} {:.6g}{}{}\n", name, value.number(), unit.empty() ? "" : " ", unit);
}

} // namespace

std::string findingLines(const DataQuality& quality) {
    return fmt::format("data quality: {}\n", verdictName(quality.verdict)) + linesOf(quality.findings);
}

std::string loopFindingLines(const DataQuality& quality, bool isRobustnessKnown) {
    return loopVerdict(quality.verdict, quality.findings, isRobustnessKnown) + '\n' +
           linesOf(quality.findings);
}

Result<void> refuseGiven(std::initializer_list<NamedOption> options, const char* message, const char* hint) {
    for (const NamedOption& named : options) {
        if (named.isGiven) {
            return failure(ErrorCode::Usage, fmt::format("{} {}", named.option, message), hint);
        }
    }
    return {};
}

std::string figureLines(std::string_view heading, const JsonValue& figures) {
    std::string text = fmt::format("{}\n", heading);
    for (const JsonMember& figure : figures.members()) {
        if (figure.value.isNumber() || figure.value.isNull()) {
            text += figureLine(figure.key, figure.value);
        }
    }
    return text;
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

Result<void> checkStore(const CommandOptions& options, const devices::Device& device) {
    if (!options.isSaved || !device.info().isSimulated) {
        return {};
    }
    return failure(ErrorCode::Usage,
                   "--save: a simulated device is new in every process and has nothing to store in",
                   "keep one running with 'halbench serve " + options.device + " --tcp 127.0.0.1:0'");
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

} // namespace halbench::app
