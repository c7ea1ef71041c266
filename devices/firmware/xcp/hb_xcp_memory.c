/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <string.h>

enum { SIGNAL_STRIDE = 8, VALUE_OCTETS = 8 };

/* Inside, the segment has an extension of its own, so that offsets are short on small processors. An address
 * they cannot have becomes one where nothing is. */
void hb_memory_set_mta(hb_xcp* slave, uint8_t extension, const uint8_t address[4]) {
    uint16_t high = hb_get16(&address[2]);
    slave->mta_address = hb_get16(address);
    if (extension == HB_EXT_VALUES && high == HB_ADDRESS_SEGMENT >> 16) {
        extension = HB_EXT_SEGMENT;
    } else if (extension >= HB_EXT_SEGMENT) {
        extension = HB_EXT_NONE;
    } else if (high > 0) {
#if HB_FEATURE_FULL
        slave->mta_address = hb_get32(address);
#else
        extension = extension == HB_EXT_VALUES ? HB_EXT_SEGMENT : extension;
        slave->mta_address = UINT16_MAX;
#endif
    }
    slave->mta_extension = extension;
}

const hb_signal_table* hb_memory_signal_table(const hb_xcp* slave, uint16_t* index) {
    const hb_signal_table* table = slave->description.signals;
    for (uint8_t i = 0; i < HB_SIGNAL_TABLES; i++) {
        if (*index < table->count) {
            return table;
        }
        *index = (uint16_t)(*index - table->count);
        table++;
    }
    return NULL;
}

const uint8_t* hb_memory_signal(const hb_xcp* slave, hb_address address, uint8_t size) {
    uint8_t inside = (uint8_t)address % SIGNAL_STRIDE;
    uint16_t index = (uint16_t)(address / SIGNAL_STRIDE);
    const hb_signal_table* table;
    hb_entry signal;
    if (address >= HB_ADDRESS_LIVE) {
        return NULL;
    }
    table = hb_memory_signal_table(slave, &index);
    if (!table) {
        return NULL;
    }
    hb_rom_copy(&signal, &table->entries[index].entry, sizeof signal);
    if (inside + size > hb_type_size(signal.type)) {
        return NULL;
    }
    return (const uint8_t*)table->base + signal.offset + inside;
}

/* A value is never read half old and half new; the gap behind a short one reads as 0. */
static uint8_t readSignals(const hb_xcp* slave, uint8_t* destination, uint8_t count) {
    hb_address address = slave->mta_address;
    while (count > 0) {
        uint8_t inside = (uint8_t)address % SIGNAL_STRIDE;
        if (!hb_memory_signal(slave, (hb_address)(address - inside), 1)) {
            return HB_ERR_OUT_OF_RANGE;
        }
        HB_LOCK();
        for (; inside < SIGNAL_STRIDE && count > 0; inside++) {
            const uint8_t* octet = hb_memory_signal(slave, address, 1);
            *destination = octet ? *octet : 0;
            destination++;
            address++;
            count--;
        }
        HB_UNLOCK();
    }
    return HB_OK;
}

/* Which variables a value address means. */
static uint8_t spaceAt(const hb_xcp* slave) {
    if (slave->mta_extension == HB_EXT_SEGMENT) {
        return HB_PAGED;
    }
#if HB_FEATURE_FULL
    if (slave->mta_address >= HB_ADDRESS_EXTRA) {
        return HB_EXTRA;
    }
#endif
    return HB_LIVE;
}

/* Variables of the space behind the MTA; NULL if not `count` octets are inside. */
static uint8_t* variablesAt(const hb_xcp* slave, uint8_t count, uint16_t* offset) {
    const hb_xcp_description* description = &slave->description;
    uint16_t octets = description->page_octets;
    uint8_t* base = description->pages[slave->xcp_page];
    hb_address inside = slave->mta_address;
    uint8_t space = spaceAt(slave);
    if (space == HB_LIVE) {
        octets = description->live_octets;
        base = description->live;
        inside = (hb_address)(inside - HB_ADDRESS_LIVE);
    }
#if HB_FEATURE_FULL
    else if (space == HB_EXTRA) {
        octets = description->extra.octets;
        base = description->extra.base;
        inside = (hb_address)(inside - HB_ADDRESS_EXTRA);
    }
#endif
    if (inside > octets || octets - inside < count) {
        return NULL;
    }
    *offset = (uint16_t)inside;
    return base;
}

