#include "app/cli/command_support.h"
#include "app/documents/result_documents.h"
#include "app/documents/text/numbers.h"
#include "app/headless/command_header.h"
#include "app/headless/recording_file.h"

#include <string_view>

namespace halbench::app {

namespace {

std::string crossAxisText(const MoveResult& result) {
    std::string text;
    for (const CrossAxisPeak& other : result.others) {
        JsonValue peak = JsonValue::object();
        peak.set("largest_distance_" + other.axis.positionUnit, other.truth ? *other.truth : other.measured);
        text += figureLines("axis " + other.axis.id + ", which was to stay", peak);
    }
    return text;
}

/// A simulated device knows its true position; what is measured of any other is all there is.
std::string moveText(const MoveResult& result) {
    constexpr std::string_view Measured = "measured_";
    const bool isOneOfSeveral = !result.others.empty();
    const JsonValue first = isOneOfSeveral ? moveFigures(result.figures(), result.axis.positionUnit)
                                           : moveFigures(result.figures());
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
    const std::string of = isOneOfSeveral ? " of axis " + result.axis.id : std::string();
    const std::string truth = isOneOfSeveral ? "true position" + of : "true position of the simulated rotor";
    std::string text = result.truth ? figureLines(truth, first) : std::string();
    text += figureLines("measured position" + of, measured) + figureLines("drive", rest);
    return text + crossAxisText(result) + findingLines(result.quality);
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
    config.axis = options.axis;
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
    if (result->others.empty()) {
        document.set("figures", moveBody(*result));
    } else {
        document.set("axes", movedAxes(*result));
    }
    if (const Result<void> printed = context.console.printDocument(document); !printed) {
        return failure(printed.error());
    }
    return exitCodeFor(result->quality);
}

} // namespace halbench::app
