#include "devices/transport/udp_server.h"

#include <poll.h>

#include <array>

namespace halbench::devices {

namespace {

constexpr std::size_t LargestDatagram = 65536;
/// A flood of datagrams must not hold up the board's time.
constexpr int MaxDatagramsAtOnce = 64;
constexpr std::size_t MessageHeader = 4;

/// A CONNECT that comes once more so soon is the network's repeat of one; later it is a master that was
/// started again at its old address and counts anew.
constexpr double LatestRepeat_s = 0.5;

} // namespace

std::string UdpServer::Peer::text() const {
    return {reinterpret_cast<const char*>(&name), size};
}

UdpServer::UdpServer(NetworkAddress address, Descriptor socket)
    : m_address(std::move(address)), m_socket(std::move(socket)) {}

Result<UdpServer> UdpServer::bind(const NetworkAddress& address) {
    NetworkAddress bound = address;
    Result<Descriptor> socket = bindSocket(bound, SocketKind::Datagram);
    if (!socket) {
        return failure(socket.error());
    }
    return UdpServer(std::move(bound), *std::move(socket));
}

void UdpServer::waitForTraffic(int timeout_ms) const {
    pollfd entry{m_socket.number(), POLLIN, 0};
    (void)::poll(&entry, 1, timeout_ms);
}

void UdpServer::exchange(ServedBoard& board) {
    std::array<std::uint8_t, LargestDatagram> octets;
    for (int i = 0; i < MaxDatagramsAtOnce; ++i) {
        Peer sender;
        const ssize_t count = ::recvfrom(m_socket.number(), octets.data(), octets.size(), 0,
                                         reinterpret_cast<sockaddr*>(&sender.name), &sender.size);
        if (count < 0) {
            break;
        }
        takeDatagram(board, {octets.data(), static_cast<std::size_t>(count)}, sender);
    }
    collectPackets(board);
    sendDatagram();
}

void UdpServer::takeDatagram(ServedBoard& board, std::span<const std::uint8_t> datagram, const Peer& sender) {
    MessageParser parser(MaxCommandOctets);
    parser.feed(datagram);
    for (auto message = parser.next(); message && *message; message = parser.next()) {
        takePacket(board, **message, sender);
    }
}

void UdpServer::takePacket(ServedBoard& board, const StreamMessage& message, const Peer& sender) {
    using Ruling = SessionHolder::Ruling;
    const std::string name = sender.text();
    const bool isLate = isStale(message, name);
    if (isLate && !isStop(message.packet)) {
        return;
    }
    if (beginsSession(message.packet)) {
        collectPackets(board); // the board may have ended the session of the master before
    }
    const Ruling ruling = m_session.judge(name, message.packet, m_now_s);
    if (ruling == Ruling::Refused) {
        refuse(sender);
    }
    if (ruling == Ruling::Refused || ruling == Ruling::Ignored) {
        return;
    }
    // Nobody waits for the answer any more, or ever did: it would pass for that of another command.
    const bool isUnanswered = isLate || ruling == Ruling::StrangersStop;
    if (isUnanswered || ruling == Ruling::Begins) {
        collectPackets(board); // what the board said so far was for the master before
        sendDatagram();
    }
    if (ruling == Ruling::Begins) {
        beginSession(message, sender);
    }
    board.receive(message.packet);
    collectPackets(board, isUnanswered ? 1 : 0);
}

bool UdpServer::isStale(const StreamMessage& message, const std::string& sender) {
    if (!m_master || sender != m_masterText) {
        return false;
    }
    const bool isAnew = beginsSession(message.packet) && m_now_s - m_began_s > LatestRepeat_s;
    return m_heard.take(message.counter, message.packet).isStale && !isAnew;
}

void UdpServer::beginSession(const StreamMessage& message, const Peer& sender) {
    m_master = sender;
    m_masterText = sender.text();
    m_began_s = m_now_s;
    m_heard = {};
    (void)m_heard.take(message.counter, message.packet);
}

void UdpServer::refuse(const Peer& sender) {
    std::vector<std::uint8_t> datagram;
    appendMessage(datagram, m_refusals++, refusedConnect());
    (void)::sendto(m_socket.number(), datagram.data(), datagram.size(), MSG_NOSIGNAL,
                   reinterpret_cast<const sockaddr*>(&sender.name), sender.size);
}

/// `unwantedAnswers`: so many are of commands that the master did not send.
void UdpServer::collectPackets(ServedBoard& board, int unwantedAnswers) {
    std::uint16_t counter = 0;
    while (board.transmit(m_packet, counter)) {
        m_session.noteSaid(m_packet);
        const std::size_t octets = MessageHeader + m_packet.size();
        const bool isUnwanted = isAnswer(m_packet) && unwantedAnswers-- > 0;
        if (!m_master || octets > MaxDatagram || isUnwanted) {
            continue; // what a board says while nobody listens is lost
        }
        if (m_datagram.size() + octets > MaxDatagram) {
            sendDatagram();
        }
        appendMessage(m_datagram, counter, m_packet);
    }
}

/// A datagram the network does not take is lost, and shows as a gap of the message counter.
void UdpServer::sendDatagram() {
    if (m_master && !m_datagram.empty()) {
        (void)::sendto(m_socket.number(), m_datagram.data(), m_datagram.size(), MSG_NOSIGNAL,
                       reinterpret_cast<const sockaddr*>(&m_master->name), m_master->size);
    }
    m_datagram.clear();
}

} // namespace halbench::devices
