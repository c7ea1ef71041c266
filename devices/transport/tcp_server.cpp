#include "devices/transport/tcp_server.h"

#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>

namespace halbench::devices {

namespace {

/// With more than this waiting for a slow master nothing is taken from the board, whose own queue then
/// overflows and counts what it drops.
constexpr std::size_t MaxOutgoing = 65536;

} // namespace

TcpServer::TcpServer(NetworkAddress address, Descriptor listener)
    : m_address(std::move(address)), m_listener(std::move(listener)), m_parser(MaxCommandOctets) {}

Result<TcpServer> TcpServer::listen(const NetworkAddress& address) {
    NetworkAddress bound = address;
    Result<Descriptor> listener = bindSocket(bound, SocketKind::Stream);
    if (!listener) {
        return failure(listener.error());
    }
    return TcpServer(std::move(bound), *std::move(listener));
}

void TcpServer::waitForTraffic(int timeout_ms) const {
    std::array<pollfd, 2> entries = {pollfd{m_listener.number(), POLLIN, 0},
                                     pollfd{m_master.number(), POLLIN, 0}};
    (void)::poll(entries.data(), m_master.isOpen() ? 2 : 1, timeout_ms);
}

void TcpServer::exchange(ServedBoard& board) {
    acceptMaster();
    readMaster(board);
    collectPackets(board);
    writeMaster();
}

void TcpServer::acceptMaster() {
    Descriptor newcomer = acceptTcp(m_listener);
    if (!newcomer.isOpen()) {
        return;
    }
    dropMaster();
    m_master = std::move(newcomer);
}

void TcpServer::dropMaster() {
    m_master.close();
    m_parser = MessageParser(MaxCommandOctets);
    m_outgoing.clear();
}

void TcpServer::readMaster(ServedBoard& board) {
    if (!m_master.isOpen()) {
        return;
    }
    std::array<std::uint8_t, 4096> octets;
    const ssize_t count = ::recv(m_master.number(), octets.data(), octets.size(), 0);
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
    const ssize_t sent = ::send(m_master.number(), m_outgoing.data(), m_outgoing.size(), MSG_NOSIGNAL);
    if (sent > 0) {
        m_outgoing.erase(m_outgoing.begin(), m_outgoing.begin() + sent);
    } else if (sent < 0 && errno != EAGAIN && errno != EINTR) {
        dropMaster();
    }
}

} // namespace halbench::devices
