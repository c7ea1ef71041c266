#pragma once

#include "devices/firmware/xcp/hb_xcp.h"
#include "tests/devices/transport/served_board.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <string>
#include <thread>
#include <vector>

namespace halbench::app {

/// A board in the network behind a line that a test can spoil: `uri()` is where the window finds it.
class FaultyLine {
public:
    enum class Fault {
        None,
        Stalled,  ///< open, but nothing comes from the board any more
        Cut,      ///< closed, and stays closed
        Flooding, ///< the board sends as many log lines as the line takes, beside what it was asked for
    };

    FaultyLine() : m_listener(::socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address = loopback(0);
        socklen_t size = sizeof address;
        ::bind(m_listener, reinterpret_cast<sockaddr*>(&address), size);
        ::listen(m_listener, 1);
        ::getsockname(m_listener, reinterpret_cast<sockaddr*>(&address), &size);
        m_uri = "tcp:127.0.0.1:" + std::to_string(ntohs(address.sin_port));
        m_thread = std::thread([this] { run(); });
    }
    ~FaultyLine() {
        m_isEnding = true;
        m_thread.join();
        ::close(m_listener);
    }
    FaultyLine(const FaultyLine&) = delete;
    FaultyLine& operator=(const FaultyLine&) = delete;

    const std::string& uri() const { return m_uri; }
    /// The board itself, past the line.
    const std::string& boardUri() const { return m_board.uri(); }
    /// From the next connection on another board is behind the line.
    void plugInAnother() { m_isOther = true; }
    void spoil(Fault fault) { m_fault = fault; }
    /// From now on the board says that its library is an older one.
    void ageFirmware() { m_isOld = true; }

    /// Every message of the board comes so much later.
    void delay(std::chrono::milliseconds by) { m_delay = by; }
    /// Of the samples from now on so many never come, or begin with the number of a list that nobody asked
    /// for; one in SpoiltEvery. A board that sends a sample in several messages: its first one.
    void loseSamples(int count) { m_toLose = count; }
    void damageSamples(int count) { m_toDamage = count; }
    int lost() const { return m_lost; }
    int damaged() const { return m_damaged; }
    /// What passed: samples and, they among them, messages.
    std::uint64_t samples() const { return m_samples; }
    std::uint64_t messages() const { return m_messages; }

private:
    static constexpr std::uint64_t SpoiltEvery = 16;
    static constexpr std::size_t HeaderOctets = 4; ///< LEN u16 | CTR u16
    static constexpr std::uint8_t NobodysList = 0x7B;

    using Clock = std::chrono::steady_clock;
    struct Message {
        Clock::time_point due;
        std::vector<std::uint8_t> octets;
    };

    static sockaddr_in loopback(int port) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        return address;
    }

    void run() {
        while (!m_isEnding) {
            pollfd waiting{m_listener, POLLIN, 0};
            if (::poll(&waiting, 1, 10) <= 0 || m_fault == Fault::Cut) {
                continue;
            }
            const int master = ::accept(m_listener, nullptr, nullptr);
            // A board has no megabytes of room for what its line does not take yet.
            const int room_octets = 65536;
            ::setsockopt(master, SOL_SOCKET, SO_SNDBUF, &room_octets, sizeof room_octets);
            const int board = ::socket(AF_INET, SOCK_STREAM, 0);
            const std::string& served = (m_isOther ? m_other : m_board).uri();
            const sockaddr_in address = loopback(std::stoi(served.substr(served.rfind(':') + 1)));
            ::connect(board, reinterpret_cast<const sockaddr*>(&address), sizeof address);
            m_coming.clear();
            m_waiting.clear();
            relay(master, board);
            ::close(master);
            ::close(board);
        }
    }

    void relay(int master, int board) {
        while (!m_isEnding && m_fault != Fault::Cut) {
            std::array<pollfd, 2> ends{{{master, POLLIN, 0}, {board, POLLIN, 0}}};
            const bool isHurried = m_fault == Fault::Flooding || !m_waiting.empty();
            ::poll(ends.data(), ends.size(), isHurried ? (m_fault == Fault::Flooding ? 0 : 1) : 5);
            if (ends[0].revents != 0 && !forward(master, board, false)) {
                return;
            }
            if (ends[1].revents != 0 && !forward(board, master, true)) {
                return;
            }
            if (!deliver(master)) {
                return;
            }
            if (m_fault == Fault::Flooding && hasRoom(master) && !flood(master)) {
                return;
            }
        }
    }

