#pragma once

#include "devices/transport/message_stream.h"
#include "devices/transport/tcp_socket.h"
#include "devices/transport/transport.h"

#include <chrono>

namespace halbench::devices {

/// A board behind a TCP connection (resources/help/protocol.md 3.2). Time is the host's steady clock.
/// Thread: one, the connection's.
class TcpTransport : public Transport {
public:
    explicit TcpTransport(NetworkAddress address);

    Result<void> open() override;
    void close() noexcept override { m_socket.close(); }
    Result<void> send(std::span<const std::uint8_t> packet) override;
    /// Also returns early with false when a signal interrupted the wait.
    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override;
    double now_s() const override;
    TransportStatistics statistics() const override { return m_statistics; }
    std::string description() const override { return "tcp:" + m_address.text(); }

private:
    Result<bool> takeMessage(std::vector<std::uint8_t>& packet);
    Result<void> readSocket();
    Error lost(const std::string& what);
    Error anotherProtocol(const std::string& what);

    NetworkAddress m_address;
    Descriptor m_socket;
    MessageParser m_parser;
    TransportStatistics m_statistics;
    std::vector<std::uint8_t> m_outgoing;
    std::uint16_t m_sendCounter = 0;
    CounterWatch m_counters;
    bool m_isAnswered = false; ///< by the board itself, on this connection
    std::chrono::steady_clock::time_point m_start;
};

} // namespace halbench::devices
