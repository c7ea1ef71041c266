/* SPDX-License-Identifier: MIT */
#ifndef HB_UART_LINE_H
#define HB_UART_LINE_H

/* The serial line of an ATmega328P at 16 MHz: octets come by interrupt into a ring, everything else is done
 * by the main loop. */

#include "devices/firmware/xcp/hb_sxi.h"
#include "devices/firmware/xcp/hb_xcp.h"

#include <avr/io.h>

enum { HB_RECEIVE_RING = 64 };

typedef struct {
    hb_sxi_receiver receiver;
    hb_sxi_sender sender;
    volatile uint8_t ring[HB_RECEIVE_RING];
    volatile uint8_t head, tail;
} uart_line;

static inline void uart_line_start(uart_line* line) {
    UCSR0A = 1 << U2X0;
    UBRR0 = 16; /* 115200 Bd */
    UCSR0B = (1 << RXEN0) | (1 << TXEN0) | (1 << RXCIE0);
    hb_sxi_receiver_init(&line->receiver);
}

/* For the handler of USART_RX_vect. */
static inline void uart_line_take(uart_line* line) {
    line->ring[line->head] = UDR0;
    line->head = (uint8_t)((line->head + 1U) % HB_RECEIVE_RING);
}

/* One octet in and one out at most; as often as the main loop comes by. */
static inline void uart_line_serve(uart_line* line, hb_xcp* xcp) {
    uint8_t octet;
    if (line->tail != line->head) {
        uint16_t length = hb_sxi_receive(&line->receiver, line->ring[line->tail]);
        line->tail = (uint8_t)((line->tail + 1U) % HB_RECEIVE_RING);
        if (length > 0) {
            hb_xcp_receive(xcp, hb_sxi_packet(&line->receiver), length);
        }
    }
    if (!(UCSR0A & (1 << UDRE0))) {
        return;
    }
    if (hb_sxi_next(&line->sender, &octet)) {
        UDR0 = octet;
    } else {
        uint16_t length = hb_xcp_transmit(xcp, hb_sxi_room(&line->sender), HB_SXI_LONGEST_PACKET);
        if (length > 0) {
            hb_sxi_start(&line->sender, length, hb_xcp_counter(xcp));
        }
    }
}

#endif
