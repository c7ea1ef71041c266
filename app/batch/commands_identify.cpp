#include "app/batch/command_support.h"
#include "app/batch/recording_file.h"
#include "app/batch/result_documents.h"
#include "devices/device_uri.h"

namespace halbench::app {

namespace {

CommandResult finish(CommandContext& context, const CommandOptions& options, const ResultHeader& header,
                     const IdentifyResult& result) {
    const JsonValue document = identificationDocument(header, result);
    if (const Result<void> done = deliver(context, document, identificationText(result), options.out);
        !done) {
        return failure(done.error());
    }
    return exitCodeFor(result.quality);
}

CommandResult identifyDevice(CommandContext& context, const CommandOptions& options, IdentifyConfig config) {
    const Result<std::unique_ptr<devices::Device>> device = openDeviceFor(context, options.device);
    if (!device) {
        return failure(device.error());
    }
    if (const Result<void> consent = requireConsent(context, **device); !consent) {
        return failure(consent.error());
    }
    const ResultHeader header = headerFor(context, "halbench.identification/1", **device);
    config.seed = header.seed;
    const Result<IdentifyResult> result = runIdentify(**device, config, observerFor(context));
    if (!result) {
        return failure(result.error());
    }
    if (!options.recordFile.empty()) {
        const Result<void> written =
            writeRecording(options.recordFile, result->recording, **device, header.started);
        if (!written) {
            return failure(written.error());
        }
    }
    return finish(context, options, header, *result);
}

} // namespace

CommandResult runIdentifyCommand(CommandContext& context, const CommandOptions& options) {
    Result<IdentifyConfig> config = identifyConfigFrom(options);
    if (!config) {
        return failure(config.error());
    }
    return identifyDevice(context, options, *std::move(config));
}

} // namespace halbench::app
