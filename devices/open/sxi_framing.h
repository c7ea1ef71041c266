#pragma once

#include "devices/firmware/xcp/hb_sxi.h"
#include "devices/transport/pty_server.h"

namespace halbench::devices {

/// The default serial profile (resources/help/protocol.md 3.3.3) by the board library's own code.
class SxiFraming : public PacketFraming {
public:
    SxiFraming();

    std::span<const std::uint8_t> receive(std::uint8_t octet) override;
    void append(std::vector<std::uint8_t>& line, std::uint16_t counter,
                std::span<const std::uint8_t> packet) override;

private:
    hb_sxi_receiver m_receiver{};
};

} // namespace halbench::devices
