/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <string.h>

enum { ID_TEXT = 0, ID_MODEL = 1, ID_A2L = 4, ID_EPK = 5, INLINE_HEADER = 8, EVENT_STRIDE = 16 };

/* The identification of one type, copied to `text` where it is not the description's own. NULL: none. */
static const char* identification(hb_xcp* slave, uint8_t type, char text[HB_EPK_CAPACITY]) {
    switch (type) {
    case ID_TEXT:
        return slave->description.device;
    case ID_MODEL:
        return slave->description.model;
    case ID_EPK:
        hb_a2l_epk(slave, text);
        return text;
    default:
        return NULL;
    }
}

#if HB_FEATURE_FULL

static uint8_t identificationOctet(hb_xcp* slave, hb_address address, uint8_t* octet) {
    char epk[HB_EPK_CAPACITY];
    const char* text = identification(slave, (uint8_t)(address >> 8), epk);
    if (!text || strlen(text) <= (address & 0xFF)) {
        return 0;
    }
    *octet = (uint8_t)text[address & 0xFF];
    return 1;
}

#endif

uint8_t hb_names_octet(hb_xcp* slave, hb_address address, uint8_t* octet) {
    const hb_xcp_description* description = &slave->description;
    if (address >= HB_EVENT_NAMES) {
        hb_address index = (hb_address)(address - HB_EVENT_NAMES) / EVENT_STRIDE;
        hb_event event;
        if (index >= description->event_count || address % EVENT_STRIDE >= sizeof event.name) {
            return 0;
        }
        hb_rom_copy(&event, &description->events[index], sizeof event);
        *octet = (uint8_t)event.name[address % EVENT_STRIDE];
        return 1;
    }
#if HB_FEATURE_FULL
    return identificationOctet(slave, address, octet);
#else
    return 0;
#endif
}

uint8_t hb_cmd_get_id(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    char epk[HB_EPK_CAPACITY];
    const char* text = identification(slave, packet[1], epk);
    hb_address octets = 0;
    (void)length;
    slave->response_length = INLINE_HEADER;
    if (packet[1] == ID_A2L) {
        slave->mta_extension = HB_EXT_A2L;
        slave->mta_address = 0;
        octets = hb_a2l_length(slave);
    } else if (text) {
        octets = (hb_address)strlen(text);
        if (octets + INLINE_HEADER <= HB_MAX_CTO) {
            slave->response[1] = 1;
            memcpy(&slave->response[INLINE_HEADER], text, octets);
            slave->response_length = (uint8_t)(INLINE_HEADER + octets);
        } else {
#if HB_FEATURE_FULL
            slave->mta_extension = HB_EXT_NAMES;
            slave->mta_address = (hb_address)packet[1] << 8;
#else
            return HB_ERR_OUT_OF_RANGE; /* a small board's names fit into one answer */
#endif
        }
    } else if (packet[1] > ID_EPK) {
        return HB_ERR_OUT_OF_RANGE;
    }
    hb_put32(&slave->response[4], octets);
    return HB_OK;
}

#if HB_FEATURE_FULL

uint8_t hb_cmd_get_version(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    (void)length;
    if (packet[1] != 0) {
        return HB_ERR_CMD_UNKNOWN;
    }
    slave->response[2] = 1; /* protocol 1.4, transport 1.4 */
    slave->response[3] = 4;
    slave->response[4] = 1;
    slave->response[5] = 4;
    slave->response_length = 6;
    return HB_OK;
}

#endif
