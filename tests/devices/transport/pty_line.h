#pragma once

#include "devices/transport/descriptor.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

namespace halbench::devices {

/// The far end of a serial line: what the board's side of a cable is. Unplugging closes it.
class PtyLine {
public:
    PtyLine() : m_master(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
        std::array<char, 128> path{};
        EXPECT_EQ(::grantpt(m_master.number()) | ::unlockpt(m_master.number()), 0);
        EXPECT_EQ(::ptsname_r(m_master.number(), path.data(), path.size()), 0);
        m_path = path.data();
    }

    const std::string& path() const { return m_path; }
    int number() const { return m_master.number(); }
    void unplug() { m_master.close(); }

    /// Ends early when nobody has the line open any more.
    void deliver(std::span<const std::uint8_t> octets) {
        pollfd entry{m_master.number(), POLLOUT, 0};
        while (!octets.empty() && ::poll(&entry, 1, 2000) == 1 && entry.revents == POLLOUT) {
            const ssize_t written = ::write(m_master.number(), octets.data(), octets.size());
            octets = octets.subspan(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
        }
    }
    /// What the program sent; waits up to 2 s until it is this much.
    std::vector<std::uint8_t> taken(std::size_t count) {
        std::vector<std::uint8_t> octets;
        while (octets.size() < count && m_master.isReadableWithin(2.0)) {
            std::array<std::uint8_t, 4096> part{};
            const ssize_t read = ::read(m_master.number(), part.data(), part.size());
            if (read <= 0) {
                break;
            }
            octets.insert(octets.end(), part.begin(), part.begin() + read);
        }
        return octets;
    }

private:
    Descriptor m_master;
    std::string m_path;
};

} // namespace halbench::devices
