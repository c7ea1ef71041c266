#include "app/batch/commands.h"
#include "app/batch/names.h"
#include "app/batch/numbers.h"
#include "app/batch/result_header.h"
#include "devices/acquisition/convert_recording.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

Result<std::optional<double>> timeOption(const std::string& option, const std::string& text) {
    if (text.empty()) {
        return std::optional<double>{};
    }
    const Result<double> time = numberOption(option, text);
    return time ? Result<std::optional<double>>(*time) : failure(time.error());
}

} // namespace

CommandResult runConvertCommand(CommandContext& context, const CommandOptions& options) {
    const Result<std::optional<double>> from = timeOption("--from", options.from);
    const Result<std::optional<double>> to = timeOption("--to", options.to);
    if (!from || !to) {
        return failure(from ? to.error() : from.error());
    }
    const devices::ConvertRequest request{options.input, options.out, splitList(options.signals), *from, *to};
    const Result<std::size_t> rows = devices::convertRecording(request);
    if (!rows) {
        return failure(rows.error());
    }
    context.console.log(LogLevel::Info, fmt::format("wrote {} ({} rows)", options.out, *rows));
    JsonValue document = toJson(headerFor(context, "halbench.conversion/1"));
    const Result<void> printed =
        context.console.printDocument(document.set("rows", static_cast<std::uint64_t>(*rows)));
    if (!printed) {
        return failure(printed.error());
    }
    return ExitCode::Done;
}

} // namespace halbench::app
