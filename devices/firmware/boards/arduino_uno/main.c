/* SPDX-License-Identifier: MIT */

/* The minimal board on an Arduino Uno, Nano or any ATmega328P at 16 MHz: a potentiometer on A0 is the
 * position, pin 6 (OC0A, PWM) the output, 2.5 V for no current. One context: the main loop. */

#include "devices/firmware/examples/minimal_board.h"
#include "devices/firmware/xcp/hb_sxi.h"

#include <avr/interrupt.h>
#include <avr/io.h>

enum { RECEIVE_RING = 64 };
#define RAD_PER_CODE (6.2831853F / 1024.0F)
#define PWM_PER_A 63.0F
#define PWM_MIDDLE 127.5F

typedef struct {
    minimal_board board;
    hb_sxi_receiver receiver;
    hb_sxi_sender sender;
    volatile uint8_t ring[RECEIVE_RING];
    volatile uint8_t head, tail;
} uno_state;

/* The interrupt handler has no argument to find it by. */
static uno_state Uno;

ISR(USART_RX_vect) {
    Uno.ring[Uno.head] = UDR0;
    Uno.head = (uint8_t)((Uno.head + 1U) % RECEIVE_RING);
}

static void start(void) {
    UCSR0A = 1 << U2X0;
    UBRR0 = 16; /* 115200 Bd */
    UCSR0B = (1 << RXEN0) | (1 << TXEN0) | (1 << RXCIE0);
    ADMUX = 1 << REFS0;
    ADCSRA = (1 << ADEN) | (1 << ADSC) | (1 << ADATE) | 7; /* A0 over and over */
    DDRD = 1 << DDD6;
    TCCR0A = (1 << COM0A1) | (1 << WGM01) | (1 << WGM00);
    TCCR0B = 1 << CS00;
    TCCR1B = (1 << WGM12) | (1 << CS11);
    OCR1A = 1999; /* 1 ms */
    minimal_board_init(&Uno.board);
    hb_sxi_receiver_init(&Uno.receiver);
    sei();
}

static void serveLine(void) {
    uint8_t octet;
    if (Uno.tail != Uno.head) {
        uint16_t length = hb_sxi_receive(&Uno.receiver, Uno.ring[Uno.tail]);
        Uno.tail = (uint8_t)((Uno.tail + 1U) % RECEIVE_RING);
        if (length > 0) {
            hb_xcp_receive(&Uno.board.xcp, hb_sxi_packet(&Uno.receiver), length);
        }
    }
    if (!(UCSR0A & (1 << UDRE0))) {
        return;
    }
    if (hb_sxi_next(&Uno.sender, &octet)) {
        UDR0 = octet;
    } else {
        uint16_t length = hb_xcp_transmit(&Uno.board.xcp, hb_sxi_room(&Uno.sender), HB_SXI_LONGEST_PACKET);
        if (length > 0) {
            hb_sxi_start(&Uno.sender, length, hb_xcp_counter(&Uno.board.xcp));
        }
    }
}

int main(void) {
    start();
    for (;;) {
        serveLine();
        if (TIFR1 & (1 << OCF1A)) {
            TIFR1 = 1 << OCF1A;
            OCR0A =
                (uint8_t)(PWM_MIDDLE + PWM_PER_A * minimal_board_tick(&Uno.board, (float)ADC * RAD_PER_CODE));
        }
    }
}
