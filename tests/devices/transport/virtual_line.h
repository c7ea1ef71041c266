#pragma once

#include "devices/open/served_simulation.h"
#include "devices/simulated/registry/simulated_device.h"
#include "devices/transport/faulty_line.h"
#include "devices/transport/message_stream.h"
#include "devices/transport/transport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace halbench::devices {

/// The simulated motor behind the line that `halbench serve` gives it, on a virtual clock: time passes only
/// inside receive(), a millisecond at a time as in the server. Thread: one.
class VirtualLine : public Transport {
public:
    VirtualLine(const std::string& query, const LineFaults& faults, std::uint64_t seed)
        : m_board(*makeSimulatedBoard(*parseDeviceUri("sim:htm?" + query), std::nullopt)), m_served(*m_board),
          m_line(m_served, faults, Random(seed), m_traffic) {}

    const LineTraffic& traffic() const { return m_traffic; }

    Result<void> open() override { return {}; }
    void close() noexcept override {}
    Result<void> send(std::span<const std::uint8_t> packet) override {
        ++m_statistics.packetsSent;
        m_line.receive(packet);
        return {};
    }
    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override {
        const double deadline_s = m_now_s + timeout_s;
        for (;;) {
            std::uint16_t counter = 0;
            if (m_line.transmit(packet, counter)) {
                ++m_statistics.packetsReceived;
                m_statistics.packetsLost += m_counters.missingBefore(counter);
                m_counters.take(counter);
                return true;
            }
            if (m_now_s >= deadline_s) {
                return false;
            }
            m_now_s = std::min(m_now_s + SimulatedBoard::Tick_s, deadline_s);
            m_line.advanceTo(m_now_s);
        }
    }
    double now_s() const override { return m_now_s; }
    TransportStatistics statistics() const override { return m_statistics; }
    std::string description() const override { return "virtual line"; }

private:
    std::unique_ptr<SimulatedBoard> m_board;
    ServedSimulation m_served;
    LineTraffic m_traffic;
    FaultyBoard m_line;
    TransportStatistics m_statistics;
    CounterWatch m_counters;
    double m_now_s = 0.0;
};

} // namespace halbench::devices
