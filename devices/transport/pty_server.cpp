#include "devices/transport/pty_server.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace halbench::devices {

namespace {

/// With more than this waiting for a slow master nothing is taken from the board, whose own queue then
/// overflows and drops whole samples.
constexpr std::size_t MaxOutgoing = 4096;
constexpr std::size_t PathCapacity = 128;
/// Without framing, octets further apart than this do not belong together.
constexpr std::chrono::milliseconds InterOctetTimeout{50};

tl::unexpected<Error> noTerminal(const char* what) {
    return failure(ErrorCode::DeviceLost, fmt::format("{}: {}", what, std::strerror(errno)),
                   "this system gives no pseudo terminal; serve over --tcp");
}

/// Every octet passes as it is: no echo, no line ends, no control characters.
bool isMadeRaw(const Descriptor& slave) {
    termios settings{};
    if (::tcgetattr(slave.number(), &settings) != 0) {
        return false;
    }
    ::cfmakeraw(&settings);
    return ::tcsetattr(slave.number(), TCSANOW, &settings) == 0;
}

} // namespace

PtyServer::PtyServer(std::unique_ptr<PacketFraming> framing, Descriptor line, Descriptor slave,
                     std::string path)
    : m_framing(std::move(framing)), m_line(std::move(line)), m_slave(std::move(slave)),
      m_path(std::move(path)) {}

Result<PtyServer> PtyServer::open(std::unique_ptr<PacketFraming> framing) {
    Descriptor line(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (!line.isOpen() || ::grantpt(line.number()) != 0 || ::unlockpt(line.number()) != 0) {
        return noTerminal("cannot open a pseudo terminal");
    }
    std::array<char, PathCapacity> path{};
    if (::ptsname_r(line.number(), path.data(), path.size()) != 0) {
        return noTerminal("cannot name the pseudo terminal");
    }
    Descriptor slave(::open(path.data(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (!slave.isOpen() || !isMadeRaw(slave)) {
        return noTerminal(path.data());
    }
    return PtyServer(std::move(framing), std::move(line), std::move(slave), path.data());
}

void PtyServer::waitForTraffic(int timeout_ms) const {
    pollfd entry{m_line.number(), POLLIN, 0};
    (void)::poll(&entry, 1, timeout_ms);
}

void PtyServer::exchange(ServedBoard& board) {
    std::array<std::uint8_t, 4096> octets;
    const ssize_t count = ::read(m_line.number(), octets.data(), octets.size());
    if (count > 0) {
        const auto now = std::chrono::steady_clock::now();
        if (now - m_lastOctet > InterOctetTimeout) {
            m_framing->noteSilence();
        }
        m_lastOctet = now;
    }
    for (ssize_t i = 0; i < count; ++i) {
        const auto packet = m_framing->receive(octets[static_cast<std::size_t>(i)]);
        if (!packet.empty()) {
            takePacket(board, packet);
        }
    }
    collectPackets(board);
    writeLine();
}

void PtyServer::takePacket(ServedBoard& board, std::span<const std::uint8_t> packet) {
    if (packet[0] == ConnectCommand) {
        discard(board);
    }
    board.receive(packet);
    collectPackets(board);
}

/// A new session begins on an empty line, whatever an earlier master left unread.
void PtyServer::discard(ServedBoard& board) {
    std::uint16_t counter = 0;
    while (board.transmit(m_packet, counter)) {
    }
    m_outgoing.clear();
    (void)::tcflush(m_line.number(), TCOFLUSH);
    (void)::tcflush(m_slave.number(), TCIFLUSH);
}

void PtyServer::collectPackets(ServedBoard& board) {
    std::uint16_t counter = 0;
    while (m_outgoing.size() < MaxOutgoing && board.transmit(m_packet, counter)) {
        m_framing->append(m_outgoing, counter, m_packet);
    }
}

void PtyServer::writeLine() {
    if (m_outgoing.empty()) {
        return;
    }
    const ssize_t written = ::write(m_line.number(), m_outgoing.data(), m_outgoing.size());
    if (written > 0) {
        m_outgoing.erase(m_outgoing.begin(), m_outgoing.begin() + written);
    }
}

} // namespace halbench::devices
