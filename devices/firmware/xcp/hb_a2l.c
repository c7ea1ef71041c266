/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_text.h"
#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <string.h>

/* The A2L text is never stored: a cursor renders it item by item and keeps only the octets asked for. An item
 * is the prologue, one signal, one parameter or the epilogue (resources/help/protocol.md 3.7, 3.13). */

#ifdef __AVR__
#define TEXT(literal) PSTR(literal)
#else
#define TEXT(literal) (literal)
#endif

typedef struct {
    uint8_t* destination;
    hb_text_offset start, end; /* wanted part of the whole text */
    hb_text_offset position;
} writer;

static void putChar(writer* out, char c) {
    if (out->position >= out->start && out->position < out->end) {
        out->destination[out->position - out->start] = (uint8_t)c;
    }
    out->position++;
}

/* What is wanted is there: the rest of the item need not be rendered. Never while only the length counts. */
static uint8_t isServed(const writer* out) {
    return out->end > 0 && out->position >= out->end;
}

/* Text in program memory; `put` below is its twin for text in RAM. */
static void putRom(writer* out, const char* text) {
    for (char c = (char)hb_rom_octet(text); c && !isServed(out); c = (char)hb_rom_octet(++text)) {
        putChar(out, c);
    }
}

static void put(writer* out, const char* text) {
    while (*text && !isServed(out)) {
        putChar(out, *text++);
    }
}

static void putFloat(writer* out, float value) {
    char text[HB_NUMBER_CAPACITY];
    if (isServed(out)) {
        return;
    }
    hb_format_float(value, text);
    put(out, text);
}

static void putUnsigned(writer* out, uint32_t value) {
    char text[HB_NUMBER_CAPACITY];
    hb_format_unsigned(value, text);
    put(out, text);
}

static void putHex(writer* out, uint32_t value) {
    char text[HB_NUMBER_CAPACITY];
    hb_format_hex(value, 4, text);
    put(out, text);
}

static void putQuoted(writer* out, const char* text) {
    putRom(out, TEXT(" \""));
    put(out, text);
    putChar(out, '"');
}

#if HB_FEATURE_TEXTS
#define putDescription(out, entry) putQuoted(out, (entry)->text)
#else
#define putDescription(out, entry) putRom(out, TEXT(" \"\""))
#endif

static void putTypeName(writer* out, uint8_t type) {
    switch (type) {
    case HB_UBYTE:
        putRom(out, TEXT("UBYTE"));
        break;
    case HB_SBYTE:
        putRom(out, TEXT("SBYTE"));
        break;
    case HB_UWORD:
        putRom(out, TEXT("UWORD"));
        break;
    case HB_SWORD:
        putRom(out, TEXT("SWORD"));
        break;
    case HB_ULONG:
        putRom(out, TEXT("ULONG"));
        break;
    case HB_SLONG:
        putRom(out, TEXT("SLONG"));
        break;
    case HB_FLOAT32:
        putRom(out, TEXT("FLOAT32_IEEE"));
        break;
    default:
        putRom(out, TEXT("FLOAT64_IEEE"));
        break;
    }
}

static void putModuleParameters(writer* out, hb_xcp* slave) {
    char epk[HB_EPK_CAPACITY];
    hb_a2l_epk(slave, epk);
    putRom(out, TEXT("/begin MOD_PAR \"\"\nEPK"));
    putQuoted(out, epk);
    putRom(out, TEXT("\n/begin MEMORY_SEGMENT Calibration \"\" DATA RAM INTERN "));
    putHex(out, HB_ADDRESS_SEGMENT);
    putChar(out, ' ');
    putHex(out, slave->description.page_octets);
    putRom(out, TEXT(" -1 -1 -1 -1 -1\n/begin IF_DATA XCP\n/begin SEGMENT 0 2 0 0 0\n"));
    for (uint8_t page = 0; page < 2; page++) {
        putRom(out, TEXT("/begin PAGE "));
        putUnsigned(out, page);
        putRom(
            out,
            TEXT(" ECU_ACCESS_DONT_CARE XCP_READ_ACCESS_DONT_CARE XCP_WRITE_ACCESS_DONT_CARE /end PAGE\n"));
    }
    putRom(out, TEXT("/end SEGMENT\n/end IF_DATA\n/end MEMORY_SEGMENT\n/end MOD_PAR\n"));
}

