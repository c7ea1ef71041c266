/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <string.h>

/* Order of allocation (resources/help/protocol.md 3.8). */
enum { STAGE_NONE, STAGE_FREED, STAGE_LISTS, STAGE_ODTS, STAGE_ENTRIES };
enum { BIT_OFFSET_NONE = 0xFF };

HB_NOINLINE hb_daq_list* hb_daq_list_at(hb_xcp* slave, const uint8_t* packet) {
    return packet[3] == 0 && packet[2] < slave->daq.list_count ? &slave->daq.lists[packet[2]] : NULL;
}

/* The ODT that octets 2 to 4 of a command name; NULL if there is none. */
static HB_NOINLINE hb_daq_odt* odtAt(hb_xcp* slave, const uint8_t* packet) {
    const hb_daq_list* list = hb_daq_list_at(slave, packet);
    return list && packet[4] < list->odt_count ? &slave->daq.odts[list->first_odt + packet[4]] : NULL;
}

void hb_daq_clear(hb_xcp* slave) {
    hb_daq* daq = &slave->daq;
    hb_daq_stop_all(slave);
    daq->stage = STAGE_NONE;
    daq->list_count = 0;
    daq->odt_count = 0;
    daq->entry_count = 0;
    daq->write_odt = NULL;
    daq->overload_reported = 0;
}

uint8_t hb_cmd_free_daq(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    (void)packet;
    (void)length;
    hb_daq_clear(slave);
    slave->daq.stage = STAGE_FREED;
    return HB_OK;
}

/* An allocation comes in this stage or the next one, which it leads to. */
static uint8_t beginAllocation(hb_xcp* slave, uint8_t stage, uint8_t may_repeat) {
    if (hb_daq_is_running(slave)) {
        return HB_ERR_DAQ_ACTIVE;
    }
    return slave->daq.stage == stage || (may_repeat && slave->daq.stage == stage + 1)
               ? (uint8_t)HB_OK
               : (uint8_t)HB_ERR_SEQUENCE;
}

uint8_t hb_cmd_alloc_daq(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    uint16_t count = hb_get16(&packet[2]);
    uint8_t result = beginAllocation(slave, STAGE_FREED, 0);
    (void)length;
    if (result != HB_OK) {
        return result;
    }
    if (count == 0 || count > HB_DAQ_LISTS) {
        return count == 0 ? HB_ERR_OUT_OF_RANGE : HB_ERR_MEMORY_OVERFLOW;
    }
    memset(slave->daq.lists, 0, sizeof slave->daq.lists);
    for (uint8_t i = 0; i < HB_DAQ_LISTS; i++) {
        slave->daq.lists[i].prescaler = 1;
    }
    slave->daq.list_count = (uint8_t)count;
    slave->daq.stage = STAGE_LISTS;
    return HB_OK;
}

uint8_t hb_cmd_alloc_odt(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    hb_daq* daq = &slave->daq;
    hb_daq_list* list = hb_daq_list_at(slave, packet);
    uint8_t count = packet[4];
    uint8_t result = beginAllocation(slave, STAGE_LISTS, 1);
    (void)length;
    if (result != HB_OK) {
        return result;
    }
    if (!list || count == 0) {
        return HB_ERR_OUT_OF_RANGE;
    }
    if (list->odt_count != 0) {
        return HB_ERR_SEQUENCE;
    }
    if (count > HB_DAQ_ODTS - daq->odt_count) {
        return HB_ERR_MEMORY_OVERFLOW;
    }
    list->first_odt = daq->odt_count;
    list->odt_count = count;
    memset(&daq->odts[daq->odt_count], 0, count * sizeof daq->odts[0]);
    daq->odt_count = (uint8_t)(daq->odt_count + count);
    daq->stage = STAGE_ODTS;
    return HB_OK;
}

uint8_t hb_cmd_alloc_odt_entry(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    hb_daq* daq = &slave->daq;
    hb_daq_odt* odt = odtAt(slave, packet);
    uint8_t count = packet[5];
    uint8_t result = beginAllocation(slave, STAGE_ODTS, 1);
    (void)length;
    if (result != HB_OK) {
        return result;
    }
    if (!odt || count == 0) {
        return HB_ERR_OUT_OF_RANGE;
    }
    if (odt->entry_count != 0) {
        return HB_ERR_SEQUENCE;
    }
    if (count > HB_DAQ_ENTRIES - daq->entry_count) {
        return HB_ERR_MEMORY_OVERFLOW;
    }
    odt->first_entry = daq->entry_count;
    odt->entry_count = count;
    odt->octets = 0;
    memset(&daq->entries[daq->entry_count], 0, count * sizeof daq->entries[0]);
    daq->entry_count = (hb_daq_count)(daq->entry_count + count);
    daq->stage = STAGE_ENTRIES;
    return HB_OK;
}

uint8_t hb_cmd_set_daq_ptr(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    hb_daq* daq = &slave->daq;
    hb_daq_odt* odt = odtAt(slave, packet);
    (void)length;
    daq->write_odt = NULL;
    if (!odt || packet[5] >= odt->entry_count) {
        return HB_ERR_OUT_OF_RANGE;
    }
    if (daq->lists[packet[2]].mode & HB_DAQ_RUNNING) {
        return HB_ERR_DAQ_ACTIVE;
    }
    daq->write_odt = odt;
    daq->writes_first_odt = packet[4] == 0;
    daq->write_entry = packet[5];
    return HB_OK;
}

static uint8_t writeEntry(hb_xcp* slave, uint8_t bit_offset, uint8_t size, uint8_t extension,
                          const uint8_t address[4]) {
    hb_daq* daq = &slave->daq;
    hb_daq_odt* odt = daq->write_odt;
    const uint8_t* source = NULL;
    hb_daq_entry* entry;
    uint16_t octets;
    if (!odt) {
        return HB_ERR_SEQUENCE;
    }
    if (bit_offset != BIT_OFFSET_NONE || size == 0 || size > HB_MAX_ENTRY_OCTETS) {
        return HB_ERR_OUT_OF_RANGE;
    }
    if (extension == HB_EXT_VALUES && hb_get16(&address[2]) == 0) {
        source = hb_memory_signal(slave, hb_get16(address), size);
    }
    if (!source) {
        return HB_ERR_ACCESS_DENIED;
    }
    entry = &daq->entries[odt->first_entry + daq->write_entry];
    octets = (uint16_t)(odt->octets - entry->size + size); /* the entry may be written again */
    if (octets + HB_PID_OCTETS + (daq->writes_first_odt ? HB_TIMESTAMP_OCTETS : 0) >
        hb_xcp_max_dto(&slave->description)) {
        return HB_ERR_DAQ_CONFIG;
    }
    odt->octets = (hb_daq_count)octets;
    entry->source = source;
    entry->size = size;
    daq->write_entry++;
    if (daq->write_entry == odt->entry_count) {
        daq->write_odt = NULL;
    }
    return HB_OK;
}

uint8_t hb_cmd_write_daq(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    (void)length;
    return writeEntry(slave, packet[1], packet[2], packet[3], &packet[4]);
}

#if HB_FEATURE_FULL

uint8_t hb_cmd_write_daq_multiple(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    if (length < 2U + 8U * packet[1] || packet[1] == 0) {
        return HB_ERR_CMD_SYNTAX;
    }
    for (uint8_t i = 0; i < packet[1]; i++) {
        const uint8_t* element = &packet[2 + 8 * i];
        uint8_t result = writeEntry(slave, element[0], element[1], element[6], &element[2]);
        if (result != HB_OK) {
            return result;
        }
    }
    return HB_OK;
}

#endif
