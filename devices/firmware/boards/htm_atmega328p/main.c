/* SPDX-License-Identifier: MIT */

/* Controller board of the Halbach motor on an ATmega328P at 16 MHz: Hall sensors on ADC0 and ADC1, coil
 * temperatures on ADC2 and ADC3 (5 V reference), two MCP4725 converters at 0x60 and 0x61, HB-SxI on the UART
 * at 115200 Bd. Interrupts only move octets and count milliseconds; everything else runs in the main loop. */

#include "devices/firmware/htm/hb_htm.h"
#include "devices/firmware/xcp/hb_crc.h"
#include "devices/firmware/xcp/hb_sxi.h"

#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/io.h>

enum { RECEIVE_RING = 64, DAC_ADDRESS = 0x60, STORED_SIZE = sizeof(hb_htm_calibration) };

typedef struct {
    hb_htm motor;
    hb_sxi_receiver receiver;
    hb_sxi_sender sender;
    volatile uint8_t received[RECEIVE_RING];
    volatile uint8_t received_head, received_tail;
    volatile uint8_t sending;
    volatile uint8_t milliseconds;
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

ISR(TIMER1_COMPA_vect) {
    Board.milliseconds++;
}

static void startUart(void) {
    UCSR0A = 1 << U2X0; /* before the divider */
    UBRR0 = 16;         /* 115200 Bd at 16 MHz, 2.1 % fast */
    UCSR0C = (1 << UCSZ01) | (1 << UCSZ00);
    UCSR0B = (1 << RXEN0) | (1 << TXEN0) | (1 << RXCIE0);
}

static void startTick(void) {
    TCCR1B = (1 << WGM12) | (1 << CS11); /* 2 MHz, restart at OCR1A */
    OCR1A = 1999;
    TIMSK1 = 1 << OCIE1A;
}

static void startConverters(void) {
    ADCSRA = (1 << ADEN) | (1 << ADPS2) | (1 << ADPS1); /* 250 kHz */
    TWBR = 12;                                          /* 400 kHz */
}

static float readChannel(uint8_t channel) {
    ADMUX = (uint8_t)((1 << REFS0) | channel);
    ADCSRA |= 1 << ADSC;
    while (ADCSRA & (1 << ADSC)) {
    }
    return (float)ADC;
}

/* Waits for the bus, but not for ever: a converter that hangs must not hang the loop. */
static void twi(uint8_t control) {
    uint8_t patience = 255;
    TWCR = (uint8_t)(control | (1 << TWINT) | (1 << TWEN));
    while (!(TWCR & (1 << TWINT)) && --patience) {
    }
}

static void twiOctet(uint8_t octet) {
    TWDR = octet;
    twi(0);
}

static void writeDac(uint8_t channel, uint16_t code) {
    twi(1 << TWSTA);
    twiOctet((uint8_t)((DAC_ADDRESS + channel) << 1));
    twiOctet((uint8_t)(code >> 8)); /* fast write: power-down bits 0, upper four bits */
    twiOctet((uint8_t)code);
    TWCR = (1 << TWINT) | (1 << TWEN) | (1 << TWSTO);
}

static void runTick(void) {
    hb_htm_inputs inputs;
    hb_htm_outputs outputs;
    for (uint8_t i = 0; i < 2; i++) {
        inputs.hall_code[i] = readChannel(i);
    }
    for (uint8_t i = 0; i < 2; i++) {
        inputs.temperature_code[i] = readChannel((uint8_t)(2 + i));
    }
    hb_htm_fast_tick(&Board.motor, &inputs, &outputs);
    writeDac(0, outputs.dac_code[0]);
    writeDac(1, outputs.dac_code[1]);
}

static void serveReceiver(void) {
    while (Board.received_tail != Board.received_head) {
        uint8_t octet = Board.received[Board.received_tail];
        uint16_t length = hb_sxi_receive(&Board.receiver, octet);
        Board.received_tail = (uint8_t)((Board.received_tail + 1U) % RECEIVE_RING);
        if (length > 0) {
            hb_htm_receive(&Board.motor, hb_sxi_packet(&Board.receiver), length);
        }
    }
}

static void serveSender(void) {
    uint8_t packet[HB_MAX_DTO];
    uint16_t length;
    if (Board.sending) {
        return;
    }
    length = hb_htm_transmit(&Board.motor, packet, sizeof packet);
    if (length > 0) {
        hb_sxi_send(&Board.sender, packet, length, hb_htm_counter(&Board.motor));
        Board.sending = 1;
        UCSR0B |= 1 << UDRIE0;
    }
}

/* The calibration lies in EEPROM behind its CRC. */
static uint8_t loadCalibration(hb_htm_calibration* page) {
    eeprom_read_block(page, (const void*)2, STORED_SIZE);
    return eeprom_read_word((const uint16_t*)0) == hb_crc16(HB_CRC_START, (const uint8_t*)page, STORED_SIZE);
}

int main(void) {
    hb_htm_calibration stored;
    hb_htm_config config = {0};
    config.stored = loadCalibration(&stored) ? &stored : NULL;
    hb_htm_init(&Board.motor, &config);
    hb_sxi_receiver_init(&Board.receiver);
    startUart();
    startTick();
    startConverters();
    sei();
    for (;;) {
        serveReceiver();
        serveSender();
        if (Board.milliseconds > 0) {
            Board.milliseconds = 0; /* a late tick is not made up for: the loop time is what it is */
            runTick();
        }
    }
}
