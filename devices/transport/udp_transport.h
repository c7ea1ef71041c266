#pragma once

#include "devices/transport/message_stream.h"
#include "devices/transport/network_address.h"
#include "devices/transport/transport.h"

#include <chrono>

namespace halbench::devices {

/// A board behind a UDP port (resources/help/protocol.md 3.2): one command a datagram out, whole messages in.
/// What is no message is counted as damaged and dropped. Time is the host's steady clock. Thread: one, the
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

private:
    bool takeMessage(std::vector<std::uint8_t>& packet);
    Result<void> readDatagram();
    Error lost(int cause);

    NetworkAddress m_address;
    Descriptor m_socket;
    MessageParser m_datagram;
    TransportStatistics m_statistics;
    std::vector<std::uint8_t> m_outgoing;
    std::uint16_t m_sendCounter = 0;
    CounterWatch m_counters;
    std::chrono::steady_clock::time_point m_start;
};

} // namespace halbench::devices
