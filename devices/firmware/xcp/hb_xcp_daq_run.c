/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <string.h>

enum { PROPERTIES = 0x93 /* dynamic, prescaler, time stamp, overload by event */ };
enum { EVENT_IS_DAQ = 0x04, PAYLOAD_U32 = 1 };
enum { LIST_STOP, LIST_START, LIST_SELECT };
enum { SYNCH_STOP_ALL, SYNCH_START_SELECTED, SYNCH_STOP_SELECTED, SYNCH_PREPARE };
/* Room that samples leave for an answer and two events. */
enum { RESERVED_OCTETS = HB_MAX_CTO + 3 * HB_PACKET_OVERHEAD + 6 };

uint8_t hb_daq_is_running(const hb_xcp* slave) {
    for (uint8_t i = 0; i < slave->daq.list_count; i++) {
        if (slave->daq.lists[i].mode & HB_DAQ_RUNNING) {
            return 1;
        }
    }
    return 0;
}

void hb_daq_stop_all(hb_xcp* slave) {
    for (uint8_t i = 0; i < slave->daq.list_count; i++) {
        slave->daq.lists[i].mode &= (uint8_t) ~(HB_DAQ_RUNNING | HB_DAQ_SELECTED);
    }
}

uint8_t hb_cmd_set_daq_list_mode(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    hb_daq_list* entry = hb_daq_list_at(slave, packet);
    uint16_t event = hb_get16(&packet[4]);
    (void)length;
    if (!entry || event >= slave->description.event_count || packet[6] == 0) {
        return HB_ERR_OUT_OF_RANGE;
    }
    if (entry->mode & HB_DAQ_RUNNING) {
        return HB_ERR_DAQ_ACTIVE;
    }
    if (packet[1] & (uint8_t)~HB_DAQ_TIMESTAMP) {
        return HB_ERR_MODE_NOT_VALID;
    }
    entry->mode = (uint8_t)((entry->mode & HB_DAQ_SELECTED) | packet[1]);
    entry->event = (uint8_t)event;
    entry->prescaler = packet[6];
    entry->priority = packet[7];
    return HB_OK;
}

#if HB_FEATURE_FULL

uint8_t hb_cmd_get_daq_list_mode(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    const hb_daq_list* entry = hb_daq_list_at(slave, packet);
    (void)length;
    if (!entry) {
        return HB_ERR_OUT_OF_RANGE;
    }
    slave->response[1] = entry->mode;
    hb_put16(&slave->response[4], entry->event);
    slave->response[6] = entry->prescaler;
    slave->response[7] = entry->priority;
    slave->response_length = 8;
    return HB_OK;
}

#endif

/* Every ODT of a list that is to run has entries, and every entry was written. */
static uint8_t isComplete(const hb_daq* daq, const hb_daq_list* list) {
    for (uint8_t i = 0; i < list->odt_count; i++) {
        const hb_daq_odt* odt = &daq->odts[list->first_odt + i];
        for (hb_daq_count k = 0; k < odt->entry_count; k++) {
            if (daq->entries[odt->first_entry + k].size == 0) {
                return 0;
            }
        }
        if (odt->entry_count == 0) {
            return 0;
        }
    }
    return list->odt_count > 0;
}

static void startList(hb_daq* daq, hb_daq_list* list) {
    list->mode = (uint8_t)((list->mode & (uint8_t)~HB_DAQ_SELECTED) | HB_DAQ_RUNNING);
    list->countdown = 1; /* the first sample comes with the first event */
    daq->overload_reported = 0;
}

uint8_t hb_cmd_start_stop_daq_list(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    hb_daq* daq = &slave->daq;
    hb_daq_list* list = hb_daq_list_at(slave, packet);
    (void)length;
    if (!list) {
        return HB_ERR_OUT_OF_RANGE;
    }
    if (packet[1] > LIST_SELECT) {
        return HB_ERR_MODE_NOT_VALID;
    }
    if (packet[1] == LIST_STOP) {
        list->mode &= (uint8_t) ~(HB_DAQ_RUNNING | HB_DAQ_SELECTED);
    } else if (!isComplete(daq, list)) {
        return HB_ERR_DAQ_CONFIG;
    } else if (packet[1] == LIST_START) {
        startList(daq, list);
    } else {
        list->mode |= HB_DAQ_SELECTED;
    }
    slave->response[1] = list->first_odt;
    slave->response_length = 2;
    return HB_OK;
}

