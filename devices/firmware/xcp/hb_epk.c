/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_crc.h"
#include "devices/firmware/xcp/hb_text.h"
#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <string.h>

/* The EPK names the library's version and the contents of all tables, so that a host may keep the A2L it has
 * read before (resources/help/protocol.md 3.7). */

static uint32_t hashNumber(uint32_t hash, uint32_t number) {
    uint8_t octets[4];
    hb_put32(octets, number);
    return hb_hash(hash, octets, sizeof octets);
}

static uint32_t hashText(uint32_t hash, const char* choices) {
    for (; choices && hb_rom_octet(choices); choices++) {
        uint8_t octet = hb_rom_octet(choices);
        hash = hb_hash(hash, &octet, 1);
    }
    return hash;
}

#if HB_FEATURE_FULL

static uint32_t hashFloat(uint32_t hash, float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return hashNumber(hash, bits);
}

static uint32_t hashSignal(uint32_t hash, const hb_signal* entry) {
    hb_signal signal;
    hb_rom_copy(&signal, entry, sizeof signal);
    hash = hashNumber(hash, ((uint32_t)signal.numbers.type << 16) | signal.numbers.offset);
    hash = hashFloat(hash, signal.numbers.scale);
    hash = hashFloat(hash, signal.numbers.lower);
    hash = hashFloat(hash, signal.numbers.upper);
    hash = hashText(hash, signal.numbers.choices);
#if HB_NUMBER_DIGITS > 6
    hash = hashText(hash, signal.numbers.digits);
#endif
    hash = hb_hash(hash, (const uint8_t*)signal.name, sizeof signal.name);
    hash = hb_hash(hash, (const uint8_t*)signal.unit, sizeof signal.unit);
    return hb_hash(hash, (const uint8_t*)signal.text, sizeof signal.text);
}

static uint32_t hashParameter(uint32_t hash, const hb_parameter* entry) {
    hb_parameter parameter;
    hb_rom_copy(&parameter, entry, sizeof parameter);
    hash = hashNumber(hash, ((uint32_t)parameter.numbers.type << 24) |
                                ((uint32_t)parameter.numbers.space << 16) | parameter.numbers.offset);
    hash = hashNumber(hash, parameter.numbers.rows);
    hash = hashFloat(hash, parameter.numbers.initial);
    hash = hashFloat(hash, parameter.numbers.lower);
    hash = hashFloat(hash, parameter.numbers.upper);
    hash = hashText(hash, parameter.numbers.choices);
    hash = hb_hash(hash, (const uint8_t*)parameter.name, sizeof parameter.name);
    hash = hb_hash(hash, (const uint8_t*)parameter.unit, sizeof parameter.unit);
    return hb_hash(hash, (const uint8_t*)parameter.text, sizeof parameter.text);
}

#else

/* A small board's tables do not move while its program stays the same, so their octets stand for them. */
static uint32_t hashOctets(uint32_t hash, const void* table, uint16_t octets) {
    const uint8_t* at = (const uint8_t*)table;
    for (; octets > 0; octets--, at++) {
        uint8_t octet = hb_rom_octet(at);
        hash = hb_hash(hash, &octet, 1);
    }
    return hash;
}

static uint32_t hashSignal(uint32_t hash, const hb_signal* entry) {
    hb_signal_numbers signal;
    hb_signal_read(entry, &signal);
    return hashOctets(hashText(hash, signal.choices), entry, sizeof *entry);
}

static uint32_t hashParameter(uint32_t hash, const hb_parameter* entry) {
    hb_parameter_numbers parameter;
    hb_parameter_read(entry, &parameter);
    return hashOctets(hashText(hash, parameter.choices), entry, sizeof *entry);
}

#endif

static uint32_t hashTables(const hb_xcp_description* description) {
    uint32_t hash = hashNumber(HB_HASH_START, ((uint32_t)hb_xcp_max_dto(description) << 16) | HB_MAX_CTO);
#if HB_FEATURE_FULL
    hash = hashText(hash, description->transport_a2l);
#endif
    for (uint8_t table = 0; table < 2; table++) {
        for (uint16_t i = 0; i < description->signals[table].count; i++) {
            hash = hashSignal(hash, &description->signals[table].entries[i]);
        }
    }
    for (uint16_t i = 0; i < description->parameter_count; i++) {
        hash = hashParameter(hash, &description->parameters[i]);
    }
    return hash;
}

void hb_a2l_epk(hb_xcp* slave, char text[HB_EPK_CAPACITY]) {
    const char* variant = slave->description.variant;
    size_t used = sizeof HB_LIBRARY_VERSION - 1;
    size_t room;
    if (slave->a2l.epk_hash == 0) {
        slave->a2l.epk_hash = hashTables(&slave->description);
    }
    memcpy(text, HB_LIBRARY_VERSION, used);
    text[used++] = '-';
    hb_format_hex(slave->a2l.epk_hash, 8, &text[used]);
    used += 10;
    room = HB_EPK_CAPACITY - 1 - used;
    if (variant) {
        size_t octets = strlen(variant) < room ? strlen(variant) : room;
        memcpy(&text[used], variant, octets);
        used += octets;
    }
    text[used] = 0;
}
