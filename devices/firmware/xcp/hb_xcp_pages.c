/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <string.h>

enum { MODE_ECU = 0x01, MODE_XCP = 0x02, MODE_ALL = 0x80, PAGES = 2 };
enum { PAGE_READ_WRITE_ALWAYS = 0x3F };

uint8_t hb_cmd_set_cal_page(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    uint8_t mode = packet[1];
    (void)length;
    if ((mode & (MODE_ECU | MODE_XCP)) == 0 || (mode & (uint8_t) ~(MODE_ECU | MODE_XCP | MODE_ALL)) != 0) {
        return HB_ERR_MODE_NOT_VALID;
    }
    if (packet[2] != 0 && !(mode & MODE_ALL)) {
        return HB_ERR_SEGMENT_NOT_VALID;
    }
    if (packet[3] >= PAGES) {
        return HB_ERR_PAGE_NOT_VALID;
    }
    if (mode & MODE_ECU) {
        if (!hb_memory_page_is_valid(slave, packet[3])) {
            return HB_ERR_OUT_OF_RANGE;
        }
        slave->next_page = packet[3];
    }
    if (mode & MODE_XCP) {
        slave->xcp_page = packet[3];
    }
    return HB_OK;
}

/* The page last ordered, even when the control loop has not begun its next cycle: a master must never take
 * the page that is about to run for the idle one. */
uint8_t hb_cmd_get_cal_page(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    (void)length;
    if (packet[1] != MODE_ECU && packet[1] != MODE_XCP) {
        return HB_ERR_MODE_NOT_VALID;
    }
    if (packet[2] != 0) {
        return HB_ERR_SEGMENT_NOT_VALID;
    }
    slave->response[3] = packet[1] == MODE_ECU ? slave->next_page : slave->xcp_page;
    slave->response_length = 4;
    return HB_OK;
}

uint8_t hb_cmd_copy_cal_page(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    const hb_xcp_description* description = &slave->description;
    (void)length;
    if (packet[1] != 0 || packet[3] != 0) {
        return HB_ERR_SEGMENT_NOT_VALID;
    }
    if (packet[2] >= PAGES || packet[4] >= PAGES) {
        return HB_ERR_PAGE_NOT_VALID;
    }
    if (packet[4] == slave->active_page || packet[4] == slave->next_page) {
        return packet[2] == packet[4] ? HB_OK : HB_ERR_WRITE_PROTECTED; /* never under the running loop */
    }
    memcpy(description->pages[packet[4]], description->pages[packet[2]], description->page_octets);
    return HB_OK;
}

#if HB_FEATURE_FULL

uint8_t hb_cmd_get_segment_info(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    (void)length;
    if (packet[2] != 0) {
        return HB_ERR_SEGMENT_NOT_VALID;
    }
    slave->response_length = 8;
    if (packet[1] == 0 && packet[3] == 0) {
        hb_put32(&slave->response[4], HB_ADDRESS_SEGMENT);
    } else if (packet[1] == 0 && packet[3] == 1) {
        hb_put32(&slave->response[4], slave->description.page_octets);
    } else if (packet[1] == 1) {
        slave->response[1] = PAGES;
        slave->response[2] = HB_EXT_VALUES;
        slave->response_length = 6;
    } else {
        return packet[1] <= 2 ? HB_ERR_OUT_OF_RANGE : HB_ERR_MODE_NOT_VALID;
    }
    return HB_OK;
}

uint8_t hb_cmd_get_page_info(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    (void)length;
    if (packet[2] != 0) {
        return HB_ERR_SEGMENT_NOT_VALID;
    }
    if (packet[3] >= PAGES) {
        return HB_ERR_PAGE_NOT_VALID;
    }
    slave->response[1] = PAGE_READ_WRITE_ALWAYS;
    slave->response_length = 3;
    return HB_OK;
}

#endif

#if HB_FEATURE_STORE

static void sendStored(hb_xcp* slave) {
    const uint8_t event[2] = {0xFD, HB_EV_STORE_CAL};
    hb_xcp_send(slave, event, sizeof event);
}

void hb_xcp_stored(hb_xcp* slave) {
    slave->is_storing = 0;
    if (slave->connected) {
        sendStored(slave);
    }
}

/* Stores the page the control loop runs on. */
uint8_t hb_cmd_set_request(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    const hb_xcp_description* description = &slave->description;
    uint8_t result;
    (void)length;
    if (packet[1] != 0x01) {
        return HB_ERR_MODE_NOT_VALID;
    }
    if (!description->hooks.store) {
        return HB_ERR_ACCESS_DENIED;
    }
    result = description->hooks.store(description->board, description->pages[slave->next_page],
                                      description->page_octets);
    if (result == HB_STORE_REFUSED) {
        return HB_ERR_GENERIC;
    }
    slave->is_storing = result == HB_STORE_BEGUN;
    if (result == HB_STORE_DONE) {
        hb_xcp_send(slave, slave->response, slave->response_length);
        sendStored(slave);
        slave->response_length = 0; /* already answered, before the event */
    }
    return HB_OK;
}

#endif