uint8_t hb_cmd_start_stop_synch(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    hb_daq* daq = &slave->daq;
    (void)length;
    if (packet[1] > SYNCH_PREPARE) {
        return HB_ERR_MODE_NOT_VALID;
    }
    if (packet[1] == SYNCH_STOP_ALL) {
        hb_daq_stop_all(slave);
        return HB_OK;
    }
    for (uint8_t i = 0; i < daq->list_count; i++) {
        if (!(daq->lists[i].mode & HB_DAQ_SELECTED)) {
            continue;
        }
        if (packet[1] == SYNCH_START_SELECTED) {
            startList(daq, &daq->lists[i]);
        } else if (packet[1] == SYNCH_STOP_SELECTED) {
            daq->lists[i].mode &= (uint8_t) ~(HB_DAQ_RUNNING | HB_DAQ_SELECTED);
        }
    }
    return HB_OK;
}

uint8_t hb_cmd_get_daq_clock(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    (void)packet;
    (void)length;
    slave->response[3] = PAYLOAD_U32;
    hb_put32(&slave->response[4], slave->time_us);
    slave->response_length = 8;
    return HB_OK;
}

uint8_t hb_cmd_get_daq_processor_info(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    (void)packet;
    (void)length;
    slave->response[1] = PROPERTIES;
    hb_put16(&slave->response[2], HB_DAQ_LISTS);
    hb_put16(&slave->response[4], slave->description.event_count);
    slave->response_length = 8;
    return HB_OK;
}

uint8_t hb_cmd_get_daq_event_info(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    uint16_t index = hb_get16(&packet[2]);
    hb_event event;
    (void)length;
    if (index >= slave->description.event_count) {
        return HB_ERR_OUT_OF_RANGE;
    }
    hb_rom_copy(&event, &slave->description.events[index], sizeof event);
    slave->response[1] = EVENT_IS_DAQ;
    slave->response[2] = HB_DAQ_LISTS;
    slave->response[3] = (uint8_t)strlen(event.name);
    slave->response[4] = event.cycle;
    slave->response[5] = event.time_unit;
    slave->response_length = 7;
    slave->mta_extension = HB_EXT_NAMES;
    slave->mta_address = (hb_address)(HB_EVENT_NAMES + 16U * index);
    return HB_OK;
}

/* Octets of a packet of this ODT. */
static hb_length odtOctets(const hb_daq* daq, const hb_daq_list* list, uint8_t odt) {
    hb_length octets = (hb_length)(daq->odts[list->first_odt + odt].octets + HB_PID_OCTETS);
    if (odt == 0 && (list->mode & HB_DAQ_TIMESTAMP)) {
        octets = (hb_length)(octets + HB_TIMESTAMP_OCTETS);
    }
    return octets;
}

/* One sample over all ODTs of a list: enters the queue whole or is dropped whole, its counters used up. */
static void sendSample(hb_xcp* slave, const hb_daq_list* list) {
    hb_daq* daq = &slave->daq;
    uint16_t needed = RESERVED_OCTETS;
    for (uint8_t i = 0; i < list->odt_count; i++) {
        needed = (uint16_t)(needed + odtOctets(daq, list, i) + HB_PACKET_OVERHEAD);
    }
    if (hb_queue_free(&slave->queue) < needed) {
        hb_queue_skip(&slave->queue, list->odt_count);
        if (!daq->overload_reported) {
            const uint8_t overload[2] = {0xFD, HB_EV_DAQ_OVERLOAD};
            daq->overload_reported = 1;
            hb_xcp_send(slave, overload, 2);
        }
        return;
    }
    for (uint8_t i = 0; i < list->odt_count; i++) {
        const hb_daq_odt* odt = &daq->odts[list->first_odt + i];
        uint8_t header[HB_PID_OCTETS + HB_TIMESTAMP_OCTETS];
        header[0] = (uint8_t)(list->first_odt + i);
        hb_put32(&header[1], slave->time_us);
        hb_queue_begin(&slave->queue, odtOctets(daq, list, i));
        hb_queue_put(&slave->queue, header, i == 0 && (list->mode & HB_DAQ_TIMESTAMP) ? sizeof header : 1);
        for (hb_daq_count k = 0; k < odt->entry_count; k++) {
            const hb_daq_entry* entry = &daq->entries[odt->first_entry + k];
            hb_queue_put(&slave->queue, entry->source, entry->size);
        }
    }
}

void hb_xcp_event(hb_xcp* slave, uint8_t event) {
    for (uint8_t i = 0; i < slave->daq.list_count; i++) {
        hb_daq_list* list = &slave->daq.lists[i];
        if (list->event != event || !(list->mode & HB_DAQ_RUNNING)) {
            continue;
        }
        if (--list->countdown == 0) {
            list->countdown = list->prescaler;
            sendSample(slave, list);
        }
    }
}
