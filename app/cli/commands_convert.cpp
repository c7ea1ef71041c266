#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/documents/result_header.h"
#include "app/documents/text/names.h"
#include "app/documents/text/numbers.h"
#include "app/headless/command_header.h"
#include "app/headless/recording_integrity.h"
#include "devices/formats/convert_recording.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

struct ConvertOptions {
    std::string input, out;
    std::string signals; ///< names, separated by commas
    std::string from, to;
    std::vector<std::string> derived;
};

std::string recoveryText(const std::string& path, const devices::Recovery& recovery) {
    const std::string cut =
        recovery.cutOctets == 0
            ? std::string("nothing was cut off")
            : fmt::format("cut off: {} octets behind the last whole row", recovery.cutOctets);
    const std::string damaged =
        recovery.damagedOctets == 0
            ? std::string()
            : fmt::format("; left out: {} octets that are damaged", recovery.damagedOctets);
    const std::string unchecked =
        recovery.uncheckedRows == 0
            ? std::string()
            : fmt::format("; rows at its end without a checksum: {}", recovery.uncheckedRows);
    return fmt::format("recovered {} rows ({} s) of {}; {}{}{}", recovery.rows,
                       formatNumber(recovery.duration_s), path, cut, damaged, unchecked);
}

JsonValue toJson(const devices::Recovery& recovery) {
    JsonValue document = JsonValue::object();
    document.set("rows", static_cast<std::uint64_t>(recovery.rows)).set("duration_s", recovery.duration_s);
    document.set("cut_octets", recovery.cutOctets).set("damaged_octets", recovery.damagedOctets);
    return document.set("unchecked_rows", static_cast<std::uint64_t>(recovery.uncheckedRows));
}

CommandResult runConvertCommand(CommandContext& context, const ConvertOptions& options) {
    const Result<std::optional<double>> from = optionalNumber("--from", options.from);
    const Result<std::optional<double>> to = optionalNumber("--to", options.to);
    if (!from || !to) {
        return failure(from ? to.error() : from.error());
    }
    Result<std::vector<devices::DerivedSignal>> derived = derivedOption(options.derived);
    if (!derived) {
        return failure(derived.error());
    }
    const devices::ConvertRequest request{options.input, options.out, splitList(options.signals),
                                          *from,         *to,         *std::move(derived)};
    const Result<devices::Conversion> done =
        devices::convertRecording(request, [&context] { return checkInterrupt(context); });
    if (!done) {
        return failure(done.error());
    }
    sayWarnings(context, done->warnings);
    if (done->recovery) {
        context.console.log(LogLevel::Info, recoveryText(options.input, *done->recovery));
    }
    context.console.log(LogLevel::Info, fmt::format("wrote {} ({} rows)", options.out, done->rows));
    ResultHeader header = headerFor(context, "halbench.conversion/1");
    noteWarnings(header.quality, done->warnings);
    JsonValue document = toJson(header);
    document.set("rows", static_cast<std::uint64_t>(done->rows));
    if (done->recovery) {
        document.set("recovered", toJson(*done->recovery));
    }
    if (const Result<void> printed = context.console.printDocument(document); !printed) {
        return failure(printed.error());
    }
    return ExitCode::Done;
}

void addOptions(CommandSyntax& syntax, ConvertOptions& options) {
    syntax.argument("IN", options.input, "Recording");
    syntax.argument("OUT", options.out, "New recording");
    syntax.option("--signals", options.signals, "Names, separated by commas", "A,B");
    syntax.option("--from", options.from, "First time", "S");
    syntax.option("--to", options.to, "Last time", "S");
    addDerive(syntax, options.derived);
}

CommandOutputs outputsOf(const ConvertOptions& options) {
    return {{}, {options.out}};
}

} // namespace

Command convertCommand() {
    return makeCommand<ConvertOptions>("convert", "Convert, cut and thin out recordings",
                                       {addOptions, runConvertCommand, outputsOf});
}

} // namespace halbench::app
