#pragma once

#include "devices/transport/message_stream.h"
#include "devices/transport/network_address.h"
#include "devices/transport/transport.h"

#include <chrono>

namespace halbench::devices {

/// A board behind a UDP port (resources/help/protocol.md 3.2): one command a datagram out, whole messages in.
/// What is no message is counted as damaged and dropped; a message that came before or was overtaken is
/// dropped too. The system keeps datagrams that arrive while nobody
/// receives, up to its own limit; the sender does not wait. Time is the host's steady clock. Thread: one, the
/// connection's.
class UdpTransport : public Transport {
public:
    explicit UdpTransport(NetworkAddress address);

    Result<void> open() override;
    void close() noexcept override { m_socket.close(); }
    Result<void> send(std::span<const std::uint8_t> packet) override;
    /// Also returns early with false when a signal interrupted the wait.
    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override;
    double now_s() const override;
    TransportStatistics statistics() const override { return m_statistics; }
    std::string description() const override { return uriOf(m_address, SocketKind::Datagram); }
    /// When the system keeps less than 0.2 s of it, each packet a datagram of its own.
    std::optional<std::string> remarkOnStream(double packets_Hz, std::size_t octets) const override;

    /// How many datagrams of one packet the system keeps at least; 0 before open().
    std::size_t keptDatagrams(std::size_t octets) const;

private:
    bool takeMessage(std::vector<std::uint8_t>& packet);
    Result<void> readDatagram();
    Error lost(int cause);
    void enlargeBuffer();

    NetworkAddress m_address;
    Descriptor m_socket;
    std::size_t m_buffer = 0; ///< what the system gave, by its own count
    MessageParser m_datagram;
    TransportStatistics m_statistics;
    std::vector<std::uint8_t> m_outgoing;
    std::uint16_t m_sendCounter = 0;
    DatagramWatch m_heard;
    std::chrono::steady_clock::time_point m_start;
};

} // namespace halbench::devices
