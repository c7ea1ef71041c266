/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_queue.h"

enum { RING_MASK = HB_RING_OCTETS - 1 };

void hb_queue_clear(hb_queue* queue) {
    queue->head = 0;
    queue->tail = 0;
}

uint16_t hb_queue_free(const hb_queue* queue) {
    uint16_t used = (uint16_t)((uint16_t)(queue->head - queue->tail) & RING_MASK);
    return (uint16_t)(RING_MASK - used);
}

static void putOctet(hb_queue* queue, uint8_t octet) {
    queue->octets[queue->head] = octet;
    queue->head = (hb_ring_index)((queue->head + 1U) & RING_MASK);
}

static uint8_t takeOctet(hb_queue* queue) {
    uint8_t octet = queue->octets[queue->tail];
    queue->tail = (hb_ring_index)((queue->tail + 1U) & RING_MASK);
    return octet;
}

void hb_queue_begin(hb_queue* queue, uint16_t length) {
    putOctet(queue, (uint8_t)length);
    putOctet(queue, (uint8_t)(length >> 8));
    putOctet(queue, (uint8_t)queue->counter);
    putOctet(queue, (uint8_t)(queue->counter >> 8));
    queue->counter++;
}

void hb_queue_put(hb_queue* queue, const uint8_t* source, uint16_t count) {
    hb_ring_index head = queue->head;
    for (uint16_t i = 0; i < count; i++) {
        queue->octets[head] = source[i];
        head = (hb_ring_index)((head + 1U) & RING_MASK);
    }
    queue->head = head;
}

void hb_queue_skip(hb_queue* queue, uint16_t packets) {
    queue->counter = (uint16_t)(queue->counter + packets);
}

uint16_t hb_queue_take(hb_queue* queue, uint8_t* packet, uint16_t capacity, uint16_t* counter) {
    uint16_t length;
    if (queue->head == queue->tail) {
        return 0;
    }
    length = takeOctet(queue);
    length = (uint16_t)(length | (uint16_t)(takeOctet(queue) << 8));
    *counter = takeOctet(queue);
    *counter = (uint16_t)(*counter | (uint16_t)(takeOctet(queue) << 8));
    for (uint16_t i = 0; i < length; i++) {
        uint8_t octet = takeOctet(queue);
        if (i < capacity) {
            packet[i] = octet;
        }
    }
    return length <= capacity ? length : 0;
}
