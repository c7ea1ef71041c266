#include "devices/transport/tcp_transport.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>

namespace halbench::devices {

namespace {

constexpr double ConnectTimeout_s = 1.5;
constexpr int SendTimeout_ms = 500;
constexpr std::size_t MaxPacket = 0xFFFF;

timespec timeoutOf(double duration_s) {
    const double bounded_s = std::clamp(duration_s, 0.0, 3600.0);
    const double whole_s = std::floor(bounded_s);
    return {static_cast<time_t>(whole_s), static_cast<long>((bounded_s - whole_s) * 1e9)};
}

} // namespace

TcpTransport::TcpTransport(TcpAddress address)
    : m_address(std::move(address)), m_parser(MaxPacket), m_start(std::chrono::steady_clock::now()) {}

double TcpTransport::now_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
}

Error TcpTransport::lost(const std::string& what) {
    m_socket.close();
    return {ErrorCode::DeviceLost, fmt::format("{}: {}", description(), what),
            "check that the board is on and no other program uses it, then connect again"};
}

Result<void> TcpTransport::open() {
    Result<TcpSocket> socket = connectTcp(m_address, ConnectTimeout_s);
    if (!socket) {
        return failure(socket.error());
    }
    m_socket = *std::move(socket);
    m_parser = MessageParser(MaxPacket);
    m_hasCounter = false;
    return {};
}

Result<void> TcpTransport::send(std::span<const std::uint8_t> packet) {
    m_outgoing.clear();
    appendMessage(m_outgoing, m_sendCounter++, packet);
    std::size_t done = 0;
    while (m_socket.isOpen() && done < m_outgoing.size()) {
        const ssize_t sent =
            ::send(m_socket.descriptor(), m_outgoing.data() + done, m_outgoing.size() - done, MSG_NOSIGNAL);
        if (sent >= 0) {
            done += static_cast<std::size_t>(sent);
            continue;
        }
        if (errno != EAGAIN && errno != EINTR) {
            return failure(lost(std::strerror(errno)));
        }
        pollfd entry{m_socket.descriptor(), POLLOUT, 0};
        if (::poll(&entry, 1, SendTimeout_ms) == 0) {
            return failure(lost("the board takes no more commands"));
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
        return failure(lost(message.error().message));
    }
    if (!*message) {
        return false;
    }
    const std::uint16_t counter = (*message)->counter;
    if (m_hasCounter) {
        m_statistics.packetsLost += static_cast<std::uint16_t>(counter - m_lastCounter - 1);
    }
    m_lastCounter = counter;
    m_hasCounter = true;
    ++m_statistics.packetsReceived;
    packet.assign((*message)->packet.begin(), (*message)->packet.end());
    return true;
}

Result<void> TcpTransport::readSocket() {
    std::array<std::uint8_t, 65536> octets;
    const ssize_t count = ::recv(m_socket.descriptor(), octets.data(), octets.size(), 0);
    if (count > 0) {
        m_parser.feed({octets.data(), static_cast<std::size_t>(count)});
        return {};
    }
    if (count == 0) {
        return failure(lost("the board closed the connection (another program may have taken it)"));
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
        pollfd entry{m_socket.descriptor(), POLLIN, 0};
        const timespec timeout = timeoutOf(deadline_s - now_s());
        if (::ppoll(&entry, 1, &timeout, nullptr) <= 0) {
            return false;
        }
        if (const Result<void> read = readSocket(); !read) {
            return failure(read.error());
        }
    }
}

} // namespace halbench::devices