    static bool sendAll(int to, const std::uint8_t* octets, std::size_t count) {
        while (count > 0) {
            const ssize_t sent = ::send(to, octets, count, MSG_NOSIGNAL);
            if (sent <= 0) {
                return false;
            }
            octets += sent;
            count -= static_cast<std::size_t>(sent);
        }
        return true;
    }

    bool forward(int from, int to, bool isBoard) {
        std::array<std::uint8_t, 4096> octets{};
        const ssize_t count = ::recv(from, octets.data(), octets.size(), 0);
        if (count <= 0) {
            return false;
        }
        if (isBoard) {
            take(octets.data(), static_cast<std::size_t>(count));
            return true;
        }
        return sendAll(to, octets.data(), static_cast<std::size_t>(count));
    }

    /// Whole messages only go on, so that what the line does is between two of them.
    void take(const std::uint8_t* octets, std::size_t count) {
        m_coming.insert(m_coming.end(), octets, octets + count);
        while (m_coming.size() >= HeaderOctets) {
            const std::size_t size = HeaderOctets + m_coming[0] + 256U * m_coming[1];
            if (m_coming.size() < size) {
                return;
            }
            const auto end = m_coming.begin() + static_cast<std::ptrdiff_t>(size);
            Message message{Clock::now() + m_delay.load(), {m_coming.begin(), end}};
            m_coming.erase(m_coming.begin(), end);
            age(message.octets.data(), message.octets.data() + size);
            if (m_fault != Fault::Stalled && !spoilSample(message)) {
                m_waiting.push_back(std::move(message));
            }
        }
    }

    /// The first message of one: number 0 of its list, in front of the mark of an overload.
    static bool isSample(const Message& message) {
        return message.octets.size() > HeaderOctets && (message.octets[HeaderOctets] & 0x7FU) == 0;
    }

    /// Whether it never comes.
    bool spoilSample(Message& message) {
        if (!isSample(message) || ++m_seen % SpoiltEvery != 0) {
            return false;
        }
        if (m_toLose > 0) {
            --m_toLose;
            ++m_lost;
            return true;
        }
        if (m_toDamage > 0) {
            --m_toDamage;
            ++m_damaged;
            message.octets[HeaderOctets] = NobodysList;
        }
        return false;
    }

    bool deliver(int master) {
        while (!m_waiting.empty() && m_waiting.front().due <= Clock::now()) {
            const Message message = std::move(m_waiting.front());
            m_waiting.pop_front();
            if (!sendAll(master, message.octets.data(), message.octets.size())) {
                return false;
            }
            ++m_messages;
            m_samples += isSample(message) ? 1U : 0U;
        }
        return true;
    }

    void age(std::uint8_t* begin, std::uint8_t* end) const {
        const std::string now = HB_LIBRARY_VERSION "-0x";
        const std::string old = "0.1.0-0x";
        while (m_isOld && (begin = std::search(begin, end, now.begin(), now.end())) != end) {
            begin = std::copy(old.begin(), old.end(), begin);
        }
    }

    /// Lines go both ways at once: a flood holds up nothing that is on its way to the board.
    static bool hasRoom(int to) {
        pollfd end{to, POLLOUT, 0};
        return ::poll(&end, 1, 0) > 0;
    }

    bool flood(int master) {
        std::vector<std::uint8_t> lines;
        for (int i = 0; i < 64; ++i) {
            lines.insert(lines.end(), {9, 0, 0, 0, 0xFC, 0x01, 'f', 'l', 'o', 'o', 'd', '\n', 0});
        }
        return sendAll(master, lines.data(), lines.size());
    }

    devices::BoardServer m_board;
    devices::BoardServer m_other{devices::ServedLine::Tcp, 2};
    std::atomic<bool> m_isOther = false;
    std::atomic<bool> m_isOld = false;
    int m_listener;
    std::string m_uri;
    std::atomic<Fault> m_fault = Fault::None;
    std::atomic<bool> m_isEnding = false;
    std::atomic<std::chrono::milliseconds> m_delay{};
    std::atomic<int> m_toLose = 0;
    std::atomic<int> m_toDamage = 0;
    std::atomic<int> m_lost = 0;
    std::atomic<int> m_damaged = 0;
    std::atomic<std::uint64_t> m_samples = 0;
    std::atomic<std::uint64_t> m_messages = 0;
    std::uint64_t m_seen = 0;           ///< samples
    std::vector<std::uint8_t> m_coming; ///< of the board, not a whole message yet
    std::deque<Message> m_waiting;
    std::thread m_thread;
};

} // namespace halbench::app
