#pragma once

#include "devices/open/serve_device.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace halbench::devices {

/// `halbench serve sim:htm` in a thread of the test.
class BoardServer {
public:
    explicit BoardServer(ServedLine line = ServedLine::Tcp, std::optional<std::uint64_t> seed = {},
                         const SxiProfile& profile = {})
        : m_thread([this, line, seed, profile] { serve(line, seed, profile); }) {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [this] { return !m_address.empty(); });
    }
    ~BoardServer() { end(); }
    BoardServer(const BoardServer&) = delete;
    BoardServer& operator=(const BoardServer&) = delete;

    void end() {
        m_interrupt.store(2);
        if (m_thread.joinable()) {
            m_thread.join();
        }
    }
    /// "tcp:127.0.0.1:PORT", "udp:127.0.0.1:PORT", "pty:/dev/pts/N"
    const std::string& uri() const { return m_address; }

private:
    void serve(ServedLine line, std::optional<std::uint64_t> seed, const SxiProfile& profile) {
        const auto served = serveDevice(
            {"sim:htm?imperfections=off",
             line,
             line == ServedLine::Pty ? "" : "127.0.0.1:0",
             seed,
             {},
             profile},
            [this](const std::string& address, bool) { announce(address); }, m_interrupt);
        if (!served) {
            announce(served.error().message);
        }
    }
    void announce(const std::string& address) {
        const std::lock_guard lock(m_mutex);
        m_address = address;
        m_changed.notify_all();
    }

    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::string m_address;
    std::atomic<int> m_interrupt{0};
    std::thread m_thread;
};

} // namespace halbench::devices
