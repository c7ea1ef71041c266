/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_crc.h"

uint16_t hb_crc16(uint16_t crc, const uint8_t* octets, uint16_t count) {
    for (uint16_t i = 0; i < count; i++) {
        uint16_t mixed = (uint16_t)((crc >> 8) ^ octets[i]);
        mixed = (uint16_t)(mixed ^ (mixed >> 4));
        crc = (uint16_t)((crc << 8) ^ (uint16_t)(mixed << 12) ^ (uint16_t)(mixed << 5) ^ mixed);
    }
    return crc;
}

uint32_t hb_hash(uint32_t hash, const uint8_t* octets, uint16_t count) {
    for (uint16_t i = 0; i < count; i++) {
        hash = (uint32_t)((hash ^ octets[i]) * 16777619UL);
    }
    return hash;
}
