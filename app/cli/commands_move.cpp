#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/documents/axis_model_file.h"
#include "app/documents/pose_table_file.h"
#include "app/documents/result_documents.h"
#include "app/documents/text/numbers.h"
#include "app/headless/command_header.h"
#include "app/headless/recording_file.h"
#include "app/headless/recording_integrity.h"
#include "app/procedures/base/axis_choice.h"
#include "app/procedures/excite/travel_reference.h"
#include "app/procedures/move/move_prediction.h"
#include "app/procedures/tune/loop_axis.h"
#include "app/tuning/axis_conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace halbench::app {

namespace {

struct MoveOptions {
    std::string device;
    std::string reference;
    std::string axis;
    std::string model; ///< MODEL.json
    std::string duration;
    std::string out;
};

std::string crossAxisText(const MoveResult& result) {
    std::string text;
    for (const CrossAxisPeak& other : result.others) {
        JsonValue peak = JsonValue::object();
        peak.set("largest_distance_" + other.axis.positionUnit, other.truth ? *other.truth : other.measured);
        text += figureLines("axis " + other.axis.id + ", which was to stay", peak);
    }
    return text;
}

/// The further axes of a path or table.
std::string partnersText(const MoveResult& result) {
    std::string text;
    for (const PartnerResult& partner : result.partners) {
        const std::string of = " position of axis " + partner.axis.id;
        const std::string& unit = partner.axis.positionUnit;
        text += partner.truth ? figureLines("true" + of, moveFigures(*partner.truth, unit)) : std::string();
        text += figureLines("measured" + of, moveFigures(partner.measured, unit));
    }
    return text;
}

/// The worst row of a table; nothing of other references. All of them are in the document.
std::string rowsText(const MoveResult& result) {
    const std::vector<RowFigures>& rows = result.figures().rows;
    if (rows.empty()) {
        return {};
    }
    double error = 0.0;
    std::optional<double> settling_s;
    for (const RowFigures& row : rows) {
        error = std::max(error, std::fabs(row.error));
        settling_s = row.settlingTime_s ? std::max(row.settlingTime_s, settling_s) : settling_s;
    }
    JsonValue worst = JsonValue::object();
    worst.set("largest_error_" + result.axis.positionUnit, error);
    worst.set("longest_settling_time_s", settling_s ? JsonValue(*settling_s) : JsonValue());
    return figureLines(fmt::format("{} rows of the table, axis {}", rows.size(), result.axis.id), worst);
}

/// A simulated device knows its true position; what is measured of any other is all there is.
std::string moveText(const MoveResult& result) {
    constexpr std::string_view Measured = "measured_";
    const bool isOneOfSeveral = result.isOneOfSeveral();
    const JsonValue first = isOneOfSeveral ? moveFigures(result.figures(), result.axis.positionUnit)
                                           : moveFigures(result.figures());
    JsonValue measured = JsonValue::object();
    JsonValue rest = JsonValue::object();
    const JsonValue body = moveBody(result);
    for (const JsonMember& figure : body.members()) {
        if (figure.key.starts_with(Measured)) {
            measured.set(figure.key.substr(Measured.size()), figure.value);
        } else if (first.find(figure.key) == nullptr && !figure.value.isNull()) {
            rest.set(figure.key, figure.value);
        }
    }
    const std::string of = isOneOfSeveral ? " of axis " + result.axis.id : std::string();
    const std::string truth = isOneOfSeveral ? "true position" + of : "true position of the simulated rotor";
    std::string text = result.truth ? figureLines(truth, first) : std::string();
    text += figureLines("measured position" + of, measured) + rowsText(result) + partnersText(result);
    text += figureLines("drive", rest);
    if (result.contour) {
        text += figureLines("distance from the path", contourBody(*result.contour));
    }
    return text + crossAxisText(result) + findingLines(result.quality);
}

/// The axes that are meant, all of which the reference suits, before the first one moves.
Result<std::vector<std::string>> movedAxesOf(const MoveOptions& options, const MoveReference& reference,
                                             const devices::Device& device) {
    if (options.axis != "all" || movesSeveralAxes(reference)) {
        return std::vector<std::string>{options.axis};
    }
    const auto axes = chosenAxes(device.catalogue(), options.axis);
    if (!axes) {
        return failure(axes.error());
    }
    std::vector<std::string> names;
    for (const devices::AxisSpec& axis : *axes) {
        if (const Result<void> suits = checkQuantity(reference, axis); !suits) {
            return failure(suits.error());
        }
        names.push_back(axis.id);
    }
    if (!options.out.empty() && names.size() > 1) {
        return failure(ErrorCode::Usage, "--out holds one move, --axis all makes several",
                       "name the axis whose move is kept");
    }
    return names;
}

/// --model: what it foresees of the move of an axis that it knows; nothing without it.
Result<std::optional<MoveFigures>> predictionOf(const MoveOptions& options, const MoveConfig& config,
                                                devices::Device& device) {
    if (options.model.empty()) {
        return std::optional<MoveFigures>();
    }
    const auto file = readAxisModelFile(options.model);
    if (!file) {
        return failure(file.error());
    }
    const std::string& kind = device.info().model;
    if (file->header.device && file->header.device->model != kind) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("--model: it is of a device '{}', this one is a '{}'",
                                   file->header.device->model, kind),
                       "identify this device");
    }
    const IdentifiedAxis* axis = file->model.find(config.axis);
    if (axis == nullptr) {
        return failure(ErrorCode::UnknownName,
                       fmt::format("--model: the model has no axis '{}'", config.axis),
                       "name an axis that it has, or leave it out");
    }
    const auto conditions = axisConditionsOf(device, {config.axis});
    return conditions ? predictAxisMove(device, config, estimateOfAxis(file->model, *axis),
                                        conditions->front().currentLimit_A)
                      : failure(conditions.error());
}

