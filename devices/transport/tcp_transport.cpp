#include "devices/transport/tcp_transport.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace halbench::devices {

namespace {

constexpr double ConnectTimeout_s = 1.5;
constexpr int SendTimeout_ms = 500;
constexpr std::size_t MaxPacket = 0xFFFF;

} // namespace

TcpTransport::TcpTransport(NetworkAddress address)
    : m_address(std::move(address)), m_parser(MaxPacket), m_start(std::chrono::steady_clock::now()) {}

double TcpTransport::now_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
}

Error TcpTransport::lost(const std::string& what) {
    m_socket.close();
    return {ErrorCode::DeviceLost, fmt::format("{}: {}", description(), what),
            "check that the device is on and not used by another program, then connect again"};
}

/// A web server, a login, a measuring instrument: whatever listens at that port.
Error TcpTransport::anotherProtocol(const std::string& what) {
    m_socket.close();
    return {ErrorCode::Protocol, fmt::format("{}: {}; not the expected protocol", description(), what),
            "check address and port: another program uses this port"};
}

Result<void> TcpTransport::open() {
    Result<Descriptor> socket = connectTcp(m_address, ConnectTimeout_s);
    if (!socket) {
        return failure(socket.error());
    }
    m_socket = *std::move(socket);
    m_parser = MessageParser(MaxPacket);
    m_counters = {};
    m_isAnswered = false;
    return {};
}

Result<void> TcpTransport::send(std::span<const std::uint8_t> packet) {
    m_outgoing.clear();
    appendMessage(m_outgoing, m_sendCounter++, packet);
    std::size_t done = 0;
    while (m_socket.isOpen() && done < m_outgoing.size()) {
        const ssize_t sent =
            ::send(m_socket.number(), m_outgoing.data() + done, m_outgoing.size() - done, MSG_NOSIGNAL);
        if (sent >= 0) {
            done += static_cast<std::size_t>(sent);
            continue;
        }
        if (errno != EAGAIN && errno != EINTR) {
            return failure(lost(std::strerror(errno)));
        }
        pollfd entry{m_socket.number(), POLLOUT, 0};
        if (::poll(&entry, 1, SendTimeout_ms) == 0) {
            return failure(lost("the device accepts no more commands"));
        }
    }
    if (!m_socket.isOpen()) {
        return failure(lost("the connection is closed"));
    }
    ++m_statistics.packetsSent;
    return {};
}

Result<bool> TcpTransport::takeMessage(std::vector<std::uint8_t>& packet) {
    const Result<std::optional<StreamMessage>> message = m_parser.next();
    if (!message) {
        ++m_statistics.packetsDamaged;
        return failure(anotherProtocol(message.error().message));
    }
    if (!*message) {
        return false;
    }
    const std::uint16_t counter = (*message)->counter;
    // A server that still serves another master refuses in its own name and counts its refusals itself: the
    // board's counter begins with its first answer.
    constexpr std::uint8_t Answer = 0xFF;
    m_isAnswered = m_isAnswered || (*message)->packet.front() == Answer;
    if (m_isAnswered) {
        m_statistics.packetsLost += m_counters.missingBefore(counter);
        m_counters.take(counter);
    }
    ++m_statistics.packetsReceived;
    packet.assign((*message)->packet.begin(), (*message)->packet.end());
    return true;
}

Result<void> TcpTransport::readSocket() {
    std::array<std::uint8_t, 65536> octets;
    const ssize_t count = ::recv(m_socket.number(), octets.data(), octets.size(), 0);
    if (count > 0) {
        m_statistics.octetsReceived += static_cast<std::uint64_t>(count);
        m_parser.feed({octets.data(), static_cast<std::size_t>(count)});
        return {};
    }
    if (count == 0) {
        return failure(lost("the device closed the connection (possibly taken over by another program)"));
    }
    if (errno == EAGAIN || errno == EINTR) {
        return {};
    }
    return failure(lost(std::strerror(errno)));
}

Result<bool> TcpTransport::receive(std::vector<std::uint8_t>& packet, double timeout_s) {
    const double deadline_s = now_s() + timeout_s;
    for (;;) {
        Result<bool> taken = takeMessage(packet);
        if (!taken || *taken) {
            return taken;
        }
        if (!m_socket.isOpen()) {
            return failure(lost("the connection is closed"));
        }
        if (!m_socket.isReadableWithin(deadline_s - now_s())) {
            return false;
        }
        if (const Result<void> read = readSocket(); !read) {
            return failure(read.error());
        }
    }
}

} // namespace halbench::devices
