#include "devices/open/serve_device.h"

#include "devices/open/served_simulation.h"
#include "devices/open/sxi_framing.h"
#include "devices/simulated/registry/simulated_device.h"
#include "devices/transport/codec_framing.h"
#include "devices/transport/pty_server.h"
#include "devices/transport/tcp_server.h"
#include "devices/transport/udp_server.h"

#include <fmt/format.h>

#include <array>

namespace halbench::devices {

namespace {

/// Of the seed: the board's own draws stay the same whatever its line does.
constexpr std::uint64_t LineStream = 101;
constexpr std::uint64_t FrameStream = 102;

/// What the board says of its serial line in its own description (resources/help/protocol.md 3.13).
std::string describeSxi(const SxiProfile& profile) {
    constexpr std::array Headers = {"HEADER_LEN_BYTE", "HEADER_LEN_CTR_BYTE", "HEADER_LEN_FILL_BYTE",
                                    "HEADER_LEN_WORD", "HEADER_LEN_CTR_WORD", "HEADER_LEN_FILL_WORD"};
    constexpr std::array Checksums = {"NO_CHECKSUM", "CHECKSUM_BYTE", "CHECKSUM_WORD"};
    const std::string framing =
        profile.isFramed
            ? fmt::format("/begin FRAMING 0x{:02X} 0x{:02X} /end FRAMING ", profile.sync, profile.escape)
            : std::string();
    return fmt::format("/begin XCP_ON_SxI 0x0100 115200 /begin ASYNCH_FULL_DUPLEX_MODE PARITY_NONE "
                       "ONE_STOP_BIT {}/end ASYNCH_FULL_DUPLEX_MODE {} {} /end XCP_ON_SxI\n",
                       framing, Headers[static_cast<std::size_t>(profile.header)],
                       Checksums[static_cast<std::size_t>(profile.checksum)]);
}

/// `sxi` must outlive the board.
SimulatedBoard::Line lineOf(ServedLine line, const std::string& sxi) {
    switch (line) {
    case ServedLine::Tcp:
        break;
    case ServedLine::Udp:
        return {"/begin XCP_ON_UDP_IP 0x0100 5555 ADDRESS \"127.0.0.1\" /end XCP_ON_UDP_IP\n", 0};
    case ServedLine::Pty:
        return {sxi.c_str(), HB_SXI_LONGEST_PACKET};
    }
    return {nullptr, 0};
}

/// Our own profile by the board library's own code.
std::unique_ptr<PacketFraming> framingOf(const SxiProfile& profile) {
    if (profile == SxiProfile{}) {
        return std::make_unique<SxiFraming>();
    }
    return std::make_unique<CodecFraming>(profile);
}

template <typename Server>
Result<std::unique_ptr<ServerPort>> owned(Result<Server> server) {
    if (!server) {
        return failure(server.error());
    }
    return std::unique_ptr<ServerPort>(std::make_unique<Server>(*std::move(server)));
}

Result<std::unique_ptr<ServerPort>> openPort(const ServeRequest& request, const Random& random,
                                             LineTraffic& traffic) {
    if (request.line == ServedLine::Pty) {
        return owned(PtyServer::open(std::make_unique<FaultyFraming>(
            framingOf(request.profile), request.profile, request.faults.corrupt_ratio,
            random.fork(FrameStream), traffic)));
    }
    const Result<NetworkAddress> address = parseListenAddress(request.address);
    if (!address) {
        return failure(address.error());
    }
    return request.line == ServedLine::Udp ? owned(UdpServer::bind(*address))
                                           : owned(TcpServer::listen(*address));
}

/// On a serial line frames are damaged, not the messages in them.
LineFaults faultsOfMessages(const ServeRequest& request) {
    LineFaults faults = request.faults;
    faults.corrupt_ratio = request.line == ServedLine::Pty ? 0.0 : faults.corrupt_ratio;
    return faults;
}

} // namespace

Result<LineTraffic> serveDevice(const ServeRequest& request, const ListeningHook& onListening,
                                const std::atomic<int>& interruptSignal) {
    const Result<DeviceUri> uri = parseDeviceUri(request.device);
    if (!uri) {
        return failure(uri.error());
    }
    if (uri->scheme != "sim") {
        return failure(ErrorCode::Usage, fmt::format("'{}' cannot be served", request.device),
                       "serve needs a simulated device, e.g. sim:htm");
    }
    if (const Result<void> checked = checkLineFaults(request.faults); !checked) {
        return failure(checked.error());
    }
    const Result<SimulatedSetup> setup = parseSimulatedAddress(*uri, request.seed);
    if (!setup) {
        return failure(setup.error());
    }
    const std::string sxi = describeSxi(request.profile);
    const Result<std::unique_ptr<SimulatedBoard>> board =
        makeSimulatedBoard(*uri, request.seed, lineOf(request.line, sxi));
    if (!board) {
        return failure(board.error());
    }
    const Random random(setup->seed);
    LineTraffic traffic;
    const Result<std::unique_ptr<ServerPort>> port = openPort(request, random, traffic);
    if (!port) {
        return failure(port.error());
    }
    ServedSimulation served(**board);
    FaultyBoard faulty(served, faultsOfMessages(request), random.fork(LineStream), traffic);
    onListening((*port)->address(), (*port)->isOpenToNetwork());
    serveBoard(**port, faulty, interruptSignal);
    return traffic;
}

} // namespace halbench::devices
