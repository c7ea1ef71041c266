#pragma once

#include "devices/transport/board_server.h"

#include <deque>
#include <vector>

namespace halbench::devices {

using Octets = std::vector<std::uint8_t>;

/// Answers every command with FF and the command; says besides what a test tells it to.
class EchoBoard : public ServedBoard {
public:
    void advanceTo(double time_s) override { m_time_s = time_s; }
    void receive(std::span<const std::uint8_t> packet) override {
        received.emplace_back(packet.begin(), packet.end());
        Octets answer{0xFF};
        answer.insert(answer.end(), packet.begin(), packet.end());
        say(std::move(answer));
    }
    bool transmit(std::vector<std::uint8_t>& packet, std::uint16_t& counter) override {
        if (m_waiting.empty()) {
            return false;
        }
        packet = m_waiting.front();
        m_waiting.pop_front();
        counter = m_counter++;
        return true;
    }
    void say(Octets packet) { m_waiting.push_back(std::move(packet)); }
    bool hasSaidEverything() const { return m_waiting.empty(); }
    double time_s() const { return m_time_s; }

    std::vector<Octets> received;

private:
    std::deque<Octets> m_waiting;
    std::uint16_t m_counter = 0;
    double m_time_s = 0.0;
};

} // namespace halbench::devices
