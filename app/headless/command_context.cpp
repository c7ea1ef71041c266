#include "app/headless/command_context.h"

#include "app/headless/recording_integrity.h"
#include "devices/device_uri.h"
#include "devices/formats/replay_device.h"
#include "devices/interruption.h"

namespace halbench::app {

devices::OpenOptions openOptionsFor(const CommandContext& context) {
    devices::OpenOptions options;
    options.seed = context.global.seed;
    options.isRealtime = context.global.isRealtime;
    options.interruptSignal = &context.interruptSignal;
    options.cacheFolder = devices::userCacheFolder();
    options.onMessage = [&console = context.console](const std::string& text) {
        console.log(LogLevel::Debug, text);
    };
    return options;
}

Finding otherFirmware(const devices::DeviceInfo& device) {
    return {"other_firmware",
            "the board runs firmware '" + device.firmware + "', but its description is of '" +
                device.otherFirmware + "': names may lead to wrong values, so nothing is written",
            "use the description of this firmware, or update the firmware completely"};
}

Result<std::unique_ptr<devices::Device>> openDeviceFor(const CommandContext& context,
                                                       const std::string& uri) {
    Result<std::unique_ptr<devices::Device>> device = devices::openDevice(uri, openOptionsFor(context));
    if (const auto recording = device ? devices::recordingOf(**device) : nullptr) {
        sayWarnings(context, recording->warnings);
    } else if (device && !(*device)->info().otherFirmware.empty()) {
        const Finding finding = otherFirmware((*device)->info());
        context.console.log(LogLevel::Warning, finding.message + "; " + finding.hint);
    }
    return device;
}

namespace {

constexpr const char* SimulatedScheme = "sim";

tl::unexpected<Error> consentMissing(const std::string& uri) {
    return failure(ErrorCode::ConsentMissing, "this command would arm and move the real device '" + uri + "'",
                   "nothing has moved; add --arm to allow motion");
}

} // namespace

Result<std::unique_ptr<devices::Device>> openToMove(const CommandContext& context, const std::string& uri,
                                                    const Admission& admits) {
    const Result<devices::DeviceUri> address = devices::parseDeviceUri(uri);
    if (!address) {
        return failure(address.error());
    }
    if (address->scheme != SimulatedScheme && !context.global.mayArm) {
        return consentMissing(uri);
    }
    Result<std::unique_ptr<devices::Device>> device = openDeviceFor(context, uri);
    if (!device) {
        return device;
    }
    if (const Result<void> admitted = admits ? admits((*device)->info()) : Result<void>(); !admitted) {
        return failure(admitted.error());
    }
    if (const Result<void> consent = requireConsent(context, **device); !consent) {
        return failure(consent.error());
    }
    return device;
}

Result<void> requireConsent(const CommandContext& context, devices::Device& device) {
    if (device.info().isSimulated) {
        return {};
    }
    if (!context.global.mayArm) {
        return consentMissing(device.info().uri);
    }
    const devices::DeviceState state = device.state();
    if (!state.isStopLatched && state.fault == 0) {
        return {};
    }
    context.console.log(LogLevel::Warning,
                        "--arm releases what an earlier run left latched: " + state.faultText);
    return device.clearStop();
}

std::function<void(const std::string&)> warningsTo(Console& console) {
    return [&console](const std::string& text) { console.log(LogLevel::Warning, text); };
}

Result<void> checkInterrupt(const CommandContext& context) {
    const int signal = context.interruptSignal.load();
    if (signal == 0) {
        return {};
    }
    return failure(devices::codeOfSignal(signal), "ended by " + devices::signalName(signal),
                   "the actuator is stopped, gains are restored");
}

ProcedureObserver observerFor(CommandContext& context) {
    ProcedureObserver observer;
    observer.onState = [&console = context.console](ProcedureState state) {
        console.log(LogLevel::Debug, procedureStateName(state));
    };
    observer.onProgress = [&console = context.console](double fraction, const std::string& text) {
        console.progress(fraction, text);
    };
    observer.checkAbort = [&context] { return checkInterrupt(context); };
    return observer;
}

} // namespace halbench::app
