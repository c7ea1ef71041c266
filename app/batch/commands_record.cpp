#include "app/batch/command_support.h"
#include "app/batch/names.h"
#include "app/batch/numbers.h"
#include "app/batch/recording_file.h"
#include "app/batch/result_header.h"
#include "app/procedures/record_procedure.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

Result<RecordConfig> recordConfigFrom(const CommandOptions& options) {
    RecordConfig config;
    config.signals = splitList(options.signals);
    const Result<double> duration = numberOption("--duration", options.duration);
    if (!duration) {
        return failure(duration.error());
    }
    config.duration_s = *duration;
    if (!options.rate.empty()) {
        const Result<double> rate = numberOption("--rate", options.rate);
        if (!rate) {
            return failure(rate.error());
        }
        config.rate_Hz = *rate;
    }
    return config;
}

} // namespace

CommandResult runRecordCommand(CommandContext& context, const CommandOptions& options) {
    const Result<RecordConfig> config = recordConfigFrom(options);
    if (!config) {
        return failure(config.error());
    }
    const Result<std::unique_ptr<devices::Device>> device = openDeviceFor(context, options.device);
    if (!device) {
        return failure(device.error());
    }
    const Result<RecordResult> result = runRecord(**device, *config, observerFor(context));
    if (!result) {
        return failure(result.error());
    }
    ResultHeader header = headerFor(context, "halbench.recorded/1", **device);
    header.quality = result->quality;
    if (const Result<void> written = writeRecording(options.out, result->recording, **device, header.started);
        !written) {
        return failure(written.error());
    }
    JsonValue document = toJson(header);
    document.set("rows", static_cast<std::uint64_t>(result->recording.rows()));
    document.set("lost_rows", result->recording.lostRows);
    context.console.log(LogLevel::Info,
                        fmt::format("wrote {} ({} rows)", options.out, result->recording.rows()));
    if (const Result<void> printed = context.console.printDocument(document); !printed) {
        return failure(printed.error());
    }
    return ExitCode::Done;
}

} // namespace halbench::app
