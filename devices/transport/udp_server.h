#pragma once

#include "devices/transport/board_server.h"
#include "devices/transport/message_stream.h"
#include "devices/transport/network_address.h"
#include "devices/transport/session_holder.h"

#include <sys/socket.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace halbench::devices {

/// A UDP port (resources/help/protocol.md 3.2). The session belongs to the address that SessionHolder names
/// and everything the board says goes there. Several messages share a datagram, which never has more than 512
/// octets. What is not a whole message is dropped, and so is a message of the master that came before or was
/// overtaken by a later one.
class UdpServer : public ServerPort {
public:
    static constexpr std::size_t MaxDatagram = 512;

    /// Port 0 picks a free one. Errors: InvalidInput, DeviceLost (host name).
    static Result<UdpServer> bind(const NetworkAddress& address);

    std::string address() const override { return uriOf(m_address, SocketKind::Datagram); }
    bool isOpenToNetwork() const override { return devices::isOpenToNetwork(m_socket); }
    void advanceTo(double time_s) override { m_now_s = time_s; }
    void waitForTraffic(int timeout_ms) const override;
    void exchange(ServedBoard& board) override;

private:
    /// Address and port of a master.
    struct Peer {
        sockaddr_storage name{};
        socklen_t size = sizeof(sockaddr_storage);
        std::string text() const; ///< the octets of the address
    };

    UdpServer(NetworkAddress address, Descriptor socket);
    void takeDatagram(ServedBoard& board, std::span<const std::uint8_t> datagram, const Peer& sender);
    void takePacket(ServedBoard& board, const StreamMessage& message, const Peer& sender);
    bool isStale(const StreamMessage& message, const std::string& sender);
    void beginSession(const StreamMessage& message, const Peer& sender);
    void refuse(const Peer& sender);
    void collectPackets(ServedBoard& board, int unwantedAnswers = 0);
    void sendDatagram();

    NetworkAddress m_address;
    Descriptor m_socket;
    SessionHolder m_session;
    std::optional<Peer> m_master; ///< who hears what the board says, also once the session has ended
    std::string m_masterText;
    DatagramWatch m_heard; ///< of the master's messages
    double m_began_s = 0.0;
    double m_now_s = 0.0;
    std::uint16_t m_refusals = 0;
    std::vector<std::uint8_t> m_datagram; ///< messages on their way to the master
    std::vector<std::uint8_t> m_packet;
};

} // namespace halbench::devices
