#pragma once

#include "devices/transport/message_stream.h"
#include "devices/transport/tcp_socket.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace halbench::devices {

/// A board that lives in this process, as its server sees it.
class ServedBoard {
public:
    virtual ~ServedBoard() = default;
    /// Lets board time pass up to this one.
    virtual void advanceTo(double time_s) = 0;
    virtual void receive(std::span<const std::uint8_t> packet) = 0;
    /// The next packet for the master; false when there is none.
    virtual bool transmit(std::vector<std::uint8_t>& packet, std::uint16_t& counter) = 0;
};

/// Serves one board to one master at a time over TCP, paced by the wall clock. A second master takes the
/// session: the first one's connection is closed. A master that sends nonsense is disconnected. The board's
/// own watchdog decides what a lost master means. Thread: the one that calls run().
class TcpServer {
public:
    /// Port 0 picks a free one. Errors: InvalidInput, DeviceLost (host name).
    static Result<TcpServer> listen(const TcpAddress& address);

    /// Where it listens, with the real port.
    const TcpAddress& address() const { return m_address; }
    /// Serves until the flag is set (by SIGINT, SIGTERM or a test).
    void run(ServedBoard& board, const std::atomic<int>& interruptSignal);

private:
    TcpServer(TcpAddress address, TcpSocket listener);
    void waitForTraffic() const;
    void acceptMaster();
    void readMaster(ServedBoard& board);
    void collectPackets(ServedBoard& board);
    void writeMaster();
    void dropMaster();

    TcpAddress m_address;
    TcpSocket m_listener;
    TcpSocket m_master;
    MessageParser m_parser;
    std::vector<std::uint8_t> m_outgoing;
    std::vector<std::uint8_t> m_packet;
};

} // namespace halbench::devices
