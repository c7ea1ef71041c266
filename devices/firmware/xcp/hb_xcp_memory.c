/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <string.h>

enum { SIGNAL_STRIDE = 8, VALUE_OCTETS = 8 };

/* The table that holds signal `index`, which becomes the index within that table. */
static const hb_signal_table* tableOf(const hb_xcp* slave, uint16_t* index) {
    const hb_signal_table* tables = slave->description.signals;
    if (*index < tables[0].count) {
        return &tables[0];
    }
    *index = (uint16_t)(*index - tables[0].count);
    return *index < tables[1].count ? &tables[1] : NULL;
}

/* The variable of the signal at this address and its octets; NULL if there is none. */
static const uint8_t* signalAt(const hb_xcp* slave, uint32_t address, uint8_t* octets) {
    const hb_signal_table* table;
    hb_signal_numbers signal;
    uint16_t index = (uint16_t)((uint16_t)address / SIGNAL_STRIDE);
    if (address >= HB_ADDRESS_LIVE) {
        return NULL;
    }
    table = tableOf(slave, &index);
    if (!table) {
        return NULL;
    }
    hb_signal_read(&table->entries[index], &signal);
    *octets = hb_type_size(signal.type);
    return (const uint8_t*)table->base + signal.offset;
}

const uint8_t* hb_memory_signal(const hb_xcp* slave, uint32_t address, uint8_t size) {
    uint8_t inside = (uint8_t)address % SIGNAL_STRIDE;
    uint8_t octets = 0;
    const uint8_t* variable = signalAt(slave, address, &octets);
    return variable && inside + size <= octets ? variable + inside : NULL;
}

/* A value is never read half old and half new; the gap behind a short one reads as 0. */
static uint8_t readSignals(const hb_xcp* slave, uint32_t address, uint8_t* destination, uint16_t count) {
    while (count > 0) {
        uint8_t inside = (uint8_t)address % SIGNAL_STRIDE;
        uint8_t part = (uint8_t)(SIGNAL_STRIDE - inside);
        uint8_t octets = 0;
        const uint8_t* variable = signalAt(slave, address, &octets);
        if (!variable) {
            return HB_ERR_OUT_OF_RANGE;
        }
        part = part < count ? part : (uint8_t)count;
        HB_LOCK();
        for (uint8_t i = 0; i < part; i++) {
            destination[i] = inside + i < octets ? variable[inside + i] : 0;
        }
        HB_UNLOCK();
        address += part;
        destination += part;
        count = (uint16_t)(count - part);
    }
    return HB_OK;
}

/* Variables of the live or paged space at an address; NULL if [address, address + count) is not inside. */
static uint8_t* variablesAt(const hb_xcp* slave, uint32_t address, uint16_t count, uint8_t* space,
                            uint16_t* offset) {
    const hb_xcp_description* description = &slave->description;
    uint32_t base = address >= HB_ADDRESS_SEGMENT ? HB_ADDRESS_SEGMENT : HB_ADDRESS_LIVE;
    uint32_t octets = address >= HB_ADDRESS_SEGMENT ? description->page_octets : description->live_octets;
    if (address < base || address - base > octets || octets - (address - base) < count) {
        return NULL;
    }
    *space = base == HB_ADDRESS_SEGMENT ? HB_PAGED : HB_LIVE;
    *offset = (uint16_t)(address - base);
    return *space == HB_PAGED ? description->pages[slave->xcp_page] : description->live;
}

static uint8_t readBlock(hb_xcp* slave, uint32_t address, uint8_t* destination, uint16_t count) {
    const hb_xcp_description* description = &slave->description;
    if (!description->hooks.read_block || address > description->block_octets ||
        description->block_octets - address < count) {
        return HB_ERR_OUT_OF_RANGE;
    }
    description->hooks.read_block(description->board, address, destination, count);
    return HB_OK;
}

static uint8_t readText(hb_xcp* slave, uint8_t extension, uint32_t address, uint8_t* destination,
                        uint16_t count) {
    if (extension == HB_EXT_A2L) {
        uint32_t octets = hb_a2l_length(slave);
        if (address > octets || octets - address < count) {
            return HB_ERR_OUT_OF_RANGE;
        }
        hb_a2l_read(slave, address, destination, count);
        return HB_OK;
    }
    for (uint16_t i = 0; i < count; i++) {
        if (!hb_names_octet(slave, address + i, &destination[i])) {
            return HB_ERR_OUT_OF_RANGE;
        }
    }
    return HB_OK;
}

