/* SPDX-License-Identifier: MIT */
#include "devices/firmware/boards/htm_atmega328p/outputs.h"

#include <avr/interrupt.h>
#include <avr/io.h>

enum { CONVERTERS = 2, FIRST_ADDRESS = 0x60, OCTETS = 3 };
enum {
    STATUS_MASK = 0xF8,
    STATUS_START = 0x08,
    STATUS_RESTART = 0x10,
    STATUS_ADDRESSED = 0x18,
    STATUS_TAKEN = 0x28
};
enum { GO = (1 << TWINT) | (1 << TWEN) | (1 << TWIE) };

typedef struct {
    uint16_t code[CONVERTERS];
    volatile uint8_t converter; /* being written; CONVERTERS: none */
    volatile uint8_t octet;     /* the next one of the three */
    volatile uint8_t has_failed;
} output_state;

static output_state Outputs;

void outputs_start(void) {
    TWBR = 12; /* 400 kHz */
    Outputs.converter = CONVERTERS;
}

void outputs_write(const uint16_t code[2]) {
    Outputs.code[0] = code[0];
    Outputs.code[1] = code[1];
    Outputs.converter = 0;
    Outputs.octet = 0;
    TWCR = GO | (1 << TWSTA);
}

uint8_t outputs_are_well(void) {
    uint8_t is_well = !Outputs.has_failed && Outputs.converter == CONVERTERS;
    Outputs.has_failed = 0;
    return is_well;
}

/* Also behind one that does not answer: the other one must come to zero. */
static void nextConverter(void) {
    Outputs.converter++;
    Outputs.octet = 0;
    TWCR = Outputs.converter < CONVERTERS ? GO | (1 << TWSTA) : (1 << TWINT) | (1 << TWEN) | (1 << TWSTO);
}

static uint8_t isAcknowledged(uint8_t status) {
    return status == STATUS_START || status == STATUS_RESTART || status == STATUS_ADDRESSED ||
           status == STATUS_TAKEN;
}

/* The fast write: address, power-down bits 0 with the upper four bits, the lower eight. */
ISR(TWI_vect) {
    uint8_t converter = Outputs.converter;
    uint8_t octet = Outputs.octet;
    if (!isAcknowledged(TWSR & STATUS_MASK)) {
        Outputs.has_failed = 1;
        octet = OCTETS;
    }
    if (octet == OCTETS) {
        nextConverter();
        return;
    }
    if (octet == 0) {
        TWDR = (uint8_t)((FIRST_ADDRESS + converter) << 1);
    } else {
        TWDR = (uint8_t)(octet == 1 ? Outputs.code[converter] >> 8 : Outputs.code[converter]);
    }
    Outputs.octet = (uint8_t)(octet + 1U);
    TWCR = GO;
}
