#include "devices/transport/udp_transport.h"

#include "devices/transport/session_holder.h"

#include <fmt/format.h>
#include <sys/socket.h>

#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>

namespace halbench::devices {

namespace {

constexpr std::size_t MaxPacket = 0xFFFF;
constexpr std::size_t HeaderOctets = 4;
/// A second of 32 floats at 20 kHz (resources/help/protocol.md 3.8): identification, time stamp and values.
constexpr double Fastest_Hz = 20000.0;
constexpr std::size_t FastestOctets = 5 + 32 * 4;
constexpr double Enough_s = 0.2;

/// What Linux counts for a datagram: a block of 2^n octets for it and 384 of its own, and what describes the
/// block. Measured on the loopback, never less than counted there; a card's driver may take more.
std::size_t spaceOf(std::size_t datagramOctets) {
    return std::bit_ceil(datagramOctets + 384) + 320;
}

} // namespace

UdpTransport::UdpTransport(NetworkAddress address)
    : m_address(std::move(address)), m_datagram(MaxPacket), m_start(std::chrono::steady_clock::now()) {}

double UdpTransport::now_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
}

Error UdpTransport::lost(int cause) {
    m_socket.close();
    return {ErrorCode::DeviceLost, fmt::format("{}: {}", description(), std::strerror(cause)),
            "check that the device is on and the address is correct"};
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
    enlargeBuffer();
    m_datagram = MessageParser(MaxPacket);
    m_heard = {};
    return {};
}

/// The system cuts the wish to its limit without a word, so that it is asked; it counts twice what it is
/// told.
void UdpTransport::enlargeBuffer() {
    const int wanted =
        static_cast<int>(Fastest_Hz / 2.0) * static_cast<int>(spaceOf(FastestOctets + HeaderOctets));
    (void)::setsockopt(m_socket.number(), SOL_SOCKET, SO_RCVBUF, &wanted, sizeof wanted);
    int given = 0;
    socklen_t size = sizeof given;
    const bool isTold = ::getsockopt(m_socket.number(), SOL_SOCKET, SO_RCVBUF, &given, &size) == 0;
    m_buffer = isTold ? static_cast<std::size_t>(given) : 0;
}

std::size_t UdpTransport::keptDatagrams(std::size_t octets) const {
    return m_buffer / spaceOf(octets + HeaderOctets);
}

std::optional<std::string> UdpTransport::remarkOnStream(double packets_Hz, std::size_t octets) const {
    const double kept_s = static_cast<double>(keptDatagrams(octets)) / packets_Hz;
    if (kept_s >= Enough_s) {
        return std::nullopt;
    }
    const double limit =
        std::ceil(Enough_s * packets_Hz * static_cast<double>(spaceOf(octets + HeaderOctets)) / 2.0);
    return fmt::format(
        "the system buffers no more than {:.0f} ms of this stream; data may be lost: raise its limit (sysctl "
        "net.core.rmem_max={:.0f}), use fewer signals or a lower rate, or connect by tcp:",
        1e3 * kept_s, limit);
}

Result<void> UdpTransport::send(std::span<const std::uint8_t> packet) {
    if (beginsSession(packet)) {
        m_heard = {}; // a board may count anew from here
    }
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

/// The next message of the datagram that is not stale.
bool UdpTransport::takeMessage(std::vector<std::uint8_t>& packet) {
    for (;;) {
        const Result<std::optional<StreamMessage>> message = m_datagram.next();
        if (!message) {
            ++m_statistics.packetsDamaged;
            m_datagram = MessageParser(MaxPacket);
            return false;
        }
        if (!*message) {
            return false;
        }
        const DatagramWatch::Arrival arrival = m_heard.take((*message)->counter, (*message)->packet);
        if (arrival.isStale) {
            m_statistics.packetsLate += arrival.isLate ? 1 : 0;
            continue;
        }
        m_statistics.packetsLost += arrival.missing;
        ++m_statistics.packetsReceived;
        packet.assign((*message)->packet.begin(), (*message)->packet.end());
        return true;
    }
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