uint8_t hb_memory_read(hb_xcp* slave, uint8_t extension, uint32_t address, uint8_t* destination,
                       uint16_t count) {
    uint8_t space;
    uint16_t offset;
    const uint8_t* variables;
    switch (extension) {
    case HB_EXT_VALUES:
        if (address < HB_ADDRESS_LIVE) {
            return readSignals(slave, address, destination, count);
        }
        variables = variablesAt(slave, address, count, &space, &offset);
        if (!variables) {
            return HB_ERR_OUT_OF_RANGE;
        }
        HB_LOCK();
        memcpy(destination, variables + offset, count);
        HB_UNLOCK();
        return HB_OK;
    case HB_EXT_BLOCK:
        return readBlock(slave, address, destination, count);
    case HB_EXT_A2L:
    case HB_EXT_NAMES:
        return readText(slave, extension, address, destination, count);
    default:
        return HB_ERR_OUT_OF_RANGE;
    }
}

/* One write command: `count` octets at `offset` of one space. */
typedef struct {
    uint8_t* variables;
    const uint8_t* source;
    uint16_t offset;
    uint8_t count;
    uint8_t space;
    uint8_t acts_now;    /* the control loop may read the result before the next command */
    uint16_t first, end; /* table entries that it touches */
} write_request;

static uint8_t overlaps(const hb_parameter_numbers* parameter, const write_request* request) {
    return parameter->space == request->space && parameter->offset < request->offset + request->count &&
           request->offset < parameter->offset + hb_type_size(parameter->type);
}

/* The value as it will be: what is there now with the new octets over it. */
static void composeValue(const hb_parameter_numbers* parameter, const write_request* request,
                         uint8_t* value) {
    uint8_t size = hb_type_size(parameter->type);
    memcpy(value, request->variables + parameter->offset, size);
    for (uint8_t i = 0; i < size; i++) {
        uint16_t position = (uint16_t)(parameter->offset + i);
        if (position >= request->offset && position < request->offset + request->count) {
            value[i] = request->source[position - request->offset];
        }
    }
}

/* 1 if the request ends in the middle of this value. */
static uint8_t endsInside(const hb_parameter_numbers* parameter, const write_request* request) {
    return request->offset + request->count < parameter->offset + hb_type_size(parameter->type);
}

static uint8_t isWithinLimits(const hb_parameter_numbers* parameter, const uint8_t* value) {
    float physical = hb_value_as_float(parameter->type, value);
    return physical >= parameter->lower && physical <= parameter->upper;
}

static void clampValue(const hb_parameter_numbers* parameter, uint8_t* value) {
    float physical = hb_value_as_float(parameter->type, value);
    if (physical < parameter->lower) {
        hb_value_from_float(parameter->type, value, parameter->lower);
    } else if (physical > parameter->upper) {
        hb_value_from_float(parameter->type, value, parameter->upper);
    }
}

/* Half-written values are tolerated on the idle page only (a tool may cut a page anywhere): the page switch
 * checks every value again. */
static uint8_t checkOne(hb_xcp* slave, uint16_t index, const hb_parameter_numbers* parameter,
                        const write_request* request) {
    const hb_xcp_description* description = &slave->description;
    uint8_t value[VALUE_OCTETS];
    composeValue(parameter, request, value);
    if (endsInside(parameter, request)) {
        if (request->acts_now &&
            (!hb_value_is_finite(parameter->type, value) || !isWithinLimits(parameter, value))) {
            return HB_ERR_OUT_OF_RANGE;
        }
        return HB_OK;
    }
    if (!hb_value_is_finite(parameter->type, value)) {
        return HB_ERR_OUT_OF_RANGE;
    }
    clampValue(parameter, value);
    if (!description->hooks.check) {
        return HB_OK;
    }
    return description->hooks.check(description->board, index, hb_value_as_float(parameter->type, value));
}

