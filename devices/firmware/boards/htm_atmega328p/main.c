/* SPDX-License-Identifier: MIT */

/* Controller board of the Halbach motor on an ATmega328P at 16 MHz: Hall sensors on ADC0 and ADC1, coil
 * temperatures on ADC2 and ADC3 (5 V reference), two MCP4725 converters at 0x60 and 0x61, HB-SxI on the UART
 * at 115200 Bd. Port B pin 5 is high while the control tick runs.
 *
 * Timer 1 starts the conversions; when both Hall sensors are read, the converter's interrupt runs the control
 * tick with interrupts on, so that octets keep moving. Everything that takes long (commands, description)
 * runs in the main loop below it and holds the tick back by hb_board_lock() for what it must not see half
 * done. */

#include "devices/firmware/boards/htm_atmega328p/outputs.h"
#include "devices/firmware/boards/htm_atmega328p/stored_page.h"
#include "devices/firmware/htm/hb_htm.h"
#include "devices/firmware/xcp/hb_sxi.h"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <avr/wdt.h>
#include <string.h>

enum { RECEIVE_RING = 64, CHANNELS = 4, LAST_HALL = 1, LAST_CHANNEL = 3 };
enum { TIMER_COUNTS = 2000 * HB_TICK_MS }; /* of 0.5 us */
enum { FIRST_CONVERSIONS = 2 * CHANNELS };

typedef struct {
    hb_htm motor;
    hb_sxi_receiver receiver;
    hb_sxi_sender sender;
    volatile uint8_t received[RECEIVE_RING];
    volatile uint8_t received_head, received_tail;
    volatile uint8_t sending;
    volatile uint16_t code[CHANNELS];
    volatile uint8_t channel; /* being converted */
    volatile uint8_t locks, is_ticking, ticks_due;
} board_state;

/* The one instance: interrupt handlers have no argument to find it by. */
static board_state Board;

ISR(USART_RX_vect) {
    uint8_t octet = UDR0;
    uint8_t next = (uint8_t)((Board.received_head + 1U) % RECEIVE_RING);
    if (next != Board.received_tail) {
        Board.received[Board.received_head] = octet;
        Board.received_head = next;
    }
}

ISR(USART_UDRE_vect) {
    uint8_t octet;
    if (hb_sxi_next(&Board.sender, &octet)) {
        UDR0 = octet;
    } else {
        UCSR0B &= (uint8_t) ~(1 << UDRIE0);
        Board.sending = 0;
    }
}

static void convert(uint8_t channel) {
    Board.channel = channel;
    ADMUX = (uint8_t)((1 << REFS0) | channel);
    ADCSRA |= 1 << ADSC;
}

static void runTick(void) {
    hb_htm_inputs inputs;
    hb_htm_outputs outputs;
    PORTB |= 1 << PORTB5;
    for (uint8_t i = 0; i < 2; i++) {
        uint16_t hall;
        uint16_t temperature;
        cli(); /* the next conversions may end meanwhile */
        hall = Board.code[i];
        temperature = Board.code[i + 2];
        sei();
        inputs.hall_code[i] = (float)hall;
        inputs.temperature_code[i] = (float)temperature;
    }
    if (!outputs_are_well()) {
        hb_board_raise_fault(&Board.motor.board, HB_FAULT_OUTPUT);
    }
    hb_htm_fast_tick(&Board.motor, &inputs, &outputs);
    outputs_write(outputs.dac_code);
    wdt_reset();
    PORTB &= (uint8_t) ~(1 << PORTB5);
}

/* Interrupts are off here and before and after; each tick turns them on. A tick that had to wait is made up
 * for, so that ticks keep counting the time. */
static void runDueTicks(void) {
    Board.is_ticking = 1;
    while (Board.ticks_due > 0) {
        Board.ticks_due--;
        sei();
        runTick();
        cli();
    }
    Board.is_ticking = 0;
}

void hb_board_lock(void) {
    Board.locks++;
}

void hb_board_unlock(void) {
    uint8_t flags = SREG;
    cli();
    Board.locks--;
    if (Board.locks == 0 && !Board.is_ticking && Board.ticks_due > 0) {
        runDueTicks();
    }
    SREG = flags;
}

ISR(TIMER1_COMPA_vect) {
    convert(0);
}

