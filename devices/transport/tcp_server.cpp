#include "devices/transport/tcp_server.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace halbench::devices {

namespace {

/// With more than this waiting for a slow master nothing is taken from the board, whose own queue then
/// overflows and counts what it drops.
constexpr std::size_t MaxOutgoing = 65536;

} // namespace

TcpServer::TcpServer(NetworkAddress address, Descriptor listener)
    : m_address(std::move(address)), m_listener(std::move(listener)) {}

Result<TcpServer> TcpServer::listen(const NetworkAddress& address) {
    NetworkAddress bound = address;
    Result<Descriptor> listener = bindSocket(bound, SocketKind::Stream);
    if (!listener) {
        return failure(listener.error());
    }
    return TcpServer(std::move(bound), *std::move(listener));
}

void TcpServer::waitForTraffic(int timeout_ms) const {
    std::vector<pollfd> entries = {pollfd{m_listener.number(), POLLIN, 0}};
    for (const Caller& caller : m_callers) {
        entries.push_back(pollfd{caller.socket.number(), POLLIN, 0});
    }
    (void)::poll(entries.data(), entries.size(), timeout_ms);
}

/// Oldest connections first, so that a master that left is known before the next one asks.
void TcpServer::exchange(ServedBoard& board) {
    acceptCallers();
    for (Caller& caller : m_callers) {
        read(caller, board);
    }
    collectPackets(board);
    for (Caller& caller : m_callers) {
        write(caller);
    }
    std::erase_if(m_callers, [](const Caller& caller) { return !caller.socket.isOpen(); });
}

void TcpServer::acceptCallers() {
    for (Descriptor newcomer = acceptTcp(m_listener); newcomer.isOpen(); newcomer = acceptTcp(m_listener)) {
        if (m_callers.size() >= MaxCallers) {
            const auto oldest = std::find_if(m_callers.begin(), m_callers.end(),
                                             [&](const Caller& caller) { return caller.name != m_master; });
            m_callers.erase(oldest);
        }
        m_callers.push_back({std::to_string(++m_accepted), std::move(newcomer)});
    }
}

TcpServer::Caller* TcpServer::master() {
    const auto found = std::find_if(m_callers.begin(), m_callers.end(), [&](const Caller& caller) {
        return caller.name == m_master && caller.socket.isOpen();
    });
    return found == m_callers.end() ? nullptr : &*found;
}

void TcpServer::drop(Caller& caller) {
    m_session.noteLeft(caller.name);
    caller.socket.close();
}

void TcpServer::read(Caller& caller, ServedBoard& board) {
    if (!caller.socket.isOpen()) {
        return;
    }
    std::array<std::uint8_t, 4096> octets;
    const ssize_t count = ::recv(caller.socket.number(), octets.data(), octets.size(), 0);
    if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR)) {
        drop(caller);
        return;
    }
    if (count > 0) {
        caller.parser.feed({octets.data(), static_cast<std::size_t>(count)});
    }
    for (;;) {
        const Result<std::optional<StreamMessage>> message = caller.parser.next();
        if (!message) {
            drop(caller);
            return;
        }
        if (!*message) {
            return;
        }
        takePacket(caller, board, (*message)->packet);
    }
}

void TcpServer::takePacket(Caller& caller, ServedBoard& board, std::span<const std::uint8_t> packet) {
    using Ruling = SessionHolder::Ruling;
    if (beginsSession(packet)) {
        collectPackets(
            board); // what the board said so far, the end of a session too, is of the master before
    }
    const bool isHeld = m_session.isHeldBy(m_master);
    const Ruling ruling = m_session.judge(caller.name, packet, m_now_s);
    if (ruling == Ruling::Refused) {
        appendMessage(caller.outgoing, caller.refusals++, refusedConnect());
    }
    if (ruling == Ruling::Refused || ruling == Ruling::Ignored) {
        return;
    }
    const bool isStrangers = ruling == Ruling::StrangersStop;
    if (isStrangers) {
        collectPackets(board); // what the board said so far is the master's
    }
    if (ruling == Ruling::Begins) {
        discardPackets(board);
        beginSession(caller, isHeld);
    }
    board.receive(packet);
    collectPackets(board, isStrangers ? 1 : 0);
}

/// A master that lost the session by its silence is told by the end of its connection.
void TcpServer::beginSession(const Caller& caller, bool isTakenOver) {
    Caller* before = master();
    if (isTakenOver && before != nullptr && before != &caller) {
        before->socket.close();
    }
    m_master = caller.name;
}

/// `unwantedAnswers`: so many are of commands that the master did not send.
void TcpServer::collectPackets(ServedBoard& board, int unwantedAnswers) {
    std::uint16_t counter = 0;
    Caller* listener = master();
    while ((listener == nullptr || listener->outgoing.size() < MaxOutgoing) &&
           board.transmit(m_packet, counter)) {
        m_session.noteSaid(m_packet);
        const bool isUnwanted = isAnswer(m_packet) && unwantedAnswers-- > 0;
        if (listener != nullptr && !isUnwanted) { // what a board says while nobody listens is lost
            appendMessage(listener->outgoing, counter, m_packet);
        }
    }
}

/// What a slow master before left in the board's queue is not the next one's.
void TcpServer::discardPackets(ServedBoard& board) {
    std::uint16_t counter = 0;
    while (board.transmit(m_packet, counter)) {
    }
}

void TcpServer::write(Caller& caller) {
    if (!caller.socket.isOpen() || caller.outgoing.empty()) {
        return;
    }
    const ssize_t sent =
        ::send(caller.socket.number(), caller.outgoing.data(), caller.outgoing.size(), MSG_NOSIGNAL);
    if (sent > 0) {
        caller.outgoing.erase(caller.outgoing.begin(), caller.outgoing.begin() + sent);
    } else if (sent < 0 && errno != EAGAIN && errno != EINTR) {
        drop(caller);
    }
}

} // namespace halbench::devices