static uint8_t readVariables(const hb_xcp* slave, uint8_t* destination, uint8_t count) {
    uint16_t offset;
    const uint8_t* variables = variablesAt(slave, count, &offset);
    if (!variables) {
        return HB_ERR_OUT_OF_RANGE;
    }
    HB_LOCK();
    memcpy(destination, variables + offset, count);
    HB_UNLOCK();
    return HB_OK;
}

static uint8_t isInside(hb_address address, uint8_t count, hb_address octets) {
    return address <= octets && octets - address >= count;
}

static uint8_t readBlock(hb_xcp* slave, uint8_t* destination, uint8_t count) {
    const hb_xcp_description* description = &slave->description;
    if (!description->hooks.read_block || !isInside(slave->mta_address, count, description->block_octets)) {
        return HB_ERR_OUT_OF_RANGE;
    }
    description->hooks.read_block(description->board, slave->mta_address, destination, count);
    return HB_OK;
}

static uint8_t readText(hb_xcp* slave, uint8_t* destination, uint8_t count) {
    if (!isInside(slave->mta_address, count, hb_a2l_length(slave))) {
        return HB_ERR_OUT_OF_RANGE;
    }
    hb_a2l_read(slave, slave->mta_address, destination, count);
    return HB_OK;
}

static uint8_t readNames(hb_xcp* slave, uint8_t* destination, uint8_t count) {
    for (uint8_t i = 0; i < count; i++) {
        if (!hb_names_octet(slave, (hb_address)(slave->mta_address + i), &destination[i])) {
            return HB_ERR_OUT_OF_RANGE;
        }
    }
    return HB_OK;
}

static HB_NOINLINE uint8_t readAny(hb_xcp* slave, uint8_t* destination, uint8_t count) {
    switch (slave->mta_extension) {
    case HB_EXT_VALUES:
        return slave->mta_address < HB_ADDRESS_LIVE ? readSignals(slave, destination, count)
                                                    : readVariables(slave, destination, count);
    case HB_EXT_SEGMENT:
        return readVariables(slave, destination, count);
    case HB_EXT_A2L:
        return readText(slave, destination, count);
    case HB_EXT_BLOCK:
        return readBlock(slave, destination, count);
    case HB_EXT_NAMES:
        return readNames(slave, destination, count);
    default:
        return HB_ERR_OUT_OF_RANGE;
    }
}

uint8_t hb_memory_read(hb_xcp* slave, uint8_t* destination, uint8_t count) {
    uint8_t result = readAny(slave, destination, count);
    if (result == HB_OK) {
        slave->mta_address = (hb_address)(slave->mta_address + count);
    }
    return result;
}

/* One write command: the octets from `offset` on of one space. */
typedef struct {
    uint8_t* variables;
    uint8_t* octets; /* copied, so that limits can be applied before anything is stored */
    uint16_t offset, end;
    uint8_t space;
    uint8_t acts_now;       /* the control loop may read the result before the next command */
    uint16_t first, behind; /* table entries that it touches */
} write_request;

/* The value as it will be is what is there now with the new octets over it; the other way round, what became
 * of the value goes back to the new octets. */
static void exchangeOctets(const hb_entry* entry, const write_request* request, uint8_t* value,
                           uint8_t is_back) {
    uint16_t position = entry->offset;
    for (uint8_t i = 0; i < hb_type_size(entry->type); i++) {
        if (position >= request->offset && position < request->end) {
            uint8_t* octet = &request->octets[position - request->offset];
            if (is_back) {
                *octet = value[i];
            } else {
                value[i] = *octet;
            }
        }
        position++;
    }
}

static uint8_t isWithinLimits(const hb_entry* entry, const uint8_t* value) {
    float physical = hb_value_as_float(entry->type, value);
    return physical >= entry->lower && physical <= entry->upper;
}

/* A finite value outside the limits becomes the limit. Half-written values are tolerated on the idle page
 * only (a tool may cut a page anywhere): the page switch checks every value again. */
static uint8_t checkOne(const hb_xcp* slave, uint16_t index, const hb_entry* entry,
                        const write_request* request) {
    const hb_xcp_description* description = &slave->description;
    uint8_t value[VALUE_OCTETS];
    float physical;
    uint8_t is_half;
    memcpy(value, request->variables + entry->offset, hb_type_size(entry->type));
    exchangeOctets(entry, request, value, 0);
    is_half = request->end < entry->offset + hb_type_size(entry->type);
    if (is_half && !request->acts_now) {
        return HB_OK;
    }
    if (!hb_value_is_finite(entry->type, value) || (is_half && !isWithinLimits(entry, value))) {
        return HB_ERR_OUT_OF_RANGE;
    }
    physical = hb_value_as_float(entry->type, value);
    if (!isWithinLimits(entry, value)) {
        physical = physical < entry->lower ? entry->lower : entry->upper;
        hb_value_from_float(entry->type, value, physical);
        exchangeOctets(entry, request, value, 1);
    }
    return description->hooks.check ? description->hooks.check(description->board, index, physical)
                                    : (uint8_t)HB_OK;
}

