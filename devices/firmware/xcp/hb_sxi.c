/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_sxi.h"

#include <string.h>

enum { SYNC = 0x9A, ESCAPE = 0x9B, ESCAPED_ESCAPE = 0, ESCAPED_SYNC = 1, HEADER_OCTETS = 2, SUM_OCTETS = 2 };

/* Sum of little-endian words; `octets` is even. */
static uint16_t wordSum(const uint8_t* frame, hb_sxi_count octets) {
    uint16_t sum = 0;
    for (hb_sxi_count i = 0; i < octets; i = (hb_sxi_count)(i + 2U)) {
        sum = (uint16_t)(sum + (frame[i] | ((uint16_t)frame[i + 1] << 8)));
    }
    return sum;
}

/* Header, packet and the fill octet that makes them even. */
static hb_sxi_count summedOctets(uint8_t length) {
    return (hb_sxi_count)((HEADER_OCTETS + length + 1U) & ~1U);
}

void hb_sxi_receiver_init(hb_sxi_receiver* receiver) {
    memset(receiver, 0, sizeof *receiver);
    receiver->hunting = HB_SXI_FRAMED;
}

static void restart(hb_sxi_receiver* receiver) {
    receiver->filled = 0;
    receiver->escaped = 0;
    receiver->hunting = 0;
}

#if HB_SXI_FRAMED
/* 1 if the octet belongs to the frame, changed to its meaning. */
static uint8_t unescape(hb_sxi_receiver* receiver, uint8_t* octet) {
    if (receiver->escaped) {
        receiver->escaped = 0;
        receiver->hunting = *octet > ESCAPED_SYNC;
        *octet = *octet == ESCAPED_SYNC ? SYNC : ESCAPE;
        return !receiver->hunting;
    }
    receiver->escaped = *octet == ESCAPE;
    return !receiver->escaped;
}
#endif

static uint8_t isLength(uint16_t length) {
    return length > 0 && length <= HB_MAX_CTO;
}

uint16_t hb_sxi_receive(hb_sxi_receiver* receiver, uint8_t octet) {
    uint8_t* frame = receiver->packet;
    hb_sxi_count summed;
    uint16_t sum;
#if HB_SXI_FRAMED
    if (octet == SYNC) {
        restart(receiver);
        return 0;
    }
    if (receiver->hunting || !unescape(receiver, &octet)) {
        return 0;
    }
#else
    if (receiver->hunting) {
        return 0;
    }
#endif
    frame[receiver->filled++] = octet;
    if (!isLength(frame[0])) {
        receiver->hunting = 1;
        return 0;
    }
    summed = summedOctets(frame[0]);
    if (receiver->filled < summed + SUM_OCTETS) {
        return 0;
    }
    receiver->hunting = 1;
    sum = (uint16_t)(frame[summed] | ((uint16_t)frame[summed + 1] << 8));
    if (sum != wordSum(frame, summed)) {
        return 0;
    }
#if !HB_SXI_FRAMED
    restart(receiver); /* the next octet is the next frame's first */
#endif
    return frame[0];
}

const uint8_t* hb_sxi_packet(const hb_sxi_receiver* receiver) {
    return receiver->packet + HEADER_OCTETS;
}

uint8_t* hb_sxi_room(hb_sxi_sender* sender) {
    return &sender->frame[HEADER_OCTETS];
}

void hb_sxi_send(hb_sxi_sender* sender, const uint8_t* packet, uint16_t length, uint16_t counter) {
    memcpy(hb_sxi_room(sender), packet, length);
    hb_sxi_start(sender, length, counter);
}

void hb_sxi_start(hb_sxi_sender* sender, uint16_t length, uint16_t counter) {
    hb_sxi_count summed = summedOctets((uint8_t)length);
    uint16_t sum;
    sender->frame[0] = (uint8_t)length;
    sender->frame[1] = (uint8_t)counter;
    sender->frame[summed - 1] = (length % 2) ? 0 : sender->frame[summed - 1];
    sum = wordSum(sender->frame, summed);
    sender->frame[summed] = (uint8_t)sum;
    sender->frame[summed + 1] = (uint8_t)(sum >> 8);
    sender->length = (hb_sxi_count)(summed + SUM_OCTETS);
    sender->next = 0;
    sender->started = 0;
    sender->escaped = 0;
}

uint8_t hb_sxi_next(hb_sxi_sender* sender, uint8_t* octet) {
    uint8_t value;
    if (sender->next >= sender->length) {
        return 0;
    }
#if HB_SXI_FRAMED
    if (!sender->started) {
        sender->started = 1;
        *octet = SYNC;
        return 1;
    }
    value = sender->frame[sender->next];
    if (sender->escaped) {
        sender->escaped = 0;
        sender->next++;
        *octet = value == SYNC ? ESCAPED_SYNC : ESCAPED_ESCAPE;
        return 1;
    }
    if (value == SYNC || value == ESCAPE) {
        sender->escaped = 1;
        *octet = ESCAPE;
        return 1;
    }
#else
    value = sender->frame[sender->next];
#endif
    sender->next++;
    *octet = value;
    return 1;
}
