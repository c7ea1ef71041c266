#pragma once

#include "devices/transport/board_server.h"
#include "devices/transport/tcp_server.h"
#include "tests/devices/xcp/test_slave.h"

#include <atomic>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace halbench::devices::xcp {

/// The slave of another maker behind a TCP port, paced by the wall clock in a thread of its own.
class ForeignBoard : private ServedBoard {
public:
    using Bend = std::function<void(TestSlave&)>;

    explicit ForeignBoard(const SlaveTraits& traits = {}, const Bend& bend = {})
        : m_slave(traits), m_port(*TcpServer::listen({"127.0.0.1", 0})) {
        if (bend) {
            bend(m_slave);
        }
        (void)m_slave.open();
        m_thread = std::thread([this] { serveBoard(m_port, *this, m_interrupt); });
    }
    ~ForeignBoard() override {
        m_interrupt = 2;
        m_thread.join();
    }
    ForeignBoard(const ForeignBoard&) = delete;
    ForeignBoard& operator=(const ForeignBoard&) = delete;

    std::string uri() const { return m_port.address(); }
    /// Looks at the slave, or bends it, between two of its moments.
    template <typename Function>
    auto look(Function function) {
        const std::lock_guard lock(m_mutex);
        return function(m_slave);
    }

private:
    void advanceTo(double time_s) override {
        const std::lock_guard lock(m_mutex);
        Packet packet;
        while (m_slave.now_s() < time_s) {
            if (m_slave.receive(packet, time_s - m_slave.now_s()).value_or(false)) {
                m_outgoing.push_back(packet);
            }
        }
    }
    void receive(std::span<const std::uint8_t> packet) override {
        const std::lock_guard lock(m_mutex);
        (void)m_slave.send(packet);
    }
    bool transmit(std::vector<std::uint8_t>& packet, std::uint16_t& counter) override {
        if (m_outgoing.empty()) {
            return false;
        }
        packet = std::move(m_outgoing.front());
        m_outgoing.pop_front();
        counter = m_counter++;
        return true;
    }

    TestSlave m_slave;
    TcpServer m_port;
    std::mutex m_mutex; ///< guards the slave
    std::deque<Packet> m_outgoing;
    std::uint16_t m_counter = 0;
    std::atomic<int> m_interrupt{0};
    std::thread m_thread;
};

} // namespace halbench::devices::xcp