ISR(ADC_vect) {
    uint8_t channel = Board.channel;
    Board.code[channel] = ADC;
    if (channel < LAST_CHANNEL) {
        convert((uint8_t)(channel + 1U));
    }
    if (channel == LAST_HALL) {
        Board.ticks_due++;
        if (Board.locks == 0 && !Board.is_ticking) {
            runDueTicks();
        }
    }
}

static void startUart(void) {
    UCSR0A = 1 << U2X0; /* before the divider */
    UBRR0 = 16;         /* 115200 Bd at 16 MHz, 2.1 % fast */
    UCSR0C = (1 << UCSZ01) | (1 << UCSZ00);
    UCSR0B = (1 << RXEN0) | (1 << TXEN0) | (1 << RXCIE0);
}

/* Every channel once before the first tick; the very first conversion after power-on is not exact. */
static void startConverter(void) {
    ADCSRA = (1 << ADEN) | (1 << ADPS2) | (1 << ADPS1) | (1 << ADPS0); /* 125 kHz */
    for (uint8_t i = 0; i < FIRST_CONVERSIONS; i++) {
        convert(i % CHANNELS);
        while (ADCSRA & (1 << ADSC)) {
        }
        Board.code[i % CHANNELS] = ADC;
    }
    ADCSRA |= (1 << ADIF) | (1 << ADIE);
}

static void startTicks(void) {
    DDRB = 1 << DDB5;
    TCCR1B = (1 << WGM12) | (1 << CS11); /* 2 MHz, restart at OCR1A */
    OCR1A = TIMER_COUNTS - 1;
    TIMSK1 = 1 << OCIE1A;
}

static uint8_t serveReceiver(void) {
    uint16_t length;
    if (Board.received_tail == Board.received_head) {
        return 0;
    }
    length = hb_sxi_receive(&Board.receiver, Board.received[Board.received_tail]);
    Board.received_tail = (uint8_t)((Board.received_tail + 1U) % RECEIVE_RING);
    if (length > 0) {
        hb_board_receive(&Board.motor.board, hb_sxi_packet(&Board.receiver), length);
    }
    return 1;
}

static uint8_t serveSender(void) {
    uint16_t length;
    if (Board.sending) {
        return 0;
    }
    length = hb_board_transmit(&Board.motor.board, hb_sxi_room(&Board.sender), HB_MAX_DTO);
    if (length == 0) {
        return 0;
    }
    hb_sxi_start(&Board.sender, length, hb_board_counter(&Board.motor.board));
    Board.sending = 1;
    UCSR0B |= 1 << UDRIE0;
    return 1;
}

static uint8_t store(void* context, const void* page) {
    const board_state* board = (const board_state*)context;
    return stored_page_begin((const hb_htm_calibration*)page, board->motor.board.xcp.a2l.epk_hash)
               ? HB_STORE_BEGUN
               : HB_STORE_REFUSED;
}

/* Twice where something is stored: what names the tables is known behind the first time. */
static void startMotor(void) {
    hb_htm_config config;
    memset(&config, 0, sizeof config);
    config.store = store;
    config.store_context = &Board;
    hb_htm_init(&Board.motor, &config);
    config.stored = stored_page_load(Board.motor.board.xcp.a2l.epk_hash);
    if (config.stored) {
        hb_htm_init(&Board.motor, &config);
    }
}

/* Until the next interrupt; an octet that came since the last look is not slept over. */
static void sleep(void) {
    cli();
    if (Board.received_tail == Board.received_head) {
        sleep_enable();
        sei();
        sleep_cpu();
        sleep_disable();
    }
    sei();
}

/* Not inlined: main() never returns, and what it needs of the stack is gone for ever. */
static void __attribute__((noinline)) start(void) {
    MCUSR = 0; /* else a reset by the watchdog would keep it on with its shortest time */
    wdt_enable(WDTO_120MS);
    startMotor();
    hb_sxi_receiver_init(&Board.receiver);
    outputs_start();
    startUart();
    startConverter();
    startTicks();
    set_sleep_mode(SLEEP_MODE_IDLE);
}

int main(void) {
    start();
    sei();
    for (;;) {
        uint8_t was_busy = serveReceiver();
        was_busy |= serveSender();
        if (stored_page_take_end()) {
            hb_xcp_stored(&Board.motor.board.xcp);
        }
        if (!was_busy) {
            sleep();
        }
    }
}
