#pragma once

#include "devices/transport/udp_server.h"
#include "devices/transport/udp_transport.h"
#include "tests/devices/transport/echo_board.h"

namespace halbench::devices {

/// A program and a board that answers it, by UDP within this machine.
struct UdpPair {
    UdpServer server = *UdpServer::bind({"127.0.0.1", 0});
    EchoBoard board;
    UdpTransport transport{*parseNetworkAddress(server.address().substr(4))};
};

} // namespace halbench::devices