static void putEvents(writer* out, const hb_xcp* slave) {
    for (uint8_t i = 0; i < slave->description.event_count; i++) {
        hb_event event;
        hb_rom_copy(&event, &slave->description.events[i], sizeof event);
        putRom(out, TEXT("/begin EVENT"));
        putQuoted(out, event.name);
        putQuoted(out, event.name);
        putChar(out, ' ');
        putUnsigned(out, i);
        putRom(out, TEXT(" DAQ "));
        putUnsigned(out, HB_DAQ_LISTS);
        putChar(out, ' ');
        putUnsigned(out, event.cycle);
        putChar(out, ' ');
        putUnsigned(out, event.time_unit);
        putRom(out, TEXT(" 0 /end EVENT\n"));
    }
}

static void putTransport(writer* out, const hb_xcp* slave) {
#if HB_FEATURE_FULL
    if (slave->description.transport_a2l) {
        put(out, slave->description.transport_a2l);
        return;
    }
#else
    (void)slave;
#endif
    putRom(out, TEXT(HB_A2L_TRANSPORT));
}

static void putInterface(writer* out, const hb_xcp* slave) {
    putRom(out, TEXT("/begin IF_DATA XCP\n/begin PROTOCOL_LAYER 0x0100 1000 200 0 0 0 0 0 "));
    putUnsigned(out, HB_MAX_CTO);
    putChar(out, ' ');
    putUnsigned(out, hb_xcp_max_dto(&slave->description));
    putRom(out, TEXT(" BYTE_ORDER_MSB_LAST ADDRESS_GRANULARITY_BYTE\n/end PROTOCOL_LAYER\n"
                     "/begin DAQ DYNAMIC "));
    putUnsigned(out, HB_DAQ_LISTS);
    putChar(out, ' ');
    putUnsigned(out, slave->description.event_count);
    putRom(out, TEXT(" 0 OPTIMISATION_TYPE_DEFAULT ADDRESS_EXTENSION_FREE IDENTIFICATION_FIELD_TYPE_ABSOLUTE "
                     "GRANULARITY_ODT_ENTRY_SIZE_DAQ_BYTE 8 OVERLOAD_INDICATION_EVENT\n"
                     "/begin TIMESTAMP_SUPPORTED 1 SIZE_DWORD UNIT_1US /end TIMESTAMP_SUPPORTED\n"));
    putEvents(out, slave);
    putRom(out, TEXT("/end DAQ\n"));
    putTransport(out, slave);
    putRom(out, TEXT("/end IF_DATA\n"));
}

static void putPrologue(writer* out, hb_xcp* slave) {
    putRom(out, TEXT("ASAP2_VERSION 1 61\n/begin PROJECT "));
    put(out, slave->description.model);
    putRom(out, TEXT(" \"\"\n/begin MODULE "));
    put(out, slave->description.model);
    putRom(out, TEXT(" \"\"\n/begin MOD_COMMON \"\"\nBYTE_ORDER MSB_LAST\n/end MOD_COMMON\n"));
    putModuleParameters(out, slave);
    putInterface(out, slave);
    for (uint8_t type = HB_UBYTE; type <= HB_FLOAT64; type++) {
        putRom(out, TEXT("/begin RECORD_LAYOUT RL."));
        putTypeName(out, type);
        putRom(out, TEXT(" FNC_VALUES 1 "));
        putTypeName(out, type);
        putRom(out, TEXT(" ROW_DIR DIRECT /end RECORD_LAYOUT\n"));
    }
}

/* Names of the values, "|" between them in the table. */
static void putChoices(writer* out, const char* name, const char* choices) {
    uint8_t count = 1;
    const char* at;
    for (at = choices; hb_rom_octet(at); at++) {
        count = (uint8_t)(count + (hb_rom_octet(at) == '|'));
    }
    putRom(out, TEXT("/begin COMPU_VTAB VT."));
    put(out, name);
    putRom(out, TEXT(" \"\" TAB_VERB "));
    putUnsigned(out, count);
    at = choices;
    for (uint8_t value = 0; value < count; value++) {
        putChar(out, ' ');
        putUnsigned(out, value);
        putRom(out, TEXT(" \""));
        for (; hb_rom_octet(at) && hb_rom_octet(at) != '|'; at++) {
            putChar(out, (char)hb_rom_octet(at));
        }
        at++;
        putChar(out, '"');
    }
    putRom(out, TEXT(" /end COMPU_VTAB\n"));
}

