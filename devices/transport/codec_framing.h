#pragma once

#include "devices/transport/pty_server.h"
#include "devices/transport/sxi_codec.h"

namespace halbench::devices {

/// Any of the ways packets lie on a serial line, on the board's side of it.
class CodecFraming : public PacketFraming {
public:
    explicit CodecFraming(const SxiProfile& profile) : m_codec(profile) {}

    std::span<const std::uint8_t> receive(std::uint8_t octet) override;
    void append(std::vector<std::uint8_t>& line, std::uint16_t counter,
                std::span<const std::uint8_t> packet) override;
    void noteSilence() override { m_codec.noteSilence(); }

private:
    SxiCodec m_codec;
};

} // namespace halbench::devices