static void storeOne(const hb_parameter_numbers* parameter, const write_request* request) {
    uint8_t value[VALUE_OCTETS];
    composeValue(parameter, request, value);
    if (!endsInside(parameter, request)) {
        clampValue(parameter, value);
    }
    memcpy(request->variables + parameter->offset, value, hb_type_size(parameter->type));
}

enum write_step { STEP_CHECK, STEP_STORE, STEP_NOTIFY };

/* Narrows the request to the entries it touches: what follows may have to be quick. */
static void findEntries(const hb_xcp_description* description, write_request* request) {
    request->first = description->parameter_count;
    request->end = 0;
    for (uint16_t i = 0; i < description->parameter_count; i++) {
        hb_parameter_numbers parameter;
        hb_rom_copy(&parameter, &description->parameters[i], offsetof(hb_parameter_numbers, initial));
        if (parameter.space == request->space && parameter.offset < request->offset + request->count &&
            request->offset < parameter.offset + hb_type_size(parameter.type) * parameter.rows) {
            request->first = request->first < i ? request->first : i;
            request->end = (uint16_t)(i + 1U);
        }
    }
}

static uint8_t stepOne(hb_xcp* slave, uint16_t index, const hb_parameter_numbers* parameter,
                       const write_request* request, enum write_step step) {
    const hb_xcp_description* description = &slave->description;
    if (step == STEP_CHECK) {
        return checkOne(slave, index, parameter, request);
    }
    if (step == STEP_STORE) {
        storeOne(parameter, request);
    } else if (description->hooks.written) {
        description->hooks.written(description->board, index);
    }
    return HB_OK;
}

static uint8_t forEachWritten(hb_xcp* slave, const write_request* request, enum write_step step) {
    for (uint16_t i = request->first; i < request->end; i++) {
        hb_parameter_numbers parameter;
        hb_parameter_read(&slave->description.parameters[i], &parameter);
        for (hb_extent row = 0; row < parameter.rows; row++) {
            if (overlaps(&parameter, request)) {
                uint8_t result = stepOne(slave, i, &parameter, request, step);
                if (result != HB_OK) {
                    return result;
                }
            }
            parameter.offset = (uint16_t)(parameter.offset + hb_type_size(parameter.type));
        }
    }
    return HB_OK;
}

uint8_t hb_memory_write(hb_xcp* slave, uint8_t extension, uint32_t address, const uint8_t* source,
                        uint8_t count) {
    write_request request;
    uint8_t result;
    if (extension != HB_EXT_VALUES) {
        return HB_ERR_WRITE_PROTECTED;
    }
    if (address < HB_ADDRESS_LIVE) {
        return hb_memory_signal(slave, address, 1) ? HB_ERR_WRITE_PROTECTED : HB_ERR_OUT_OF_RANGE;
    }
    request.variables = variablesAt(slave, address, count, &request.space, &request.offset);
    if (!request.variables) {
        return HB_ERR_OUT_OF_RANGE;
    }
    request.source = source;
    request.count = count;
    request.acts_now = request.space == HB_LIVE || slave->xcp_page == slave->active_page ||
                       slave->xcp_page == slave->next_page;
    findEntries(&slave->description, &request);
    result = forEachWritten(slave, &request, STEP_CHECK);
    if (result != HB_OK) {
        return result;
    }
    HB_LOCK();
    (void)forEachWritten(slave, &request, STEP_STORE);
    (void)forEachWritten(slave, &request, STEP_NOTIFY);
    HB_UNLOCK();
    return HB_OK;
}

uint8_t hb_memory_page_is_valid(const hb_xcp* slave, uint8_t page) {
    const hb_xcp_description* description = &slave->description;
    for (uint16_t i = 0; i < description->parameter_count; i++) {
        hb_parameter_numbers parameter;
        const uint8_t* value;
        hb_parameter_read(&description->parameters[i], &parameter);
        if (parameter.space != HB_PAGED) {
            continue;
        }
        value = description->pages[page] + parameter.offset;
        for (hb_extent row = 0; row < parameter.rows; row++) {
            if (!hb_value_is_finite(parameter.type, value) || !isWithinLimits(&parameter, value)) {
                return 0;
            }
            value += hb_type_size(parameter.type);
        }
    }
    return 1;
}
