#pragma once

#include "devices/transport/board_server.h"
#include "devices/transport/message_stream.h"
#include "devices/transport/tcp_socket.h"

#include <cstdint>
#include <string>
#include <vector>

namespace halbench::devices {

/// A TCP port (resources/help/protocol.md 3.2). A second master takes the session: the first one's connection
/// is closed. A master that sends nonsense is disconnected.
class TcpServer : public ServerPort {
public:
    /// Port 0 picks a free one. Errors: InvalidInput, DeviceLost (host name).
    static Result<TcpServer> listen(const NetworkAddress& address);

    std::string address() const override { return uriOf(m_address, SocketKind::Stream); }
    void waitForTraffic(int timeout_ms) const override;
    void exchange(ServedBoard& board) override;

private:
    TcpServer(NetworkAddress address, Descriptor listener);
    void acceptMaster();
    void readMaster(ServedBoard& board);
    void collectPackets(ServedBoard& board);
    void writeMaster();
    void dropMaster();

    NetworkAddress m_address;
    Descriptor m_listener;
    Descriptor m_master;
    MessageParser m_parser;
    std::vector<std::uint8_t> m_outgoing;
    std::vector<std::uint8_t> m_packet;
};

} // namespace halbench::devices
