#include "app/batch/command_support.h"
#include "app/batch/numbers.h"
#include "app/batch/recording_file.h"
#include "app/batch/result_documents.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

std::string moveText(const MoveResult& result) {
    std::string text;
    const JsonValue body = moveBody(result);
    for (const JsonMember& figure : body.members()) {
        text += fmt::format("{:<34} {}\n", figure.key,
                            figure.value.isNumber() ? formatNumber(figure.value.number()) : "none");
    }
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
