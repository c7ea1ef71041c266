#include "tests/devices/firmware/line/board_line.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <thread>

namespace halbench::firmware {
namespace {

constexpr double Slice_s = 1e-3;
/// What the machine owes the board beyond this is forgotten: the board's clock then goes after the wall's.
constexpr double MostOwed_s = 0.02;
constexpr std::size_t MostOutgoing = 4096;

tl::unexpected<Error> noTerminal(const char* what) {
    return failure(ErrorCode::DeviceLost, fmt::format("{}: {}", what, std::strerror(errno)), {});
}

} // namespace

Result<std::unique_ptr<BoardLine>> BoardLine::open(std::shared_ptr<ServedBoard> board) {
    devices::Descriptor line(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    std::array<char, 128> path{};
    if (!line.isOpen() || ::grantpt(line.number()) != 0 || ::unlockpt(line.number()) != 0 ||
        ::ptsname_r(line.number(), path.data(), path.size()) != 0) {
        return noTerminal("cannot open a pseudo terminal");
    }
    // Opened and closed once: from then on the line hangs up while nobody has it open.
    const devices::Descriptor once(::open(path.data(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    termios settings{};
    if (!once.isOpen() || ::tcgetattr(once.number(), &settings) != 0) {
        return noTerminal(path.data());
    }
    ::cfmakeraw(&settings);
    if (::tcsetattr(once.number(), TCSANOW, &settings) != 0) {
        return noTerminal(path.data());
    }
    return std::unique_ptr<BoardLine>(new BoardLine(std::move(board), std::move(line), path.data()));
}

bool BoardLine::hasOpener() {
    pollfd entry{m_line.number(), POLLIN, 0};
    (void)::poll(&entry, 1, 0);
    return (entry.revents & POLLHUP) == 0;
}

Result<void> BoardLine::exchange() {
    const bool isOpen = hasOpener();
    if (isOpen && !m_isOpened) {
        m_board->lineOpened();
        m_outgoing.clear();
    }
    m_isOpened = isOpen;
    std::array<std::uint8_t, 256> octets;
    const ssize_t count = isOpen ? ::read(m_line.number(), octets.data(), octets.size()) : 0;
    if (count > 0) {
        if (auto sent = m_board->send({octets.data(), static_cast<std::size_t>(count)}); !sent) {
            return sent;
        }
    }
    const std::vector<std::uint8_t> said = m_board->take();
    if (!isOpen) {
        return {}; // nobody hears it
    }
    if (m_outgoing.size() < MostOutgoing) {
        m_outgoing.insert(m_outgoing.end(), said.begin(), said.end());
    }
    const ssize_t written = ::write(m_line.number(), m_outgoing.data(), m_outgoing.size());
    if (written > 0) {
        m_outgoing.erase(m_outgoing.begin(), m_outgoing.begin() + written);
    }
    return {};
}

void BoardLine::serve(const std::atomic<int>& isEnding) {
    using Seconds = std::chrono::duration<double>;
    auto last = std::chrono::steady_clock::now();
    double owed_s = 0.0;
    while (isEnding == 0) {
        const auto now = std::chrono::steady_clock::now();
        owed_s = std::min(owed_s + Seconds(now - last).count(), MostOwed_s);
        last = now;
        if (owed_s < Slice_s) {
            std::this_thread::sleep_for(Seconds(Slice_s - owed_s));
            continue;
        }
        owed_s -= Slice_s;
        if (!exchange() || !m_board->advanceTo(m_board->time_s() + Slice_s)) {
            return;
        }
        m_boardTime_s = m_board->time_s();
    }
}

} // namespace halbench::firmware
