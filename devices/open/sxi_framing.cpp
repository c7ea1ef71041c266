#include "devices/open/sxi_framing.h"

namespace halbench::devices {

SxiFraming::SxiFraming() {
    hb_sxi_receiver_init(&m_receiver);
}

std::span<const std::uint8_t> SxiFraming::receive(std::uint8_t octet) {
    const std::uint16_t length = hb_sxi_receive(&m_receiver, octet);
    return {hb_sxi_packet(&m_receiver), length};
}

void SxiFraming::append(std::vector<std::uint8_t>& line, std::uint16_t counter,
                        std::span<const std::uint8_t> packet) {
    if (packet.empty() || packet.size() > HB_SXI_LONGEST_PACKET) {
        return;
    }
    hb_sxi_sender sender{};
    hb_sxi_send(&sender, packet.data(), static_cast<std::uint16_t>(packet.size()), counter);
    std::uint8_t octet = 0;
    while (hb_sxi_next(&sender, &octet) != 0) {
        line.push_back(octet);
    }
}

} // namespace halbench::devices
