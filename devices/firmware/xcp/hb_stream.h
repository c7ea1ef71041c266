/* SPDX-License-Identifier: MIT */
#ifndef HB_STREAM_H
#define HB_STREAM_H

/* Packets on a byte stream (USB bulk, TCP): LEN u16 | CTR u16 | packet, little endian
 * (resources/help/protocol.md 3.2, 3.4). Where a transfer begins or ends means nothing. */

#include "devices/firmware/xcp/hb_config.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HB_STREAM_HEADER = 4 };

typedef struct {
    uint8_t octets[HB_STREAM_HEADER + HB_MAX_CTO];
    uint16_t filled;
} hb_stream_receiver;

/* Also after a clear-halt or a reconnect. */
void hb_stream_receiver_init(hb_stream_receiver* receiver);
/* One octet. Length of a whole packet, now at hb_stream_packet(); 0 while there is none. A length that no
 * command has is skipped octet by octet, until one makes sense again. */
uint16_t hb_stream_receive(hb_stream_receiver* receiver, uint8_t octet);
const uint8_t* hb_stream_packet(const hb_stream_receiver* receiver);
/* The header of a packet of `length` octets. */
void hb_stream_header(uint8_t header[HB_STREAM_HEADER], uint16_t length, uint16_t counter);

#ifdef __cplusplus
}
#endif

#endif