enum write_step { STEP_CHECK, STEP_NOTIFY };

static uint8_t stepOne(const hb_xcp* slave, uint16_t index, const hb_entry* entry,
                       const write_request* request, enum write_step step) {
    const hb_xcp_description* description = &slave->description;
    if (step == STEP_CHECK) {
        return checkOne(slave, index, entry, request);
    }
    if (description->hooks.written) {
        description->hooks.written(description->board, index);
    }
    return HB_OK;
}

static uint8_t forEachWritten(hb_xcp* slave, const write_request* request, enum write_step step) {
    for (uint16_t i = request->first; i < request->behind; i++) {
        hb_parameter parameter;
        hb_parameter_read(hb_xcp_parameter(&slave->description, i), &parameter);
        for (; parameter.rows > 0 && parameter.space == request->space; parameter.rows--) {
            uint16_t behind = (uint16_t)(parameter.entry.offset + hb_type_size(parameter.entry.type));
            if (parameter.entry.offset < request->end && request->offset < behind) {
                uint8_t result = stepOne(slave, i, &parameter.entry, request, step);
                if (result != HB_OK) {
                    return result;
                }
            }
            parameter.entry.offset = behind;
        }
    }
    return HB_OK;
}

/* Narrows the request to the entries it touches: what follows may have to be quick. */
static void findEntries(const hb_xcp_description* description, write_request* request) {
    request->first = hb_xcp_parameter_count(description);
    request->behind = 0;
    for (uint16_t i = 0; i < hb_xcp_parameter_count(description); i++) {
        hb_parameter parameter;
        hb_parameter_read(hb_xcp_parameter(description, i), &parameter);
        if (parameter.space == request->space && parameter.entry.offset < request->end &&
            request->offset < parameter.entry.offset + hb_type_size(parameter.entry.type) * parameter.rows) {
            request->first = request->first < i ? request->first : i;
            request->behind = (uint16_t)(i + 1U);
        }
    }
}

static uint8_t writeVariables(hb_xcp* slave, const uint8_t* source, uint8_t count) {
    write_request request;
    uint8_t result;
    request.variables = variablesAt(slave, count, &request.offset);
    if (!request.variables) {
        return HB_ERR_OUT_OF_RANGE;
    }
    request.octets = &slave->response[1]; /* nothing is answered from there */
    memcpy(request.octets, source, count);
    request.end = (uint16_t)(request.offset + count);
    request.space = spaceAt(slave);
    request.acts_now = request.space != HB_PAGED || slave->xcp_page == slave->active_page ||
                       slave->xcp_page == slave->next_page;
    findEntries(&slave->description, &request);
    result = forEachWritten(slave, &request, STEP_CHECK);
    if (result == HB_OK) {
        HB_LOCK();
        memcpy(request.variables + request.offset, request.octets, count);
        (void)forEachWritten(slave, &request, STEP_NOTIFY);
        HB_UNLOCK();
    }
    return result;
}

uint8_t hb_memory_write(hb_xcp* slave, const uint8_t* source, uint8_t count) {
    uint8_t result;
    if (slave->mta_extension != HB_EXT_SEGMENT &&
        (slave->mta_extension != HB_EXT_VALUES || hb_memory_signal(slave, slave->mta_address, 1))) {
        return HB_ERR_WRITE_PROTECTED;
    }
    result = writeVariables(slave, source, count);
    if (result == HB_OK) {
        slave->mta_address = (hb_address)(slave->mta_address + count);
    }
    return result;
}

uint8_t hb_memory_page_is_valid(const hb_xcp* slave, uint8_t page) {
    const hb_xcp_description* description = &slave->description;
    for (uint16_t i = 0; i < description->parameter_count; i++) {
        hb_parameter parameter;
        hb_parameter_read(&description->parameters[i], &parameter);
        for (; parameter.rows > 0 && parameter.space == HB_PAGED; parameter.rows--) {
            if (!isWithinLimits(&parameter.entry, description->pages[page] + parameter.entry.offset)) {
                return 0;
            }
            parameter.entry.offset = (uint16_t)(parameter.entry.offset + hb_type_size(parameter.entry.type));
        }
    }
    return 1;
}
