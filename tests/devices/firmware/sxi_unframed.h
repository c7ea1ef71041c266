#pragma once

#include "devices/firmware/xcp/hb_sxi.h"

/// The serial line of the board library, built a second time with HB_SXI_FRAMED 0 and under these names.
extern "C" {
void plain_sxi_receiver_init(hb_sxi_receiver* receiver);
std::uint16_t plain_sxi_receive(hb_sxi_receiver* receiver, std::uint8_t octet);
const std::uint8_t* plain_sxi_packet(const hb_sxi_receiver* receiver);
void plain_sxi_send(hb_sxi_sender* sender, const std::uint8_t* packet, std::uint16_t length,
                    std::uint16_t counter);
std::uint8_t plain_sxi_next(hb_sxi_sender* sender, std::uint8_t* octet);
}
