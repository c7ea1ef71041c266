#pragma once

#include "devices/transport/board_server.h"
#include "tests/devices/xcp/test_slave.h"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace halbench::bench {

/// A synthetic board: so many FLOAT32 signals s00, s01 ... sampled at 20 kHz with a clock of 50 us; signal k
/// of sample n is n % 1024 + k. It keeps half a second of samples for a host that is slow, then drops them.
/// Commands are answered by the tests' slave. Thread: the one that serves; the stops any.
class FastBoard : public devices::ServedBoard {
public:
    static constexpr std::size_t Signals = 32;
    static constexpr double Rate_Hz = 20000.0;
    static constexpr double MaxBacklog_s = 0.5;

    FastBoard();

    void advanceTo(double time_s) override;
    void receive(std::span<const std::uint8_t> packet) override;
    bool transmit(std::vector<std::uint8_t>& packet, std::uint16_t& counter) override;

    /// When the next stop command arrived; waits for it no longer than this.
    std::optional<std::chrono::steady_clock::time_point> takeStop(double timeout_s);
    std::uint64_t dropped() const { return m_dropped; }
    /// The longest time a sample waited for the host so far.
    double worstBacklog_s() const { return static_cast<double>(m_worstBacklog) / Rate_Hz; }
    static std::string signalName(std::size_t index);
    /// The A2L text of a board with so many signals.
    static std::string description(std::size_t signals);
    /// One sample as it lies on the line.
    static void writeSample(std::vector<std::uint8_t>& packet, std::uint64_t number);

private:
    devices::xcp::TestSlave m_slave;
    std::vector<std::vector<std::uint8_t>> m_answers;
    std::size_t m_nextAnswer = 0;
    bool m_isSampling = false;
    std::uint64_t m_now = 0; ///< samples since power-on
    std::uint64_t m_next = 0;
    std::uint64_t m_dropped = 0;
    std::uint64_t m_worstBacklog = 0;
    std::uint16_t m_counter = 0;
    std::mutex m_mutex;
    std::condition_variable m_stopped;
    std::optional<std::chrono::steady_clock::time_point> m_stop;
};

} // namespace halbench::bench
