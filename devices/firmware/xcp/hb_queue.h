/* SPDX-License-Identifier: MIT */
#ifndef HB_QUEUE_H
#define HB_QUEUE_H

/* Transmit queue: whole packets with their message counter. A writer first asks for room, so that a sample
 * enters whole or not at all (resources/help/protocol.md 3.3.4). */

#include "devices/firmware/xcp/hb_config.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HB_PACKET_OVERHEAD = sizeof(hb_length) + 2 }; /* length and counter of a stored packet, octets */

typedef struct {
    hb_length head, tail; /* write and read position; equal = empty, one octet stays free */
    uint16_t counter;     /* counter of the next packet, dropped ones included */
    uint8_t octets[HB_RING_OCTETS];
} hb_queue;

void hb_queue_clear(hb_queue* queue);
hb_length hb_queue_free(const hb_queue* queue);
/* Begins a packet; the caller has checked the room (packet + HB_PACKET_OVERHEAD) and puts exactly `length`
 * octets. */
void hb_queue_begin(hb_queue* queue, hb_length length);
void hb_queue_put(hb_queue* queue, const uint8_t* source, hb_length count);
/* A packet that had no room: only its counter is used up. */
void hb_queue_skip(hb_queue* queue, uint8_t packets);
/* Takes the oldest packet; 0 if there is none or it is longer than `capacity` (then it is discarded). */
hb_length hb_queue_take(hb_queue* queue, uint8_t* packet, hb_length capacity, uint16_t* counter);

#ifdef __cplusplus
}
#endif

#endif
