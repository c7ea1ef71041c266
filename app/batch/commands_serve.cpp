#include "app/batch/commands.h"
#include "devices/serve_device.h"

#include <cstdio>

namespace halbench::app {

CommandResult runServeCommand(CommandContext& context, const CommandOptions& options) {
    using devices::ServedLine;
    const int chosen =
        (options.tcp.empty() ? 0 : 1) + (options.udp.empty() ? 0 : 1) + (options.usesPty ? 1 : 0);
    if (chosen != 1) {
        return failure(ErrorCode::Usage, "serve needs one of --tcp, --udp and --pty",
                       "add --tcp 127.0.0.1:0 to let it pick a port");
    }
    devices::ServeRequest request;
    request.device = options.device;
    request.line = options.usesPty        ? ServedLine::Pty
                   : !options.udp.empty() ? ServedLine::Udp
                                          : ServedLine::Tcp;
    request.address = options.tcp + options.udp; // one of them is empty
    request.seed = context.global.seed;
    const auto announce = [&](const std::string& address) {
        context.console.announce("listening " + address);
    };
    const Result<void> served = devices::serveDevice(request, announce, context.interruptSignal);
    if (!served) {
        return failure(served.error());
    }
    return ExitCode::Done;
}

} // namespace halbench::app
