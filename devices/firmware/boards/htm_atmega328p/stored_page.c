/* SPDX-License-Identifier: MIT */
#include "devices/firmware/boards/htm_atmega328p/stored_page.h"

#include "devices/firmware/xcp/hb_crc.h"

#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/io.h>
#include <string.h>

enum { SLOTS = 2, SLOT_STRIDE = 512 };

typedef struct {
    hb_htm_calibration page;
    uint8_t number; /* one more than that of the save before */
    uint16_t crc;   /* of all above */
} slot_content;

typedef struct {
    slot_content slot;
    volatile uint8_t left; /* octets of it to be written */
    uint8_t is_second;     /* the slot that `slot` belongs to */
    volatile uint8_t has_ended;
} store_state;

static store_state Store;

static uint16_t crcOf(uint32_t program) {
    uint16_t crc = hb_crc16(HB_CRC_START, (const uint8_t*)&program, sizeof program);
    return hb_crc16(crc, (const uint8_t*)&Store.slot, offsetof(slot_content, crc));
}

/* Reads one slot; 1 if it is whole. */
static uint8_t read(uint8_t second, uint32_t program) {
    eeprom_read_block(&Store.slot, (const void*)(second ? SLOT_STRIDE : 0U), sizeof Store.slot);
    Store.is_second = second;
    return Store.slot.crc == crcOf(program);
}

const hb_htm_calibration* stored_page_load(uint32_t program) {
    uint8_t first_is_whole = read(0, program);
    uint8_t number = Store.slot.number;
    if (read(1, program) && !(first_is_whole && (int8_t)(Store.slot.number - number) < 0)) {
        return &Store.slot.page;
    }
    return first_is_whole && read(0, program) ? &Store.slot.page : NULL;
}

/* With interrupts off: the two bits must follow each other within four cycles. */
static void writeNext(void) {
    uint8_t next = (uint8_t)(sizeof Store.slot - Store.left);
    EEAR = (uint16_t)((Store.is_second ? SLOT_STRIDE : 0U) + next);
    EEDR = ((const uint8_t*)&Store.slot)[next];
    EECR |= 1 << EEMPE;
    EECR |= 1 << EEPE;
    Store.left--;
}

uint8_t stored_page_begin(const hb_htm_calibration* page, uint32_t program) {
    uint8_t flags = SREG;
    if (Store.left > 0 || Store.has_ended) {
        return 0;
    }
    Store.slot.page = *page;
    Store.slot.number++;
    Store.slot.crc = crcOf(program);
    Store.is_second = !Store.is_second;
    Store.left = sizeof Store.slot;
    cli();
    writeNext();
    EECR |= 1 << EERIE;
    SREG = flags;
    return 1;
}

ISR(EE_READY_vect) {
    if (Store.left > 0) {
        writeNext();
    } else {
        EECR &= (uint8_t) ~(1 << EERIE);
        Store.has_ended = 1;
    }
}

uint8_t stored_page_take_end(void) {
    uint8_t has_ended = Store.has_ended;
    Store.has_ended = 0;
    return has_ended;
}
