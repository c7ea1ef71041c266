/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_a2l_texts.h"
#include "devices/firmware/xcp/hb_text.h"
#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <string.h>

/* The A2L text is never stored: a cursor renders it item by item from templates and keeps only the octets
 * asked for. An item is a part of the prologue, one signal, one parameter or the epilogue. */

typedef struct {
    hb_xcp* slave;
    uint8_t* destination;
    hb_address start, end; /* wanted part of the whole text */
    hb_address position;
    /* What the fields of the present item stand for. */
    hb_entry entry;
    float scale; /* 1 for a parameter */
#if HB_NUMBER_DIGITS > 6
    hb_rom_char* digits;
#endif
#if HB_FEATURE_CAPTURE
    hb_extent columns, rows; /* of a block */
#endif
    hb_extent row; /* of a list, from 1 on; 0: a value by itself */
    uint32_t address;
    uint8_t index; /* of an event */
} writer;

static void putText(writer* out, hb_rom_char* text);

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

static void put(writer* out, const char* text) {
    while (*text) {
        putChar(out, *text++);
    }
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

static void putFloat(writer* out, float value) {
    char text[HB_NUMBER_CAPACITY];
    hb_format_float(value, text);
    put(out, text);
}

/* The largest ULONG is not a float: its neighbour would lie above the type. */
static void putUpper(writer* out) {
    if (out->entry.type == HB_ULONG && out->entry.upper >= 4294967296.0F) {
        putText(out, LargestUlong);
    } else {
        putFloat(out, out->entry.upper);
    }
}

static void putScale(writer* out) {
#if HB_NUMBER_DIGITS > 6
    if (out->digits) {
        putText(out, out->digits);
        return;
    }
#endif
    putFloat(out, out->scale);
}

/* Number of the words, then each with its value; '|' between them in the table. */
static void putChoices(writer* out) {
    uint8_t count = 1;
    uint8_t value = 0;
    hb_rom_char* at;
    for (at = out->entry.choices; *at; at++) {
        count = (uint8_t)(count + (*at == '|'));
    }
    putUnsigned(out, count);
    at = out->entry.choices;
    for (; value < count; value++) {
        putChar(out, ' ');
        putUnsigned(out, value);
        putChar(out, ' ');
        putChar(out, '"');
        for (; *at && *at != '|'; at++) {
            putChar(out, *at);
        }
        at++;
        putChar(out, '"');
    }
}

static void putEvents(writer* out, hb_rom_char* text) {
    for (uint8_t i = 0; i < out->slave->description.event_count; i++) {
        out->index = i;
        putText(out, text);
    }
}

static void putLayouts(writer* out) {
    for (uint8_t type = HB_UBYTE; type <= HB_FLOAT64; type++) {
        out->entry.type = type;
        putText(out, Layout);
    }
}

static void putTransport(writer* out) {
#if HB_FEATURE_FULL
    if (out->slave->description.transport_a2l) {
        put(out, out->slave->description.transport_a2l);
        return;
    }
#endif
    putText(out, Transport);
}

static void putFieldOfEvent(writer* out, uint8_t field) {
    hb_event event;
    hb_rom_copy(&event, &out->slave->description.events[out->index], sizeof event);
    if (field == FIELD_EVENT_NAME) {
        put(out, event.name);
    } else {
        putUnsigned(out, field == FIELD_CYCLE ? event.cycle : event.time_unit);
    }
}

static void putFieldOfBoard(writer* out, uint8_t field) {
    const hb_xcp_description* description = &out->slave->description;
    char epk[HB_EPK_CAPACITY];
    switch (field) {
    case FIELD_MODEL:
        put(out, description->model);
        break;
    case FIELD_EPK:
        hb_a2l_epk(out->slave, epk);
        put(out, epk);
        break;
    case FIELD_PAGE_OCTETS:
        putHex(out, description->page_octets);
        break;
    case FIELD_MAX_DTO:
        putUnsigned(out, hb_xcp_max_dto(description));
        break;
    case FIELD_EVENT_COUNT:
        putUnsigned(out, description->event_count);
        break;
    case FIELD_EVENTS:
        putEvents(out, Event);
        break;
    case FIELD_EVENT_LIST:
        putEvents(out, EventNumber);
        break;
    case FIELD_TRANSPORT:
        putTransport(out);
        break;
    case FIELD_LAYOUTS:
        putLayouts(out);
        break;
    case FIELD_INDEX:
        putUnsigned(out, out->index);
        break;
    default:
        putFieldOfEvent(out, field);
        break;
    }
}

static void putFieldOfEntry(writer* out, uint8_t field) {
    uint8_t has_method = out->entry.choices != NULL || out->scale != 1.0F;
    switch (field) {
    case FIELD_NAME:
        putText(out, out->entry.words);
        if (out->row > 0) {
            putChar(out, '_');
            putUnsigned(out, out->row);
        }
        break;
    case FIELD_UNIT:
        putText(out, hb_words_at(out->entry.words, 1));
        break;
#if HB_FEATURE_TEXTS
    case FIELD_DESCRIPTION:
        putText(out, hb_words_at(out->entry.words, 2));
        break;
#endif
    case FIELD_TYPE:
        putText(out, hb_words_at(Types, out->entry.type));
        break;
    case FIELD_SCALE:
        putScale(out);
        break;
    case FIELD_LOWER:
        putFloat(out, out->entry.lower);
        break;
    case FIELD_UPPER:
        putUpper(out);
        break;
    case FIELD_ADDRESS:
        putHex(out, out->address);
        break;
    case FIELD_CHOICES:
        putChoices(out);
        break;
    case FIELD_CONVERSION:
        putText(out, has_method ? NamedMethod : NoMethod);
        break;
    case FIELD_UNIT_LINE:
        if (*hb_words_at(out->entry.words, 1)) {
            putText(out, PhysicalUnit);
        }
        break;
#if HB_FEATURE_CAPTURE
    case FIELD_KIND:
        putText(out, out->columns ? BlockKind : ValueKind);
        break;
    case FIELD_BLOCK_LINES:
        if (out->columns) {
            putText(out, Block);
        }
        break;
    case FIELD_COLUMNS:
        putUnsigned(out, out->columns);
        break;
    case FIELD_ROWS:
        putUnsigned(out, out->rows);
        break;
#endif
    default:
        break;
    }
}

static void putText(writer* out, hb_rom_char* text) {
    for (; *text && !isServed(out); text++) {
        uint8_t octet = (uint8_t)*text;
        if (octet >= FIRST_WORD) {
            putText(out, hb_words_at(Dictionary, (uint8_t)(octet - FIRST_WORD)));
        } else if (octet >= FIRST_TEXT || octet == '\n') {
            putChar(out, (char)octet);
        } else if (octet < FIELD_NAME) {
            putFieldOfBoard(out, octet);
        } else {
            putFieldOfEntry(out, octet);
        }
    }
}

static void putMethod(writer* out) {
    if (out->entry.choices) {
        putText(out, VerbalMethod);
    } else if (out->scale != 1.0F) {
        putText(out, LinearMethod);
    }
}

static void putSignal(writer* out, const hb_signal* entry) {
    hb_signal signal;
    hb_signal_read(entry, &signal);
    out->entry = signal.entry;
    out->scale = signal.scale;
#if HB_NUMBER_DIGITS > 6
    out->digits = signal.digits;
#endif
    putMethod(out);
    putText(out, Measurement);
}

static uint32_t addressOf(const hb_parameter* parameter) {
    switch (parameter->space) {
    case HB_PAGED:
        return HB_ADDRESS_SEGMENT + parameter->entry.offset;
    case HB_LIVE:
        return HB_ADDRESS_LIVE + parameter->entry.offset;
    case HB_EXTRA:
        return HB_ADDRESS_EXTRA + parameter->entry.offset;
    default:
        return parameter->entry.offset;
    }
}

/* One row of a parameter; returns 1 if there is another one. */
static uint8_t putParameter(writer* out, const hb_parameter* entry, hb_extent row) {
    hb_parameter parameter;
    hb_extent rows;
    hb_parameter_read(entry, &parameter);
    out->entry = parameter.entry;
    out->scale = 1.0F;
    out->address = addressOf(&parameter) + (uint32_t)hb_type_size(parameter.entry.type) * row;
    rows = parameter.rows;
#if HB_FEATURE_CAPTURE
    out->columns = 0;
    if (parameter.space == HB_BLOCK) {
        out->columns = parameter.columns;
        out->rows = parameter.rows;
        rows = 1;
    }
#endif
    row++;
    out->row = rows > 1 ? row : 0U;
    putMethod(out);
    putText(out, Value);
    return row < rows;
}

enum { FIRST_SIGNAL = 3 };
enum item_end { ITEM_LAST, ITEM_ENDED, ITEM_HAS_MORE };

static enum item_end putItem(writer* out, uint16_t item, hb_extent row) {
    const hb_xcp_description* description = &out->slave->description;
    uint16_t index = (uint16_t)(item - FIRST_SIGNAL);
    const hb_signal_table* table;
    if (item == 0) {
        putText(out, Head);
        return ITEM_ENDED;
    }
    if (item < FIRST_SIGNAL) {
        putText(out, item == 1 ? Interface : InterfaceEnd);
        return ITEM_ENDED;
    }
    out->address = 8U * (uint32_t)index;
    table = hb_memory_signal_table(out->slave, &index);
    if (table) {
        putSignal(out, &table->entries[index]);
        return ITEM_ENDED;
    }
    if (index < hb_xcp_parameter_count(description)) {
        return putParameter(out, hb_xcp_parameter(description, index), row) ? ITEM_HAS_MORE : ITEM_ENDED;
    }
    putText(out, Tail);
    return ITEM_LAST;
}

/* From here on, until what is wanted is there. A read that goes on where the last one ended renders little
 * twice. */
static void putItems(writer* out, hb_a2l_cursor* cursor) {
    for (;;) {
        enum item_end end = putItem(out, cursor->item, cursor->row);
        if (isServed(out) || end == ITEM_LAST) {
            return;
        }
        cursor->item_offset = out->position;
        cursor->row = end == ITEM_HAS_MORE ? (hb_extent)(cursor->row + 1U) : 0U;
        cursor->item = (uint16_t)(cursor->item + (end == ITEM_ENDED ? 1U : 0U));
    }
}

static void rewindCursor(hb_a2l_cursor* cursor) {
    cursor->item = 0;
    cursor->row = 0;
    cursor->item_offset = 0;
}
hb_address hb_a2l_length(hb_xcp* slave) {
    if (slave->a2l.length == 0) {
        writer out;
        memset(&out, 0, sizeof out);
        out.slave = slave;
        rewindCursor(&slave->a2l);
        putItems(&out, &slave->a2l);
        slave->a2l.length = out.position;
    }
    return slave->a2l.length;
}

void hb_a2l_read(hb_xcp* slave, hb_address offset, uint8_t* destination, uint16_t count) {
    writer out;
    memset(&out, 0, sizeof out);
    out.slave = slave;
    out.destination = destination;
    out.start = offset;
    out.end = (hb_address)(offset + count);
    if (offset < slave->a2l.item_offset) {
        rewindCursor(&slave->a2l);
    }
    out.position = slave->a2l.item_offset;
    putItems(&out, &slave->a2l);
}
