/* SPDX-License-Identifier: MIT */

/* The minimal board on an Arduino Uno, Nano or any ATmega328P at 16 MHz: a potentiometer on A0 is the
 * position, pin 6 (OC0A, PWM) the output, 2.5 V for no current. One context: the main loop. */

#include "devices/firmware/boards/arduino_uno/uart_line.h"
#include "devices/firmware/examples/minimal_board.h"

#include <avr/interrupt.h>
#include <avr/io.h>

#define RAD_PER_CODE (6.2831853F / 1024.0F)
#define PWM_PER_A 63.0F
#define PWM_MIDDLE 127.5F

typedef struct {
    minimal_board board;
    uart_line line;
} uno_state;

/* The interrupt handler has no argument to find it by. */
static uno_state Uno;

ISR(USART_RX_vect) {
    uart_line_take(&Uno.line);
}

static void start(void) {
    ADMUX = 1 << REFS0;
    ADCSRA = (1 << ADEN) | (1 << ADSC) | (1 << ADATE) | 7; /* A0 over and over */
    DDRD = 1 << DDD6;
    TCCR0A = (1 << COM0A1) | (1 << WGM01) | (1 << WGM00);
    TCCR0B = 1 << CS00;
    TCCR1B = (1 << WGM12) | (1 << CS11);
    OCR1A = 1999; /* 1 ms */
    minimal_board_init(&Uno.board);
    uart_line_start(&Uno.line);
    sei();
}

int main(void) {
    start();
    for (;;) {
        uart_line_serve(&Uno.line, &Uno.board.xcp);
        if (TIFR1 & (1 << OCF1A)) {
            TIFR1 = 1 << OCF1A;
            OCR0A =
                (uint8_t)(PWM_MIDDLE + PWM_PER_A * minimal_board_tick(&Uno.board, (float)ADC * RAD_PER_CODE));
        }
    }
}
