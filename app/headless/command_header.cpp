#include "app/headless/command_header.h"

#include "app/documents/text/numbers.h"
#include "app/headless/recording_integrity.h"
#include "devices/formats/replay_device.h"

namespace halbench::app {

namespace {

/// --seed wins over ?seed=; default 1.
std::uint64_t seedOf(const CommandContext& context, const devices::DeviceInfo& device) {
    if (context.global.seed) {
        return *context.global.seed;
    }
    for (const auto& [key, value] : device.overrides) {
        const std::optional<std::int64_t> seed = parseInteger(value);
        if (key == "seed" && seed) {
            return static_cast<std::uint64_t>(*seed);
        }
    }
    return 1;
}

} // namespace

ResultHeader headerFor(const CommandContext& context, const std::string& schema,
                       const devices::Device& device) {
    ResultHeader header = headerFor(context, schema);
    header.device = device.info();
    header.seed = seedOf(context, device.info());
    if (const auto recording = devices::recordingOf(device)) {
        noteWarnings(header.quality, recording->warnings);
    } else if (!device.info().otherFirmware.empty()) {
        addQuality(header.quality, {Verdict::Doubtful, {otherFirmware(device.info())}});
    }
    if (!device.info().isSimulated || context.global.isRealtime) {
        header.started = context.wallClock();
    }
    return header;
}

ResultHeader headerFor(const CommandContext& context, const std::string& schema) {
    ResultHeader header;
    header.schema = schema;
    header.seed = context.global.seed.value_or(1);
    return header;
}

} // namespace halbench::app
