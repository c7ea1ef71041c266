/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_queue.h"

enum { RING_MASK = HB_RING_OCTETS - 1 };

void hb_queue_clear(hb_queue* queue) {
    queue->head = 0;
    queue->tail = 0;
}

hb_length hb_queue_free(const hb_queue* queue) {
    return (hb_length)((queue->tail - queue->head - 1U) & RING_MASK);
}

void hb_queue_put(hb_queue* queue, const uint8_t* source, hb_length count) {
    hb_length head = queue->head;
    for (; count > 0; count--) {
        queue->octets[head] = *source++;
        head = (hb_length)((head + 1U) & RING_MASK);
    }
    queue->head = head;
}

static void takeOctets(hb_queue* queue, uint8_t* destination, hb_length count) {
    hb_length tail = queue->tail;
    for (; count > 0; count--) {
        *destination++ = queue->octets[tail];
        tail = (hb_length)((tail + 1U) & RING_MASK);
    }
    queue->tail = tail;
}

/* Both in the processor's order of octets: they never leave it. */
void hb_queue_begin(hb_queue* queue, hb_length length) {
    hb_queue_put(queue, (const uint8_t*)&length, sizeof length);
    hb_queue_put(queue, (const uint8_t*)&queue->counter, sizeof queue->counter);
    queue->counter++;
}

void hb_queue_skip(hb_queue* queue, uint8_t packets) {
    queue->counter = (uint16_t)(queue->counter + packets);
}

hb_length hb_queue_take(hb_queue* queue, uint8_t* packet, hb_length capacity, uint16_t* counter) {
    hb_length length;
    if (queue->head == queue->tail) {
        return 0;
    }
    takeOctets(queue, (uint8_t*)&length, sizeof length);
    takeOctets(queue, (uint8_t*)counter, sizeof *counter);
    if (length > capacity) {
        queue->tail = (hb_length)((queue->tail + length) & RING_MASK);
        return 0;
    }
    takeOctets(queue, packet, length);
    return length;
}
