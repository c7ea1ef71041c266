/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_crc.h"
#include "devices/firmware/xcp/hb_text.h"
#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <string.h>

/* The EPK names the library's version and the contents of all tables, so that a host may keep the A2L it has
 * read before (resources/help/protocol.md 3.7). */

#ifdef __AVR__

/* From the linker: behind the constants that lie in flash, which are in front of the program. */
extern const uint8_t __ctors_start[];

/* All tables are constants in flash, so that these octets stand for them: Fletcher's two sums, which are
 * quick. */
static uint32_t hashTables(const hb_xcp_description* description) {
    uint16_t sum = 0;
    uint16_t sum_of_sums = 0;
    (void)description;
    for (const uint8_t* at = NULL; at != __ctors_start; at++) {
        sum = (uint16_t)(sum + hb_rom_octet(at));
        sum_of_sums = (uint16_t)(sum_of_sums + sum);
    }
    return ((uint32_t)sum_of_sums << 16) | sum;
}

#else

static uint32_t hashNumber(uint32_t hash, uint32_t number) {
    uint8_t octets[4];
    hb_put32(octets, number);
    return hb_hash(hash, octets, sizeof octets);
}

static uint32_t hashWord(uint32_t hash, hb_rom_char* word) {
    for (; word && *word; word++) {
        uint8_t octet = (uint8_t)*word;
        hash = hb_hash(hash, &octet, 1);
    }
    return hash;
}

/* Word by word and number by number: where words lie and what pads a structure says nothing. */
static uint32_t hashEntry(uint32_t hash, const hb_entry* entry) {
    hash = hashNumber(hash, ((uint32_t)entry->type << 16) | entry->offset);
    hash = hb_hash(hash, (const uint8_t*)&entry->lower, sizeof entry->lower);
    hash = hb_hash(hash, (const uint8_t*)&entry->upper, sizeof entry->upper);
    hash = hashWord(hash, entry->choices);
    hash = hashWord(hash, entry->words);
    hash = hashWord(hash, hb_words_at(entry->words, 1));
#if HB_FEATURE_TEXTS
    hash = hashWord(hash, hb_words_at(entry->words, 2));
#endif
    return hash;
}

static uint32_t hashSignal(uint32_t hash, const hb_signal* entry) {
    hb_signal signal;
    hb_signal_read(entry, &signal);
    hash = hashEntry(hash, &signal.entry);
#if HB_NUMBER_DIGITS > 6
    hash = hashWord(hash, signal.digits);
#endif
    return hb_hash(hash, (const uint8_t*)&signal.scale, sizeof signal.scale);
}

static uint32_t hashParameter(uint32_t hash, const hb_parameter* entry) {
    hb_parameter parameter;
    hb_parameter_read(entry, &parameter);
    hash = hashEntry(hash, &parameter.entry);
    hash = hashNumber(hash, ((uint32_t)parameter.space << 16) | parameter.rows);
    return hb_hash(hash, (const uint8_t*)&parameter.initial, sizeof parameter.initial);
}

static uint32_t hashTables(const hb_xcp_description* description) {
    uint32_t hash = hashNumber(HB_HASH_START, ((uint32_t)hb_xcp_max_dto(description) << 16) | HB_MAX_CTO);
#if HB_FEATURE_FULL
    if (description->transport_a2l) {
        hash = hb_hash(hash, (const uint8_t*)description->transport_a2l,
                       (uint16_t)strlen(description->transport_a2l));
    }
#endif
    for (uint8_t table = 0; table < HB_SIGNAL_TABLES; table++) {
        for (uint16_t i = 0; i < description->signals[table].count; i++) {
            hash = hashSignal(hash, &description->signals[table].entries[i]);
        }
    }
    for (uint16_t i = 0; i < hb_xcp_parameter_count(description); i++) {
        hash = hashParameter(hash, hb_xcp_parameter(description, i));
    }
    return hash;
}

#endif

void hb_a2l_identify(hb_xcp* slave) {
    slave->a2l.epk_hash = hashTables(&slave->description);
}

void hb_a2l_epk(hb_xcp* slave, char text[HB_EPK_CAPACITY]) {
    enum { PREFIX = sizeof HB_LIBRARY_VERSION + 2U, HASH_DIGITS = 8, FIXED = PREFIX + HASH_DIGITS };
    memcpy(text, HB_LIBRARY_VERSION "-0x", PREFIX);
    hb_format_hex(slave->a2l.epk_hash, HASH_DIGITS, &text[PREFIX]);
#if HB_FEATURE_FULL
    if (slave->description.variant) {
        strncpy(&text[FIXED], slave->description.variant, HB_EPK_CAPACITY - 1 - FIXED);
        text[HB_EPK_CAPACITY - 1] = 0;
    }
#endif
}
