#include "devices/transport/tcp_server.h"

#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <chrono>

namespace halbench::devices {

namespace {

constexpr std::size_t MaxCommand = 255; // MAX_CTO of every board
constexpr int TickTimeout_ms = 1;
/// With more than this waiting for a slow master nothing is taken from the board, whose own queue then
/// overflows and counts what it drops.
constexpr std::size_t MaxOutgoing = 65536;
/// A host that slept longer lets the board sleep too.
constexpr double MaxCatchUp_s = 0.5;

} // namespace

TcpServer::TcpServer(TcpAddress address, TcpSocket listener)
    : m_address(std::move(address)), m_listener(std::move(listener)), m_parser(MaxCommand) {}

Result<TcpServer> TcpServer::listen(const TcpAddress& address) {
    TcpAddress bound = address;
    Result<TcpSocket> listener = listenTcp(bound);
    if (!listener) {
        return failure(listener.error());
    }
    return TcpServer(std::move(bound), *std::move(listener));
}

void TcpServer::run(ServedBoard& board, const std::atomic<int>& interruptSignal) {
    using WallClock = std::chrono::steady_clock;
    auto last = WallClock::now();
    double board_s = 0.0;
    while (interruptSignal.load() == 0) {
        waitForTraffic();
        acceptMaster();
        const auto now = WallClock::now();
        board_s += std::min(std::chrono::duration<double>(now - last).count(), MaxCatchUp_s);
        last = now;
        board.advanceTo(board_s);
        readMaster(board);
        collectPackets(board);
        writeMaster();
    }
    dropMaster();
}

void TcpServer::waitForTraffic() const {
    std::array<pollfd, 2> entries = {pollfd{m_listener.descriptor(), POLLIN, 0},
                                     pollfd{m_master.descriptor(), POLLIN, 0}};
    (void)::poll(entries.data(), m_master.isOpen() ? 2 : 1, TickTimeout_ms);
}

void TcpServer::acceptMaster() {
    TcpSocket newcomer = acceptTcp(m_listener);
    if (!newcomer.isOpen()) {
        return;
    }
    dropMaster();
    m_master = std::move(newcomer);
}

void TcpServer::dropMaster() {
    m_master.close();
    m_parser = MessageParser(MaxCommand);
    m_outgoing.clear();
}

void TcpServer::readMaster(ServedBoard& board) {
    if (!m_master.isOpen()) {
        return;
    }
    std::array<std::uint8_t, 4096> octets;
    const ssize_t count = ::recv(m_master.descriptor(), octets.data(), octets.size(), 0);
    if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR)) {
        dropMaster();
        return;
    }
    if (count > 0) {
        m_parser.feed({octets.data(), static_cast<std::size_t>(count)});
    }
    for (;;) {
        const Result<std::optional<StreamMessage>> message = m_parser.next();
        if (!message) {
            dropMaster();
            return;
        }
        if (!*message) {
            return;
        }
        board.receive((*message)->packet);
        collectPackets(board);
    }
}

void TcpServer::collectPackets(ServedBoard& board) {
    std::uint16_t counter = 0;
    while (m_outgoing.size() < MaxOutgoing && board.transmit(m_packet, counter)) {
        if (m_master.isOpen()) { // what a board says while nobody listens is lost
            appendMessage(m_outgoing, counter, m_packet);
        }
    }
}

void TcpServer::writeMaster() {
    if (!m_master.isOpen() || m_outgoing.empty()) {
        return;
    }
    const ssize_t sent = ::send(m_master.descriptor(), m_outgoing.data(), m_outgoing.size(), MSG_NOSIGNAL);
    if (sent > 0) {
        m_outgoing.erase(m_outgoing.begin(), m_outgoing.begin() + sent);
    } else if (sent < 0 && errno != EAGAIN && errno != EINTR) {
        dropMaster();
    }
}

} // namespace halbench::devices
