#pragma once

#include "devices/transport/frame_codec.h"

#include <string>

namespace halbench::devices {

enum class SxiHeader { LenByte, LenCtrByte, LenFillByte, LenWord, LenCtrWord, LenFillWord };
enum class SxiChecksum { None, Byte, Word };

/// One of the ways packets lie on a serial line (resources/help/protocol.md 3.3); by default "HB-SxI".
struct SxiProfile {
    SxiHeader header = SxiHeader::LenCtrByte;
    SxiChecksum checksum = SxiChecksum::Word;
    bool isFramed = true;
    std::uint8_t sync = 0x9A;
    std::uint8_t escape = 0x9B;

    bool operator==(const SxiProfile&) const = default;
};

/// "framed, LEN+CTR byte, word checksum"
std::string describe(const SxiProfile& profile);

/// Encodes and decodes any of them. A damaged frame is dropped, counted and the next one is looked for: with
/// framing at the next SYNC, without it octet by octet (3.3.4).
class SxiCodec : public FrameCodec {
public:
    /// No board of ours sends more; what announces more is damaged.
    static constexpr std::size_t MaxPacket = 4096;

    explicit SxiCodec(SxiProfile profile) : m_profile(profile) {}

    void restart() override;
    void feed(std::span<const std::uint8_t> octets) override;
    Result<std::optional<Frame>> next() override;
    void noteSilence() override;
    void append(std::vector<std::uint8_t>& line, std::uint16_t counter,
                std::span<const std::uint8_t> packet) override;
    std::uint64_t damaged() const override { return m_damaged; }
    std::uint16_t counterMask() const override;
    /// Octets of the shortest message, SYNC and escapes not counted.
    std::size_t shortestMessage() const { return messageOctets(1); }

private:
    enum class Match { Good, Bad, Incomplete };

    std::size_t headerOctets() const;
    std::size_t fieldOctets() const;
    std::size_t fillFor(std::size_t packet) const;
    std::size_t checksumOctets() const;
    std::size_t messageOctets(std::size_t packet) const;
    std::uint16_t sumOf(const std::uint8_t* message, std::size_t octets) const;
    Match match(const std::uint8_t* message, std::size_t available) const;
    Frame frameAt(const std::uint8_t* message) const;
    std::optional<Frame> nextFramed();
    std::optional<Frame> nextPlain();
    bool takeOctet(std::uint8_t octet);
    void drop();

    SxiProfile m_profile;
    std::vector<std::uint8_t> m_line; ///< as received
    std::size_t m_begin = 0;          ///< of what is not yet looked at
    std::vector<std::uint8_t> m_message;
    bool m_isHunting = true;
    bool m_isEscaped = false;
    std::uint64_t m_damaged = 0;
};

} // namespace halbench::devices