/* How a raw value becomes a physical one. */
typedef struct {
    float scale;
    const char* digits; /* the factor as text, where a float is not exact enough; or NULL */
    const char* choices;
} conversion;

/* Conversion of one entry; returns 0 if it needs none. */
static uint8_t putConversion(writer* out, const char* name, const char* unit, conversion rule) {
    if (!rule.choices && rule.scale == 1.0F) {
        return 0;
    }
    if (rule.choices) {
        putChoices(out, name, rule.choices);
    }
    putRom(out, TEXT("/begin COMPU_METHOD CM."));
    put(out, name);
    putRom(out, TEXT(" \"\" "));
    putRom(out, rule.choices ? TEXT("TAB_VERB \"%.0f\"") : TEXT("LINEAR \"%.6g\""));
    putQuoted(out, unit);
    if (rule.choices) {
        putRom(out, TEXT(" COMPU_TAB_REF VT."));
        put(out, name);
    } else {
        putRom(out, TEXT(" COEFFS_LINEAR "));
        if (rule.digits) {
            putRom(out, rule.digits);
        } else {
            putFloat(out, rule.scale);
        }
        putRom(out, TEXT(" 0"));
    }
    putRom(out, TEXT(" /end COMPU_METHOD\n"));
    return 1;
}

static void putConversionName(writer* out, const char* name, uint8_t has_conversion) {
    if (has_conversion) {
        putRom(out, TEXT("CM."));
        put(out, name);
    } else {
        putRom(out, TEXT("NO_COMPU_METHOD"));
    }
    putChar(out, ' ');
}

/* The largest ULONG is not a float: its neighbour would lie above the type. */
static void putLimits(writer* out, uint8_t type, float lower, float upper) {
    putFloat(out, lower);
    putChar(out, ' ');
    if (type == HB_ULONG && upper >= 4294967296.0F) {
        putRom(out, TEXT("4294967295"));
    } else {
        putFloat(out, upper);
    }
    putChar(out, '\n');
}

static void putUnit(writer* out, const char* unit) {
    if (unit[0]) {
        putRom(out, TEXT("PHYS_UNIT"));
        putQuoted(out, unit);
        putChar(out, '\n');
    }
}

static conversion conversionOf(const hb_signal* signal) {
    conversion rule = {signal->numbers.scale, NULL, signal->numbers.choices};
#if HB_NUMBER_DIGITS > 6
    rule.digits = signal->numbers.digits;
#endif
    return rule;
}

static void putSignal(writer* out, const hb_xcp* slave, const hb_signal* entry, uint16_t handle) {
    hb_signal signal;
    uint8_t has_conversion;
    hb_rom_copy(&signal, entry, sizeof signal);
    has_conversion = putConversion(out, signal.name, signal.unit, conversionOf(&signal));
    putRom(out, TEXT("/begin MEASUREMENT "));
    put(out, signal.name);
    putDescription(out, &signal);
    putChar(out, ' ');
    putTypeName(out, signal.numbers.type);
    putChar(out, ' ');
    putConversionName(out, signal.name, has_conversion);
    putRom(out, TEXT("0 0 "));
    putLimits(out, signal.numbers.type, signal.numbers.lower, signal.numbers.upper);
    putRom(out, TEXT("ECU_ADDRESS "));
    putHex(out, 8U * (uint32_t)handle);
    putChar(out, '\n');
    putUnit(out, signal.unit);
    putRom(out, TEXT("/begin IF_DATA XCP /begin DAQ_EVENT VARIABLE /begin AVAILABLE_EVENT_LIST"));
    for (uint8_t i = 0; i < slave->description.event_count; i++) {
        putRom(out, TEXT(" EVENT "));
        putUnsigned(out, i);
    }
    putRom(out, TEXT(" /end AVAILABLE_EVENT_LIST /end DAQ_EVENT /end IF_DATA\n/end MEASUREMENT\n"));
}

