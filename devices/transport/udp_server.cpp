#include "devices/transport/udp_server.h"

#include "devices/transport/message_stream.h"

#include <poll.h>

#include <array>
#include <cstring>

namespace halbench::devices {

namespace {

constexpr std::size_t LargestDatagram = 65536;
/// A flood of datagrams must not hold up the board's time.
constexpr int MaxDatagramsAtOnce = 64;
constexpr std::size_t MessageHeader = 4;

/// USER_CMD "E" (resources/help/protocol.md 3.11).
bool isStop(std::span<const std::uint8_t> packet) {
    return packet.size() >= 2 && packet[0] == 0xF1 && packet[1] == 0x45;
}

} // namespace

bool UdpServer::Peer::operator==(const Peer& other) const {
    return size == other.size && std::memcmp(&name, &other.name, size) == 0;
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
        takePacket(board, (*message)->packet, sender);
    }
}

void UdpServer::takePacket(ServedBoard& board, std::span<const std::uint8_t> packet, const Peer& sender) {
    const bool isMaster = m_master == sender;
    if (!isMaster && packet[0] == ConnectCommand) {
        collectPackets(board); // what the board said so far was for the master before
        sendDatagram();
        m_master = sender;
    } else if (!isMaster && !isStop(packet)) {
        return;
    }
    board.receive(packet);
    collectPackets(board);
}

void UdpServer::collectPackets(ServedBoard& board) {
    std::uint16_t counter = 0;
    while (board.transmit(m_packet, counter)) {
        const std::size_t octets = MessageHeader + m_packet.size();
        if (!m_master || octets > MaxDatagram) {
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
