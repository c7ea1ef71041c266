#pragma once

#include "devices/transport/board_server.h"
#include "devices/transport/message_stream.h"
#include "devices/transport/session_holder.h"
#include "devices/transport/tcp_socket.h"

#include <cstdint>
#include <string>
#include <vector>

namespace halbench::devices {

/// A TCP port (resources/help/protocol.md 3.2). Any number of connections; one of them is the master, as
/// SessionHolder says. One that only connects is nothing, one that sends nonsense is disconnected.
class TcpServer : public ServerPort {
public:
    /// More connections than this at a time: the oldest that is not the master's is closed.
    static constexpr std::size_t MaxCallers = 16;

    /// Port 0 picks a free one. Errors: InvalidInput, DeviceLost (host name).
    static Result<TcpServer> listen(const NetworkAddress& address);

    std::string address() const override { return uriOf(m_address, SocketKind::Stream); }
    bool isOpenToNetwork() const override { return devices::isOpenToNetwork(m_listener); }
    void advanceTo(double time_s) override { m_now_s = time_s; }
    void waitForTraffic(int timeout_ms) const override;
    void exchange(ServedBoard& board) override;

private:
    /// One connection.
    struct Caller {
        std::string name; ///< no other has it, now or later
        Descriptor socket;
        MessageParser parser{MaxCommandOctets};
        std::vector<std::uint8_t> outgoing = {};
        std::uint16_t refusals = 0;
    };

    TcpServer(NetworkAddress address, Descriptor listener);
    void acceptCallers();
    void read(Caller& caller, ServedBoard& board);
    void takePacket(Caller& caller, ServedBoard& board, std::span<const std::uint8_t> packet);
    void beginSession(const Caller& caller, bool isTakenOver);
    void collectPackets(ServedBoard& board, int unwantedAnswers = 0);
    void discardPackets(ServedBoard& board);
    void write(Caller& caller);
    void drop(Caller& caller);
    Caller* master();

    NetworkAddress m_address;
    Descriptor m_listener;
    std::vector<Caller> m_callers; ///< oldest first
    std::uint64_t m_accepted = 0;
    SessionHolder m_session;
    std::string m_master; ///< who hears what the board says, also once the session has ended
    double m_now_s = 0.0;
    std::vector<std::uint8_t> m_packet;
};

} // namespace halbench::devices
