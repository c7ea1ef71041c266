/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <string.h>

/* Order of allocation (resources/help/protocol.md 3.8). */
enum { STAGE_NONE, STAGE_FREED, STAGE_LISTS, STAGE_ODTS, STAGE_ENTRIES };
enum { BIT_OFFSET_NONE = 0xFF };

void hb_daq_clear(hb_xcp* slave) {
    hb_daq* daq = &slave->daq;
    for (uint8_t i = 0; i < daq->list_count; i++) {
        daq->lists[i].mode = 0;
    }
    daq->stage = STAGE_NONE;
    daq->list_count = 0;
    daq->odt_count = 0;
    daq->entry_count = 0;
    daq->write_valid = 0;
    daq->overload_reported = 0;
}

uint8_t hb_cmd_free_daq(hb_xcp* slave, const uint8_t* packet, uint16_t length) {
    (void)packet;
    (void)length;
    hb_daq_clear(slave);
    slave->daq.stage = STAGE_FREED;
    return HB_OK;
}

uint8_t hb_cmd_alloc_daq(hb_xcp* slave, const uint8_t* packet, uint16_t length) {
    uint16_t count = hb_get16(&packet[2]);
    (void)length;
    if (hb_daq_is_running(slave)) {
        return HB_ERR_DAQ_ACTIVE;
    }
    if (slave->daq.stage != STAGE_FREED) {
        return HB_ERR_SEQUENCE;
    }
    if (count == 0 || count > HB_DAQ_LISTS) {
        return count == 0 ? HB_ERR_OUT_OF_RANGE : HB_ERR_MEMORY_OVERFLOW;
    }
    memset(slave->daq.lists, 0, sizeof slave->daq.lists);
    for (uint8_t i = 0; i < count; i++) {
        slave->daq.lists[i].prescaler = 1;
    }
    slave->daq.list_count = (uint8_t)count;
    slave->daq.stage = STAGE_LISTS;
    return HB_OK;
}

uint8_t hb_cmd_alloc_odt(hb_xcp* slave, const uint8_t* packet, uint16_t length) {
    hb_daq* daq = &slave->daq;
    uint16_t list = hb_get16(&packet[2]);
    uint8_t count = packet[4];
    (void)length;
    if (hb_daq_is_running(slave)) {
        return HB_ERR_DAQ_ACTIVE;
    }
    if (daq->stage != STAGE_LISTS && daq->stage != STAGE_ODTS) {
        return HB_ERR_SEQUENCE;
    }
    if (list >= daq->list_count || count == 0) {
        return HB_ERR_OUT_OF_RANGE;
    }
    if (daq->lists[list].odt_count != 0) {
        return HB_ERR_SEQUENCE;
    }
    if (count > HB_DAQ_ODTS - daq->odt_count) {
        return HB_ERR_MEMORY_OVERFLOW;
    }
    daq->lists[list].first_odt = daq->odt_count;
    daq->lists[list].odt_count = count;
    memset(&daq->odts[daq->odt_count], 0, count * sizeof daq->odts[0]);
    daq->odt_count = (uint8_t)(daq->odt_count + count);
    daq->stage = STAGE_ODTS;
    return HB_OK;
}

uint8_t hb_cmd_alloc_odt_entry(hb_xcp* slave, const uint8_t* packet, uint16_t length) {
    hb_daq* daq = &slave->daq;
    uint16_t list = hb_get16(&packet[2]);
    uint8_t count = packet[5];
    hb_daq_odt* odt;
    (void)length;
    if (hb_daq_is_running(slave)) {
        return HB_ERR_DAQ_ACTIVE;
    }
    if (daq->stage != STAGE_ODTS && daq->stage != STAGE_ENTRIES) {
        return HB_ERR_SEQUENCE;
    }
    if (list >= daq->list_count || packet[4] >= daq->lists[list].odt_count || count == 0) {
        return HB_ERR_OUT_OF_RANGE;
    }
    odt = &daq->odts[daq->lists[list].first_odt + packet[4]];
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
    daq->entry_count = (uint16_t)(daq->entry_count + count);
    daq->stage = STAGE_ENTRIES;
    return HB_OK;
}

uint8_t hb_cmd_set_daq_ptr(hb_xcp* slave, const uint8_t* packet, uint16_t length) {
    hb_daq* daq = &slave->daq;
    uint16_t list = hb_get16(&packet[2]);
    (void)length;
    daq->write_valid = 0;
    if (list >= daq->list_count || packet[4] >= daq->lists[list].odt_count ||
        packet[5] >= daq->odts[daq->lists[list].first_odt + packet[4]].entry_count) {
        return HB_ERR_OUT_OF_RANGE;
    }
    if (daq->lists[list].mode & HB_DAQ_RUNNING) {
        return HB_ERR_DAQ_ACTIVE;
    }
    daq->write_list = (uint8_t)list;
    daq->write_odt = packet[4];
    daq->write_entry = packet[5];
    daq->write_valid = 1;
    return HB_OK;
}

static uint8_t writeEntry(hb_xcp* slave, uint8_t bit_offset, uint8_t size, uint8_t extension,
                          uint32_t address) {
    hb_daq* daq = &slave->daq;
    const uint8_t* source = NULL;
    hb_daq_entry* entry;
    hb_daq_odt* odt;
    uint16_t octets;
    uint8_t header;
    if (!daq->write_valid) {
        return HB_ERR_SEQUENCE;
    }
    if (bit_offset != BIT_OFFSET_NONE || size == 0 || size > HB_MAX_ENTRY_OCTETS) {
        return HB_ERR_OUT_OF_RANGE;
    }
    if (extension == HB_EXT_VALUES) {
        source = hb_memory_signal(slave, address, size);
    }
    if (!source) {
        return HB_ERR_ACCESS_DENIED;
    }
    odt = &daq->odts[daq->lists[daq->write_list].first_odt + daq->write_odt];
    entry = &daq->entries[odt->first_entry + daq->write_entry];
    header = daq->write_odt == 0 ? HB_PID_OCTETS + HB_TIMESTAMP_OCTETS : HB_PID_OCTETS;
    octets = (uint16_t)(odt->octets - entry->size + size); /* the entry may be written again */
    if (header + octets > hb_xcp_max_dto(&slave->description)) {
        return HB_ERR_DAQ_CONFIG;
    }
    odt->octets = octets;
    entry->source = source;
    entry->size = size;
    daq->write_entry++;
    daq->write_valid = daq->write_entry < odt->entry_count;
    return HB_OK;
}

uint8_t hb_cmd_write_daq(hb_xcp* slave, const uint8_t* packet, uint16_t length) {
    (void)length;
    return writeEntry(slave, packet[1], packet[2], packet[3], hb_get32(&packet[4]));
}

#if HB_FEATURE_FULL

uint8_t hb_cmd_write_daq_multiple(hb_xcp* slave, const uint8_t* packet, uint16_t length) {
    if (length < 2U + 8U * packet[1] || packet[1] == 0) {
        return HB_ERR_CMD_SYNTAX;
    }
    for (uint8_t i = 0; i < packet[1]; i++) {
        const uint8_t* element = &packet[2 + 8 * i];
        uint8_t result = writeEntry(slave, element[0], element[1], element[6], hb_get32(&element[2]));
        if (result != HB_OK) {
            return result;
        }
    }
    return HB_OK;
}

#endif