static uint32_t addressOf(const hb_parameter_numbers* parameter) {
    switch (parameter->space) {
    case HB_PAGED:
        return HB_ADDRESS_SEGMENT + parameter->offset;
    case HB_LIVE:
        return HB_ADDRESS_LIVE + parameter->offset;
    default:
        return parameter->offset;
    }
}

static void putCharacteristic(writer* out, const hb_parameter* parameter) {
    conversion words = {1.0F, NULL, parameter->numbers.choices};
    uint8_t has_conversion = putConversion(out, parameter->name, parameter->unit, words);
    putRom(out, TEXT("/begin CHARACTERISTIC "));
    put(out, parameter->name);
    putDescription(out, parameter);
    putRom(out, parameter->numbers.space == HB_BLOCK ? TEXT(" VAL_BLK ") : TEXT(" VALUE "));
    putHex(out, addressOf(&parameter->numbers));
    putRom(out, TEXT(" RL."));
    putTypeName(out, parameter->numbers.type);
    putRom(out, TEXT(" 0 "));
    putConversionName(out, parameter->name, has_conversion);
    putLimits(out, parameter->numbers.type, parameter->numbers.lower, parameter->numbers.upper);
    putUnit(out, parameter->unit);
#if HB_FEATURE_CAPTURE
    if (parameter->numbers.space == HB_BLOCK) {
        putRom(out, TEXT("ECU_ADDRESS_EXTENSION 2\nREAD_ONLY\nMATRIX_DIM "));
        putUnsigned(out, parameter->numbers.columns);
        putChar(out, ' ');
        putUnsigned(out, parameter->numbers.rows);
        putRom(out, TEXT(" 1\n"));
    }
#endif
    putRom(out, TEXT("/end CHARACTERISTIC\n"));
}

static void putParameter(writer* out, const hb_parameter* entry) {
    hb_parameter parameter;
    size_t end;
    hb_rom_copy(&parameter, entry, sizeof parameter);
    if (parameter.numbers.space == HB_BLOCK || parameter.numbers.rows == 1) {
        putCharacteristic(out, &parameter);
        return;
    }
    end = strlen(parameter.name);
    parameter.name[end] = '_';
    for (hb_extent row = 1; row <= parameter.numbers.rows; row++) {
        char number[HB_NUMBER_CAPACITY];
        hb_format_unsigned(row, number);
        strncpy(&parameter.name[end + 1], number, sizeof parameter.name - end - 2U);
        putCharacteristic(out, &parameter);
        parameter.numbers.offset =
            (uint16_t)(parameter.numbers.offset + hb_type_size(parameter.numbers.type));
    }
}

/* Returns 0 behind the last item. */
static uint8_t putItem(writer* out, hb_xcp* slave, uint16_t item) {
    const hb_xcp_description* description = &slave->description;
    uint16_t own = description->signals[0].count;
    uint16_t signals = (uint16_t)(own + description->signals[1].count);
    if (item == 0) {
        putPrologue(out, slave);
    } else if (item <= own) {
        putSignal(out, slave, &description->signals[0].entries[item - 1], (uint16_t)(item - 1));
    } else if (item <= signals) {
        putSignal(out, slave, &description->signals[1].entries[item - 1 - own], (uint16_t)(item - 1));
    } else if (item <= signals + description->parameter_count) {
        putParameter(out, &description->parameters[item - 1 - signals]);
    } else {
        putRom(out, TEXT("/end MODULE\n/end PROJECT\n"));
        return 0;
    }
    return 1;
}

uint32_t hb_a2l_length(hb_xcp* slave) {
    if (slave->a2l.length == 0) {
        writer out = {NULL, 0, 0, 0};
        uint16_t item = 0;
        while (putItem(&out, slave, item)) {
            item++;
        }
        slave->a2l.length = out.position;
    }
    return slave->a2l.length;
}

void hb_a2l_read(hb_xcp* slave, uint32_t offset, uint8_t* destination, uint16_t count) {
    writer out = {destination, (hb_text_offset)offset, (hb_text_offset)(offset + count), 0};
    uint16_t item = 0;
    if (offset >= slave->a2l.item_offset) {
        item = slave->a2l.item;
        out.position = slave->a2l.item_offset;
    }
    for (;;) {
        slave->a2l.item = item;
        slave->a2l.item_offset = out.position;
        if (!putItem(&out, slave, item) || out.position >= offset + count) {
            return;
        }
        item++;
    }
}
