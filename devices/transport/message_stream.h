#pragma once

#include "control/base/result.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace halbench::devices {

/// One message of the stream: LEN u16 | CTR u16 | PACKET[LEN], always little endian
/// (resources/help/protocol.md 3.2).
struct StreamMessage {
    std::uint16_t counter = 0;
    std::span<const std::uint8_t> packet; ///< valid until the next call of the parser
};

/// Cuts a byte stream into messages, whatever its split. Pure; no socket.
class MessageParser {
public:
    /// A longer LEN, or 0, is nonsense: the connection has to be closed.
    explicit MessageParser(std::size_t maxPacket) : m_maxPacket(maxPacket) {}

    void feed(std::span<const std::uint8_t> octets);
    /// The next whole message; nothing when more octets are needed. Error: Protocol, from then on.
    Result<std::optional<StreamMessage>> next();

private:
    std::size_t m_maxPacket;
    std::vector<std::uint8_t> m_octets;
    std::size_t m_begin = 0;
};

/// Follows the message counter of the other side (3.2).
class CounterWatch {
public:
    /// Messages missing between the last one and this; 0 for the first, and for one that steps back: the
    /// board counts anew, or the message came twice or was overtaken.
    std::uint16_t missingBefore(std::uint16_t counter) const {
        const auto missing = static_cast<std::uint16_t>(counter - m_last - 1);
        return m_hasLast && missing < HalfTurn ? missing : std::uint16_t{0};
    }
    void take(std::uint16_t counter) {
        m_last = counter;
        m_hasLast = true;
    }

private:
    static constexpr std::uint16_t HalfTurn = 0x8000;

    std::uint16_t m_last = 0;
    bool m_hasLast = false;
};

/// Tells what a network did to the datagrams of one session. A message that came before, or that a later one
/// overtook, is stale and has to be dropped: an old answer would pass for that of the command after it, an
/// old command would be done once more. What was overtaken was missing already when the later one came. Pure.
class DatagramWatch {
public:
    struct Arrival {
        bool isStale = false;
        std::uint16_t missing = 0; ///< messages between the last one and this
        bool isLate = false;       ///< stale, and counted as missing when a later one overtook it
    };
    Arrival take(std::uint16_t counter, std::span<const std::uint8_t> packet);

private:
    CounterWatch m_counters;
    std::optional<std::uint16_t> m_last;
    std::vector<std::uint8_t> m_lastPacket;
    std::deque<std::uint16_t> m_missing; ///< the newest, by number
    bool m_isCounting = true;            ///< the other side does not leave its counter at one value
};

/// Appends one message.
void appendMessage(std::vector<std::uint8_t>& stream, std::uint16_t counter,
                   std::span<const std::uint8_t> packet);

} // namespace halbench::devices
