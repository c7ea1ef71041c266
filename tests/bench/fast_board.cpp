#include "tests/bench/fast_board.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace halbench::bench {

using devices::xcp::Command;
using devices::xcp::Packet;

namespace {

constexpr std::uint8_t FirstPid = 3; // of the tests' slave
constexpr std::uint16_t MaxDto = 508;

devices::xcp::SlaveTraits traits() {
    devices::xcp::SlaveTraits traits;
    traits.maxCto = 255;
    traits.maxDto = MaxDto;
    traits.hasBlockMode = true;
    traits.hasClockCommand = false;
    return traits;
}

bool isCommand(const Packet& packet, Command command) {
    return packet[0] == static_cast<std::uint8_t>(command);
}

} // namespace

std::string FastBoard::signalName(std::size_t index) {
    return fmt::format("s{:02}", index);
}

std::string FastBoard::description(std::size_t signals) {
    std::string text = "ASAP2_VERSION 1 71 /begin PROJECT fast \"\" /begin MODULE slave \"\"\n";
    for (std::size_t i = 0; i < signals; ++i) {
        text += fmt::format("/begin MEASUREMENT {} \"signal number {} of a synthetic board\" FLOAT32_IEEE "
                            "NO_COMPU_METHOD 0 0 -1e6 1e6 ECU_ADDRESS 0x{:X} PHYS_UNIT \"A\" "
                            "/end MEASUREMENT\n",
                            signalName(i), i, 4 * i);
    }
    return text + "/end MODULE /end PROJECT\n";
}

void FastBoard::writeSample(std::vector<std::uint8_t>& packet, std::uint64_t number) {
    packet.resize(5 + 4 * Signals);
    packet[0] = FirstPid;
    const auto ticks = static_cast<std::uint32_t>(number);
    std::memcpy(&packet[1], &ticks, sizeof ticks); // both little endian
    for (std::size_t i = 0; i < Signals; ++i) {
        const float value = static_cast<float>(number % 1024) + static_cast<float>(i);
        std::memcpy(&packet[5 + 4 * i], &value, sizeof value);
    }
}

FastBoard::FastBoard() : m_slave(traits()) {
    m_slave.descriptionText = description(Signals);
    m_slave.bendAnswers = [this](const Packet& command, std::deque<Packet>& answers) {
        if (isCommand(command, Command::GetDaqEventInfo)) { // every 50 units of 1 us
            answers = {{0xFF, 0x04, 0x01, 0x00, 50, 0x03, 0x00}};
        } else if (isCommand(command, Command::GetDaqResolutionInfo)) { // 4 octets, 50 units of 1 us
            answers = {{0xFF, 1, 8, 1, 8, 0x34, 50, 0}};
        } else if (isCommand(command, Command::StartStopSynch)) {
            m_isSampling = command[1] == 1;
            m_next = m_now;
        } else if (isCommand(command, Command::UserCommand)) {
            answers = {{0xFF, 0x01}};
            const std::lock_guard lock(m_mutex);
            m_stop = m_stop.value_or(std::chrono::steady_clock::now());
            m_stopped.notify_all();
        }
    };
    (void)m_slave.open();
}

void FastBoard::advanceTo(double time_s) {
    m_now = static_cast<std::uint64_t>(time_s * Rate_Hz);
}

void FastBoard::receive(std::span<const std::uint8_t> packet) {
    (void)m_slave.send(packet);
    Packet one;
    while (m_slave.receive(one, 0.0).value_or(false)) {
        m_answers.push_back(one);
    }
}

bool FastBoard::transmit(std::vector<std::uint8_t>& packet, std::uint16_t& counter) {
    if (m_nextAnswer < m_answers.size()) {
        packet = m_answers[m_nextAnswer++];
        if (m_nextAnswer == m_answers.size()) {
            m_answers.clear();
            m_nextAnswer = 0;
        }
        counter = m_counter++;
        return true;
    }
    if (!m_isSampling || m_next >= m_now) {
        return false;
    }
    const std::uint64_t backlog = m_now - m_next;
    const auto room = static_cast<std::uint64_t>(MaxBacklog_s * Rate_Hz);
    m_worstBacklog = std::max(m_worstBacklog, backlog);
    if (backlog > room) {
        m_dropped += backlog - room;
        m_counter = static_cast<std::uint16_t>(m_counter + backlog - room);
        m_next = m_now - room;
    }
    writeSample(packet, m_next++);
    counter = m_counter++;
    return true;
}

std::optional<std::chrono::steady_clock::time_point> FastBoard::takeStop(double timeout_s) {
    std::unique_lock lock(m_mutex);
    m_stopped.wait_for(lock, std::chrono::duration<double>(timeout_s), [this] { return m_stop.has_value(); });
    return std::exchange(m_stop, std::nullopt);
}

} // namespace halbench::bench
