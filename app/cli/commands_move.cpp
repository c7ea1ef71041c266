#include "app/cli/command_support.h"
#include "app/documents/result_documents.h"
#include "app/documents/text/numbers.h"
#include "app/headless/command_header.h"
#include "app/headless/recording_file.h"

#include <string_view>

namespace halbench::app {

namespace {

/// A simulated device knows its true position; what is measured of any other is all there is.
std::string moveText(const MoveResult& result) {
    constexpr std::string_view Measured = "measured_";
    const JsonValue first = moveFigures(result.figures());
    JsonValue measured = JsonValue::object();
    JsonValue rest = JsonValue::object();
    const JsonValue body = moveBody(result);
    for (const JsonMember& figure : body.members()) {
        if (figure.key.starts_with(Measured)) {
            measured.set(figure.key.substr(Measured.size()), figure.value);
        } else if (first.find(figure.key) == nullptr) {
            rest.set(figure.key, figure.value);
        }
    }
    std::string text =
        result.truth ? figureLines("true position of the simulated rotor", first) : std::string();
    text += figureLines("measured position", measured) + figureLines("drive", rest);
    return text + findingLines(result.quality);
}

} // namespace

CommandResult runMoveCommand(CommandContext& context, const CommandOptions& options) {
    const Result<MoveReference> reference = parseMoveReference(options.reference);
    if (!reference) {
        return failure(reference.error());
    }
    const Result<double> duration = numberOption("--duration", options.duration);
    if (!duration) {
        return failure(duration.error());
    }
    const Result<std::unique_ptr<devices::Device>> device = openToMove(context, options.device);
    if (!device) {
        return failure(device.error());
    }
    MoveConfig config;
    config.reference = *reference;
    config.duration_s = *duration;
    ResultHeader header = headerFor(context, "halbench.move/1", **device);
    const Result<MoveResult> result = runMove(**device, config, observerFor(context));
    if (!result) {
        return failure(result.error());
    }
    header.quality = result->quality;
    if (!options.out.empty()) {
        const Result<void> written =
            writeRecording(options.out, result->recording, **device, {header.started, {}, {}});
        if (!written) {
            return failure(written.error());
        }
    }
    context.console.print(moveText(*result));
    JsonValue document = toJson(header);
    if (const Result<void> printed =
            context.console.printDocument(document.set("figures", moveBody(*result)));
        !printed) {
        return failure(printed.error());
    }
    return exitCodeFor(result->quality);
}

} // namespace halbench::app
