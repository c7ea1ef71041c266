#include "devices/transport/message_stream.h"

#include "control/base/assert.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::devices {

namespace {

constexpr std::size_t HeaderOctets = 4;

std::uint16_t word(const std::uint8_t* octets) {
    return static_cast<std::uint16_t>(octets[0] | (octets[1] << 8));
}

void appendWord(std::vector<std::uint8_t>& stream, std::size_t value) {
    stream.push_back(static_cast<std::uint8_t>(value));
    stream.push_back(static_cast<std::uint8_t>(value >> 8));
}

} // namespace

void MessageParser::feed(std::span<const std::uint8_t> octets) {
    m_octets.erase(m_octets.begin(), m_octets.begin() + static_cast<std::ptrdiff_t>(m_begin));
    m_begin = 0;
    m_octets.insert(m_octets.end(), octets.begin(), octets.end());
}

Result<std::optional<StreamMessage>> MessageParser::next() {
    const std::size_t available = m_octets.size() - m_begin;
    if (available < HeaderOctets) {
        return std::optional<StreamMessage>{};
    }
    const std::uint8_t* header = m_octets.data() + m_begin;
    const std::size_t length = word(header);
    if (length == 0 || length > m_maxPacket) {
        return failure(ErrorCode::Protocol,
                       fmt::format("message length {} bytes, allowed are 1 to {}", length, m_maxPacket),
                       "the other side does not use this protocol");
    }
    if (available < HeaderOctets + length) {
        return std::optional<StreamMessage>{};
    }
    m_begin += HeaderOctets + length;
    return std::optional<StreamMessage>(StreamMessage{word(header + 2), {header + HeaderOctets, length}});
}

DatagramWatch::Arrival DatagramWatch::take(std::uint16_t counter, std::span<const std::uint8_t> packet) {
    constexpr std::uint16_t HalfTurn = 0x8000;
    constexpr std::uint16_t MostRemembered = 256;
    const auto step = static_cast<std::uint16_t>(counter - m_last.value_or(counter));
    const bool isSame = m_last && step == 0;
    if (isSame && !std::equal(packet.begin(), packet.end(), m_lastPacket.begin(), m_lastPacket.end())) {
        m_isCounting = false; // another message under the same number: it does not tell repeats
    }
    if (m_isCounting && (isSame || step >= HalfTurn)) {
        return {true, 0, std::erase(m_missing, counter) > 0};
    }
    const std::uint16_t missing = m_counters.missingBefore(counter);
    for (std::uint16_t i = std::min(missing, MostRemembered); i > 0; --i) {
        m_missing.push_back(static_cast<std::uint16_t>(counter - i));
    }
    while (m_missing.size() > MostRemembered) {
        m_missing.pop_front();
    }
    m_counters.take(counter);
    m_last = counter;
    m_lastPacket.assign(packet.begin(), packet.end());
    return {false, missing, false};
}

void appendMessage(std::vector<std::uint8_t>& stream, std::uint16_t counter,
                   std::span<const std::uint8_t> packet) {
    HB_ASSERT(!packet.empty() && packet.size() <= 0xFFFF);
    appendWord(stream, packet.size());
    appendWord(stream, counter);
    stream.insert(stream.end(), packet.begin(), packet.end());
}

} // namespace halbench::devices
