/* SPDX-License-Identifier: MIT */
#ifndef HB_SXI_H
#define HB_SXI_H

/* The default serial profile "HB-SxI" (resources/help/protocol.md 3.3.3): SYNC 9A, escape 9B, header LEN CTR
 * of one octet each, sum of 16 bit words behind the packet. Octet by octet, so that interrupts can feed and
 * drain it. */

#include "devices/firmware/xcp/hb_config.h"

#include <stdint.h>

/* 0: without SYNC and escapes, for tools that know none (resources/help/protocol.md 3.3.2). Header and sum
 * stay. Nothing but a pause then tells where a frame begins: the board calls hb_sxi_receiver_init() when its
 * line was silent for 50 ms, and what a damaged frame leaves is ignored until then. */
#ifndef HB_SXI_FRAMED
#define HB_SXI_FRAMED 1
#endif

#ifdef __cplusplus
extern "C" {
#endif

enum { HB_SXI_LONGEST_PACKET = HB_MAX_DTO < 255 ? HB_MAX_DTO : 255, HB_SXI_EXTRA = 5 };

#if HB_MAX_DTO + 5 < 256 && HB_MAX_CTO + 5 < 256
typedef uint8_t hb_sxi_count;
#else
typedef uint16_t hb_sxi_count;
#endif

typedef struct {
    uint8_t packet[HB_MAX_CTO + HB_SXI_EXTRA]; /* LEN, CTR, packet, fill, sum */
    hb_sxi_count filled;
    uint8_t hunting, escaped;
} hb_sxi_receiver;

typedef struct {
    uint8_t frame[HB_SXI_LONGEST_PACKET + HB_SXI_EXTRA];
    hb_sxi_count length, next;
    uint8_t started, escaped;
} hb_sxi_sender;

void hb_sxi_receiver_init(hb_sxi_receiver* receiver);
/* One octet from the line. Length of a good packet, now at hb_sxi_packet(); 0 while there is none. A damaged
 * frame is dropped silently and the next SYNC, or without framing a pause, is waited for. */
uint16_t hb_sxi_receive(hb_sxi_receiver* receiver, uint8_t octet);
const uint8_t* hb_sxi_packet(const hb_sxi_receiver* receiver);

/* Takes a packet of at most HB_SXI_LONGEST_PACKET octets and the low octet of its counter. */
void hb_sxi_send(hb_sxi_sender* sender, const uint8_t* packet, uint16_t length, uint16_t counter);
/* The same without a copy: puts the packet where hb_sxi_room() says, then starts it. */
uint8_t* hb_sxi_room(hb_sxi_sender* sender);
void hb_sxi_start(hb_sxi_sender* sender, uint16_t length, uint16_t counter);
/* Next octet for the line; 0 when the frame is complete. */
uint8_t hb_sxi_next(hb_sxi_sender* sender, uint8_t* octet);

#ifdef __cplusplus
}
#endif

#endif
