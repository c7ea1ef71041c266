#include "devices/transport/udp_transport.h"

#include <fmt/format.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace halbench::devices {

namespace {

constexpr std::size_t MaxPacket = 0xFFFF;

} // namespace

UdpTransport::UdpTransport(NetworkAddress address)
    : m_address(std::move(address)), m_datagram(MaxPacket), m_start(std::chrono::steady_clock::now()) {}

double UdpTransport::now_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
}

Error UdpTransport::lost(int cause) {
    m_socket.close();
    return {ErrorCode::DeviceLost, fmt::format("{}: {}", description(), std::strerror(cause)),
            "check that the board is on and the address is right"};
}

Result<void> UdpTransport::open() {
    const Result<AddressList> list = resolve(m_address, SocketKind::Datagram, false);
    if (!list) {
        return failure(list.error());
    }
    m_socket = makeSocket(**list);
    if (!m_socket.isOpen() || ::connect(m_socket.number(), (*list)->ai_addr, (*list)->ai_addrlen) != 0) {
        return failure(lost(errno));
    }
    m_datagram = MessageParser(MaxPacket);
    m_counters = {};
    return {};
}

Result<void> UdpTransport::send(std::span<const std::uint8_t> packet) {
    m_outgoing.clear();
    appendMessage(m_outgoing, m_sendCounter++, packet);
    if (::send(m_socket.number(), m_outgoing.data(), m_outgoing.size(), MSG_NOSIGNAL) < 0) {
        const int cause = errno;
        const bool isOnlyFull = cause == EAGAIN || cause == ENOBUFS || cause == EINTR;
        if (!isOnlyFull) { // a lost datagram is repeated like a lost answer
            return failure(lost(cause));
        }
    }
    ++m_statistics.packetsSent;
    return {};
}

bool UdpTransport::takeMessage(std::vector<std::uint8_t>& packet) {
    const Result<std::optional<StreamMessage>> message = m_datagram.next();
    if (!message) {
        ++m_statistics.packetsDamaged;
        m_datagram = MessageParser(MaxPacket);
        return false;
    }
    if (!*message) {
        return false;
    }
    m_statistics.packetsLost += m_counters.missingBefore((*message)->counter);
    m_counters.take((*message)->counter);
    ++m_statistics.packetsReceived;
    packet.assign((*message)->packet.begin(), (*message)->packet.end());
    return true;
}

Result<void> UdpTransport::readDatagram() {
    std::array<std::uint8_t, 65536> octets;
    const ssize_t count = ::recv(m_socket.number(), octets.data(), octets.size(), 0);
    if (count >= 0) {
        m_statistics.octetsReceived += static_cast<std::uint64_t>(count);
        m_datagram = MessageParser(MaxPacket); // what the last one left was not whole
        m_datagram.feed({octets.data(), static_cast<std::size_t>(count)});
        return {};
    }
    if (errno == EAGAIN || errno == EINTR) {
        return {};
    }
    return failure(lost(errno));
}

Result<bool> UdpTransport::receive(std::vector<std::uint8_t>& packet, double timeout_s) {
    const double deadline_s = now_s() + timeout_s;
    for (;;) {
        if (takeMessage(packet)) {
            return true;
        }
        if (!m_socket.isOpen()) {
            return failure(lost(ENOTCONN));
        }
        if (!m_socket.isReadableWithin(deadline_s - now_s())) {
            return false;
        }
        if (const Result<void> read = readDatagram(); !read) {
            return failure(read.error());
        }
    }
}

} // namespace halbench::devices
