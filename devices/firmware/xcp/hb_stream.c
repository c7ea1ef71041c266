/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_stream.h"

#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <string.h>

void hb_stream_receiver_init(hb_stream_receiver* receiver) {
    receiver->filled = 0;
}

uint16_t hb_stream_receive(hb_stream_receiver* receiver, uint8_t octet) {
    uint16_t length;
    receiver->octets[receiver->filled] = octet;
    receiver->filled++;
    if (receiver->filled < HB_STREAM_HEADER) {
        return 0;
    }
    length = hb_get16(receiver->octets);
    if (length == 0 || length > HB_MAX_CTO) {
        receiver->filled--;
        memmove(receiver->octets, &receiver->octets[1], receiver->filled);
        return 0;
    }
    if (receiver->filled < HB_STREAM_HEADER + length) {
        return 0;
    }
    receiver->filled = 0;
    return length;
}

const uint8_t* hb_stream_packet(const hb_stream_receiver* receiver) {
    return &receiver->octets[HB_STREAM_HEADER];
}

void hb_stream_header(uint8_t header[HB_STREAM_HEADER], uint16_t length, uint16_t counter) {
    hb_put16(header, length);
    hb_put16(&header[2], counter);
}
