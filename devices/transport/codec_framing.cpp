#include "devices/transport/codec_framing.h"

namespace halbench::devices {

namespace {

/// What every header's LEN can say.
constexpr std::size_t LongestPacket = 0xFF;

} // namespace

std::span<const std::uint8_t> CodecFraming::receive(std::uint8_t octet) {
    m_codec.feed({&octet, 1});
    const Result<std::optional<Frame>> frame = m_codec.next();
    return frame && *frame ? (*frame)->packet : std::span<const std::uint8_t>();
}

void CodecFraming::append(std::vector<std::uint8_t>& line, std::uint16_t counter,
                          std::span<const std::uint8_t> packet) {
    if (!packet.empty() && packet.size() <= LongestPacket) {
        m_codec.append(line, counter, packet);
    }
}

} // namespace halbench::devices
