#include "app/cli/command_support.h"
#include "app/documents/result_documents.h"
#include "app/documents/text/numbers.h"
#include "app/documents/text/procedure_choices.h"
#include "app/headless/command_header.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

std::string calibrationText(const CalibrateResult& result) {
    std::string text;
    for (const CalibrationFigure& figure : result.figures) {
        text += estimateLine(figure.name, figure.estimate);
    }
    text += result.isApplied ? "applied and read back:\n" : "proposed (not applied, see --apply):\n";
    for (const ParameterValue& value : result.proposed) {
        text += fmt::format("  {} = {}\n", value.name, formatNumber(value.value));
    }
    return text + findingLines(result.quality);
}

} // namespace

CommandResult runCalibrateCommand(CommandContext& context, const CommandOptions& options) {
    const Result<std::vector<Calibration>> which = calibrationsFrom(options.what);
    if (!which) {
        return failure(which.error());
    }
    const Result<std::unique_ptr<devices::Device>> device = openToMove(context, options.device);
    if (!device) {
        return failure(device.error());
    }
    if (options.isApplied) {
        if (const Result<void> kept = backUp(context, **device); !kept) {
            return failure(kept.error());
        }
    }
    const ResultHeader header = headerFor(context, "halbench.calibration/1", **device);
    CalibrateConfig config;
    config.which = *which;
    config.apply = options.isApplied;
    config.seed = header.seed;
    const Result<CalibrateResult> result = runCalibrate(**device, config, observerFor(context));
    if (!result) {
        return failure(result.error());
    }
    const JsonValue document = calibrationDocument(header, *result);
    if (const Result<void> done = deliver(context, document, calibrationText(*result), options.out); !done) {
        return failure(done.error());
    }
    return exitCodeFor(result->quality);
}

} // namespace halbench::app
