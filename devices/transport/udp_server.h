#pragma once

#include "devices/transport/board_server.h"
#include "devices/transport/network_address.h"

#include <sys/socket.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace halbench::devices {

/// A UDP port (resources/help/protocol.md 3.2). The session belongs to the address that sent CONNECT last and
/// everything the board says goes there; of anybody else only CONNECT and stop are heeded. Several messages
/// share a datagram, which never has more than 512 octets. What is not a whole message is dropped.
class UdpServer : public ServerPort {
public:
    static constexpr std::size_t MaxDatagram = 512;

    /// Port 0 picks a free one. Errors: InvalidInput, DeviceLost (host name).
    static Result<UdpServer> bind(const NetworkAddress& address);

    std::string address() const override { return uriOf(m_address, SocketKind::Datagram); }
    void waitForTraffic(int timeout_ms) const override;
    void exchange(ServedBoard& board) override;

private:
    /// Address and port of a master.
    struct Peer {
        sockaddr_storage name{};
        socklen_t size = sizeof(sockaddr_storage);
        bool operator==(const Peer& other) const;
    };

    UdpServer(NetworkAddress address, Descriptor socket);
    void takeDatagram(ServedBoard& board, std::span<const std::uint8_t> datagram, const Peer& sender);
    void takePacket(ServedBoard& board, std::span<const std::uint8_t> packet, const Peer& sender);
    void collectPackets(ServedBoard& board);
    void sendDatagram();

    NetworkAddress m_address;
    Descriptor m_socket;
    std::optional<Peer> m_master;
    std::vector<std::uint8_t> m_datagram; ///< messages on their way to the master
    std::vector<std::uint8_t> m_packet;
};

} // namespace halbench::devices
