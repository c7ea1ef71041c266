#include "app/cli/commands.h"
#include "app/documents/text/numbers.h"
#include "devices/open/port_address.h"
#include "devices/open/serve_device.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace halbench::app {

namespace {

struct ServeOptions {
    std::string device;
    std::string tcp, udp;
    bool usesPty = false;
    std::string framing, sxiHeader, checksum; ///< of --pty, in the words of a serial address
    std::string drop, corrupt, latency;
};

/// 0 where the option was not given.
Result<double> numberOrNone(const std::string& option, const std::string& text) {
    return text.empty() ? Result<double>(0.0) : numberOption(option, text);
}

Result<devices::LineFaults> faultsOf(const ServeOptions& options) {
    const Result<double> drop = numberOrNone("--drop", options.drop);
    const Result<double> corrupt = numberOrNone("--corrupt", options.corrupt);
    const Result<double> latency_ms = numberOrNone("--latency-ms", options.latency);
    for (const Result<double>* number : {&drop, &corrupt, &latency_ms}) {
        if (!*number) {
            return failure(number->error());
        }
    }
    return devices::LineFaults{*drop, *corrupt, 1e-3 * *latency_ms};
}

/// By the address of who will open the terminal, so that both ends know the same words.
Result<devices::SxiProfile> profileOf(const ServeOptions& options) {
    std::string address = "serial:PTY";
    char joint = '?';
    for (const auto& [key, value] : {std::pair{"framing", &options.framing},
                                     {"header", &options.sxiHeader},
                                     {"checksum", &options.checksum}}) {
        if (!value->empty()) {
            address += fmt::format("{}{}={}", std::exchange(joint, '&'), key, *value);
        }
    }
    if (joint == '&' && !options.usesPty) {
        return failure(ErrorCode::Usage, "--framing, --header and --checksum are of a serial line",
                       "serve with --pty, or leave them out");
    }
    return devices::parseDeviceUri(address).and_then(devices::parseSerialAddress).map([](const auto& serial) {
        return serial.profiles.front();
    });
}

Result<devices::ServeRequest> requestOf(const CommandContext& context, const ServeOptions& options) {
    using devices::ServedLine;
    const int chosen =
        (options.tcp.empty() ? 0 : 1) + (options.udp.empty() ? 0 : 1) + (options.usesPty ? 1 : 0);
    if (chosen != 1) {
        return failure(ErrorCode::Usage, "serve needs one of --tcp, --udp and --pty",
                       "add --tcp 127.0.0.1:0 to let it pick a port");
    }
    const Result<devices::LineFaults> faults = faultsOf(options);
    if (!faults) {
        return failure(faults.error());
    }
    const Result<devices::SxiProfile> profile = profileOf(options);
    if (!profile) {
        return failure(profile.error());
    }
    devices::ServeRequest request;
    request.device = options.device;
    request.line = options.usesPty        ? ServedLine::Pty
                   : !options.udp.empty() ? ServedLine::Udp
                                          : ServedLine::Tcp;
    request.address = options.tcp + options.udp; // one of them is empty
    request.seed = context.global.seed;
    request.faults = *faults;
    request.profile = *profile;
    return request;
}

CommandResult runServeCommand(CommandContext& context, const ServeOptions& options) {
    const Result<devices::ServeRequest> request = requestOf(context, options);
    if (!request) {
        return failure(request.error());
    }
    const auto announce = [&](const std::string& address, bool isOpenToNetwork) {
        context.console.announce("listening " + address);
        if (isOpenToNetwork) {
            context.console.log(LogLevel::Warning,
                                address +
                                    " is open to the network: every machine that reaches it can use this "
                                    "board; give 127.0.0.1 to serve this machine alone");
        }
    };
    const Result<devices::LineTraffic> traffic =
        devices::serveDevice(*request, announce, context.interruptSignal);
    if (!traffic) {
        return failure(traffic.error());
    }
    if (request->faults.isAny()) {
        context.console.log(LogLevel::Info,
                            fmt::format("{} messages, {} dropped, {} corrupted", traffic->messages,
                                        traffic->dropped, traffic->corrupted));
    }
    return ExitCode::Done;
}

void addOptions(CommandSyntax& syntax, ServeOptions& options) {
    syntax.device(options.device);
    syntax.option("--tcp", options.tcp, "Listen there; port 0 picks one", "HOST:PORT");
    syntax.option("--udp", options.udp, "Listen there; port 0 picks one", "HOST:PORT");
    syntax.flag("--pty", options.usesPty, "A pseudo terminal");
    syntax.option("--framing", options.framing, "With --pty: SYNC and escapes, or none", "on|off");
    syntax.option("--header", options.sxiHeader, "With --pty: what is in front of a packet",
                  "len_byte|len_ctr_byte|...");
    syntax.option("--checksum", options.checksum, "With --pty: what is behind it", "none|byte|word");
    syntax.option("--drop", options.drop, "Share of the messages that vanish, 0 to 1", "P");
    syntax.option("--corrupt", options.corrupt, "Share of the messages with a flipped bit, 0 to 1", "P");
    syntax.option("--latency-ms", options.latency, "Every message arrives so much later, each way", "MS");
}

} // namespace

Command serveCommand() {
    return makeCommand<ServeOptions>("serve", "Offer a simulated board to other XCP tools",
                                     {addOptions, runServeCommand});
}

} // namespace halbench::app
