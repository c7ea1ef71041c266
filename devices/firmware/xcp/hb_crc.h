/* SPDX-License-Identifier: MIT */
#ifndef HB_CRC_H
#define HB_CRC_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define HB_CRC_START 0xFFFFU

/* CRC16-CCITT of XCP checksum type 8: polynomial 1021, start FFFF, no reflection, no final xor. */
uint16_t hb_crc16(uint16_t crc, const uint8_t* octets, uint16_t count);

/* FNV-1a, 32 bit: a change of any table entry changes the EPK. */
uint32_t hb_hash(uint32_t hash, const uint8_t* octets, uint16_t count);

#define HB_HASH_START 2166136261UL

#ifdef __cplusplus
}
#endif

#endif
