#include "devices/transport/sxi_codec.h"

#include "control/base/assert.h"

#include <fmt/format.h>

#include <array>

namespace halbench::devices {

namespace {

/// What follows ESC inside a frame; fixed by the standard (resources/help/protocol.md 3.3.2).
constexpr std::uint8_t EscapedEscape = 0x00;
constexpr std::uint8_t EscapedSync = 0x01;

std::uint16_t word(const std::uint8_t* octets) {
    return static_cast<std::uint16_t>(octets[0] | (octets[1] << 8));
}

bool isWordHeader(SxiHeader header) {
    return header == SxiHeader::LenWord || header == SxiHeader::LenCtrWord ||
           header == SxiHeader::LenFillWord;
}

bool hasCounter(SxiHeader header) {
    return header == SxiHeader::LenCtrByte || header == SxiHeader::LenCtrWord;
}

} // namespace

std::string describe(const SxiProfile& profile) {
    constexpr std::array Headers = {"LEN byte", "LEN+CTR byte",  "LEN+FILL byte",
                                    "LEN word", "LEN+CTR words", "LEN+FILL words"};
    constexpr std::array Sums = {"no checksum", "byte checksum", "word checksum"};
    return fmt::format("{}, {}, {}", profile.isFramed ? "framed" : "not framed",
                       Headers[static_cast<std::size_t>(profile.header)],
                       Sums[static_cast<std::size_t>(profile.checksum)]);
}

std::size_t SxiCodec::fieldOctets() const {
    return isWordHeader(m_profile.header) ? 2 : 1;
}

std::size_t SxiCodec::headerOctets() const {
    const bool isLengthOnly =
        m_profile.header == SxiHeader::LenByte || m_profile.header == SxiHeader::LenWord;
    return isLengthOnly ? fieldOctets() : 2 * fieldOctets();
}

std::size_t SxiCodec::fillFor(std::size_t packet) const {
    return m_profile.checksum == SxiChecksum::Word ? (headerOctets() + packet) % 2 : 0;
}

std::size_t SxiCodec::checksumOctets() const {
    return static_cast<std::size_t>(m_profile.checksum);
}

std::size_t SxiCodec::messageOctets(std::size_t packet) const {
    return headerOctets() + packet + fillFor(packet) + checksumOctets();
}

std::uint16_t SxiCodec::counterMask() const {
    if (!hasCounter(m_profile.header)) {
        return 0;
    }
    return isWordHeader(m_profile.header) ? 0xFFFF : 0xFF;
}

std::uint16_t SxiCodec::sumOf(const std::uint8_t* message, std::size_t octets) const {
    unsigned sum = 0;
    if (m_profile.checksum == SxiChecksum::Byte) {
        for (std::size_t i = 0; i < octets; ++i) {
            sum += message[i];
        }
        return static_cast<std::uint8_t>(sum);
    }
    for (std::size_t i = 0; i + 1 < octets; i += 2) {
        sum += word(message + i);
    }
    return static_cast<std::uint16_t>(sum);
}

SxiCodec::Match SxiCodec::match(const std::uint8_t* message, std::size_t available) const {
    if (available < fieldOctets()) {
        return Match::Incomplete;
    }
    const std::size_t length = isWordHeader(m_profile.header) ? word(message) : message[0];
    if (length == 0 || length > MaxPacket) {
        return Match::Bad;
    }
    if (available < messageOctets(length)) {
        return Match::Incomplete;
    }
    if (m_profile.checksum == SxiChecksum::None) {
        return Match::Good;
    }
    const std::size_t summed = headerOctets() + length + fillFor(length);
    const std::uint16_t sent =
        m_profile.checksum == SxiChecksum::Byte ? message[summed] : word(message + summed);
    return sent == sumOf(message, summed) ? Match::Good : Match::Bad;
}

Frame SxiCodec::frameAt(const std::uint8_t* message) const {
    const bool isWord = isWordHeader(m_profile.header);
    Frame frame;
    if (hasCounter(m_profile.header)) {
        frame.counter = isWord ? word(message + 2) : message[1];
    }
    frame.packet = {message + headerOctets(), isWord ? word(message) : std::size_t{message[0]}};
    return frame;
}

void SxiCodec::restart() {
    m_line.clear();
    m_begin = 0;
    m_message.clear();
    m_isHunting = true;
    m_isEscaped = false;
}

void SxiCodec::feed(std::span<const std::uint8_t> octets) {
    m_line.erase(m_line.begin(), m_line.begin() + static_cast<std::ptrdiff_t>(m_begin));
    m_begin = 0;
    m_line.insert(m_line.end(), octets.begin(), octets.end());
}

Result<std::optional<Frame>> SxiCodec::next() {
    return m_profile.isFramed ? nextFramed() : nextPlain();
}

void SxiCodec::noteSilence() {
    if (!m_profile.isFramed && m_begin < m_line.size()) {
        ++m_damaged;
        restart();
    }
}

void SxiCodec::drop() {
    ++m_damaged;
    m_isHunting = true;
}

/// Puts an octet of the line into the message; true when the message may have become complete.
bool SxiCodec::takeOctet(std::uint8_t octet) {
    if (octet == m_profile.sync) {
        if (!m_isHunting) {
            ++m_damaged; // the one before was not complete
        }
        m_message.clear();
        m_isHunting = false;
        m_isEscaped = false;
        return false;
    }
    if (m_isHunting) {
        return false;
    }
    if (m_isEscaped) {
        m_isEscaped = false;
        if (octet > EscapedSync) {
            drop();
            return false;
        }
        octet = octet == EscapedSync ? m_profile.sync : m_profile.escape;
    } else if (octet == m_profile.escape) {
        m_isEscaped = true;
        return false;
    }
    m_message.push_back(octet);
    return true;
}

std::optional<Frame> SxiCodec::nextFramed() {
    while (m_begin < m_line.size()) {
        if (!takeOctet(m_line[m_begin++])) {
            continue;
        }
        const Match found = match(m_message.data(), m_message.size());
        if (found == Match::Good) {
            m_isHunting = true;
            return frameAt(m_message.data());
        }
        if (found == Match::Bad) {
            drop();
        }
    }
    return std::nullopt;
}

std::optional<Frame> SxiCodec::nextPlain() {
    while (m_begin < m_line.size()) {
        const std::uint8_t* message = m_line.data() + m_begin;
        const Match found = match(message, m_line.size() - m_begin);
        if (found == Match::Incomplete) {
            break;
        }
        if (found == Match::Good) {
            m_isHunting = false;
            const Frame frame = frameAt(message);
            m_begin += messageOctets(frame.packet.size());
            return frame;
        }
        if (!m_isHunting) {
            drop(); // once for all the octets until the next good one
        }
        ++m_begin;
    }
    return std::nullopt;
}

void SxiCodec::append(std::vector<std::uint8_t>& line, std::uint16_t counter,
                      std::span<const std::uint8_t> packet) {
    const bool isWord = isWordHeader(m_profile.header);
    HB_ASSERT(!packet.empty() && packet.size() <= (isWord ? MaxPacket : std::size_t{0xFF}));
    std::vector<std::uint8_t> message(messageOctets(packet.size()), 0);
    const auto put = [&](std::size_t place, std::size_t value, bool isTwo) {
        message[place] = static_cast<std::uint8_t>(value);
        if (isTwo) {
            message[place + 1] = static_cast<std::uint8_t>(value >> 8);
        }
    };
    put(0, packet.size(), isWord);
    if (hasCounter(m_profile.header)) {
        put(fieldOctets(), counter, isWord);
    }
    std::copy(packet.begin(), packet.end(), message.begin() + static_cast<std::ptrdiff_t>(headerOctets()));
    const std::size_t summed = message.size() - checksumOctets();
    if (m_profile.checksum != SxiChecksum::None) {
        put(summed, sumOf(message.data(), summed), m_profile.checksum == SxiChecksum::Word);
    }
    if (!m_profile.isFramed) {
        line.insert(line.end(), message.begin(), message.end());
        return;
    }
    line.push_back(m_profile.sync);
    for (const std::uint8_t octet : message) {
        const bool isSpecial = octet == m_profile.sync || octet == m_profile.escape;
        if (isSpecial) {
            line.push_back(m_profile.escape);
        }
        line.push_back(!isSpecial ? octet : octet == m_profile.sync ? EscapedSync : EscapedEscape);
    }
}

} // namespace halbench::devices