struct MovedAxis {
    MoveResult result;
    std::optional<MoveFigures> predicted;
};

Result<std::vector<MovedAxis>> moveAll(CommandContext& context, devices::Device& device,
                                       const MoveOptions& options, MoveConfig config) {
    const auto names = movedAxesOf(options, config.reference, device);
    if (!names) {
        return failure(names.error());
    }
    std::vector<MovedAxis> moved;
    for (const std::string& name : *names) {
        config.axis = name;
        auto predicted = predictionOf(options, config, device);
        if (!predicted) {
            return failure(predicted.error());
        }
        Result<MoveResult> result = runMove(device, config, observerFor(context));
        if (!result) {
            return failure(result.error());
        }
        moved.push_back({*std::move(result), *std::move(predicted)});
    }
    return moved;
}

DataQuality qualityOf(const std::vector<MovedAxis>& moved) {
    DataQuality quality = moved.front().result.quality;
    for (std::size_t i = 1; i < moved.size(); ++i) {
        const DataQuality& next = moved[i].result.quality;
        quality.verdict = std::max(quality.verdict, next.verdict);
        quality.findings.insert(quality.findings.end(), next.findings.begin(), next.findings.end());
    }
    return quality;
}

std::string predictedText(const MovedAxis& moved) {
    return moved.predicted ? figureLines("predicted position of axis " + moved.result.axis.id,
                                         moveFigures(*moved.predicted, moved.result.axis.positionUnit))
                           : std::string();
}

/// A travel, a path and a table end by themselves.
Result<double> durationOf(const MoveOptions& options, const MoveReference& reference) {
    if (!options.duration.empty()) {
        return numberOption("--duration", options.duration);
    }
    const std::optional<double> travel_s = defaultDuration_s(reference);
    return travel_s ? Result<double>(*travel_s)
                    : failure(ErrorCode::Usage, "--duration is required",
                              fmt::format("say how long a {} lasts", moveShapeName(reference.shape)));
}

/// Before it begins.
void tellTravel(Console& console, const MoveReference& reference) {
    if (const std::optional<double> travel_s = travelTime_s(reference)) {
        console.log(LogLevel::Info,
                    fmt::format("the {} takes {:.3f} s", moveShapeName(reference.shape), *travel_s));
    }
}

CommandResult runMoveCommand(CommandContext& context, const MoveOptions& options) {
    Result<MoveReference> reference = parseMoveReference(options.reference);
    if (!reference) {
        return failure(reference.error());
    }
    if (const Result<void> read = readTableOf(*reference); !read) {
        return failure(read.error());
    }
    const Result<double> duration = durationOf(options, *reference);
    if (!duration) {
        return failure(duration.error());
    }
    tellTravel(context.console, *reference);
    const Result<std::unique_ptr<devices::Device>> device = openToMove(context, options.device);
    if (!device) {
        return failure(device.error());
    }
    MoveConfig config;
    config.reference = *reference;
    config.duration_s = *duration;
    ResultHeader header = headerFor(context, "halbench.move/1", **device);
    const auto moved = moveAll(context, **device, options, config);
    if (!moved) {
        return failure(moved.error());
    }
    addQuality(header.quality, qualityOf(*moved));
    if (!options.out.empty()) {
        const Result<void> written =
            writeRecording(options.out, moved->front().result.recording, **device, {header.started, {}, {}});
        if (!written) {
            return failure(written.error());
        }
    }
    JsonValue document = toJson(header);
    JsonValue axes = JsonValue::array();
    for (const MovedAxis& each : *moved) {
        context.console.print(moveText(each.result) + predictedText(each));
        if (!each.result.isOneOfSeveral()) {
            document.set("figures", moveBody(each.result));
        } else {
            const JsonValue moves = movedAxes(each.result, each.predicted);
            for (const JsonValue& one : moves.items()) {
                axes.push(one);
            }
        }
        if (each.result.contour) {
            document.set("contour", contourBody(*each.result.contour));
        }
    }
    if (!axes.items().empty()) {
        document.set("axes", axes);
    }
    if (const Result<void> printed = context.console.printDocument(document); !printed) {
        return failure(printed.error());
    }
    return exitCodeFor(header.quality);
}

void addOptions(CommandSyntax& syntax, MoveOptions& options) {
    syntax.device(options.device);
    syntax.option("--reference", options.reference,
                  "step,amplitude_deg=100; s-curve,amplitude_mm=5,rate_mm_s=50,...; circle; raster; arc; "
                  "line; table,file=POSES.csv; rest ...",
                  "SHAPE,KEY=VALUE...", Presence::Required);
    syntax.option("--axis", options.axis,
                  "Which axis moves, on a device with several; all: one after the other", "NAME|all");
    syntax.option("--model", options.model, "Model of the axes: the move is predicted too", "MODEL.json");
    syntax.option("--duration", options.duration,
                  "Seconds; default of trapezoid, s-curve, paths and tables: the travel and 1 s of rest",
                  "S");
    syntax.recording("--out", options.out, "Recording");
}

CommandOutputs outputsOf(const MoveOptions& options) {
    return {{}, {options.out}};
}

} // namespace

Command moveCommand() {
    return makeCommand<MoveOptions>("move", "Follow a reference and measure how well",
                                    {addOptions, runMoveCommand, outputsOf});
}

} // namespace halbench::app
