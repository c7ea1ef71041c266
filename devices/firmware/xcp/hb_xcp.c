/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_xcp.h"

#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <string.h>

enum { RES = 0xFF, ERR = 0xFE, EV = 0xFD, SERV = 0xFC };
enum { CMD_CONNECT = 0xFF, CMD_DISCONNECT = 0xFE, CMD_SYNCH = 0xFC, CMD_USER = 0xF1 };
enum { USER_STOP = 0x45, USER_RESET = 0x52 };
enum { RESOURCE_CAL_DAQ = 0x05, COMM_BLOCK_AND_INFO = 0xC0, SESSION_DAQ_RUNNING = 0x40 };
enum { PROTOCOL_VERSION = 1, TRANSPORT_VERSION = 1 };

typedef uint8_t (*command_function)(hb_xcp* slave, const uint8_t* packet, hb_length length);

typedef struct {
    uint8_t code;
    uint8_t min_length;
    command_function run;
} command;

void hb_xcp_send(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    HB_LOCK();
    if (hb_queue_free(&slave->queue) < length + HB_PACKET_OVERHEAD) {
        hb_queue_skip(&slave->queue, 1);
    } else {
        hb_queue_begin(&slave->queue, length);
        hb_queue_put(&slave->queue, packet, length);
    }
    HB_UNLOCK();
}

void hb_xcp_answer(hb_xcp* slave, uint8_t result) {
    if (result != HB_OK) {
        slave->response[0] = ERR;
        slave->response[1] = result;
        slave->response_length = 2;
    }
    if (slave->response_length > 0) {
        hb_xcp_send(slave, slave->response, slave->response_length);
    }
}

static void startSession(hb_xcp* slave) {
    hb_daq_clear(slave);
    hb_queue_clear(&slave->queue);
    slave->block_left = 0;
    slave->sum_left = 0;
    slave->mta_extension = 0;
    slave->mta_address = 0;
    slave->xcp_page = slave->next_page;
    slave->silent_ms = 0;
    slave->connected = 1;
}

static uint8_t connectCommand(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    (void)length;
    if (packet[1] != 0) {
        return HB_ERR_MODE_NOT_VALID;
    }
    startSession(slave);
    slave->response[1] = RESOURCE_CAL_DAQ;
    slave->response[2] = COMM_BLOCK_AND_INFO;
    slave->response[3] = HB_MAX_CTO;
    hb_put16(&slave->response[4], hb_xcp_max_dto(&slave->description));
    slave->response[6] = PROTOCOL_VERSION;
    slave->response[7] = TRANSPORT_VERSION;
    slave->response_length = 8;
    return HB_OK;
}

static uint8_t disconnectCommand(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    (void)packet;
    (void)length;
    hb_daq_clear(slave);
    slave->connected = 0;
    return HB_OK;
}

static uint8_t getStatus(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    (void)packet;
    (void)length;
    slave->response[1] = hb_daq_is_running(slave) ? SESSION_DAQ_RUNNING : 0;
    slave->response[1] |= slave->is_storing; /* bit 0 */
    slave->response_length = 6;
    return HB_OK;
}

static uint8_t synch(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    (void)packet;
    (void)length;
    slave->block_left = 0;
    return HB_ERR_SYNCH;
}

/* What is the same on every board of this build: octets 1 to 7 of the answer, of so many in all. */
typedef struct {
    uint8_t code, length;
    uint8_t octets[7];
} fixed_answer;

enum { CMD_COMM_MODE_INFO = 0xFB, CMD_PAG_PROCESSOR_INFO = 0xE9, CMD_DAQ_RESOLUTION_INFO = 0xD9 };
enum { LIBRARY_VERSION = 0x10, TIMESTAMP_4_OCTETS_1_US = 0x34 };

static const fixed_answer FixedAnswers[] HB_ROM = {
    {CMD_COMM_MODE_INFO, 8, {0, 0, 0, 0, 0, 0, LIBRARY_VERSION}},
    {CMD_PAG_PROCESSOR_INFO, 3, {1, 0, 0, 0, 0, 0, 0}},
    {CMD_DAQ_RESOLUTION_INFO, 8, {1, HB_MAX_ENTRY_OCTETS, 1, 0, TIMESTAMP_4_OCTETS_1_US, 1, 0}},
};

static uint8_t answerFixed(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    const fixed_answer* answer = FixedAnswers;
    (void)length;
    while (hb_rom_octet(&answer->code) != packet[0]) {
        answer++;
    }
    hb_rom_copy(&slave->response[1], answer->octets, sizeof answer->octets);
    slave->response_length = hb_rom_octet(&answer->length);
    return HB_OK;
}

/* Stop and reset by command; the decision is the board's and does not depend on the session. */
static uint8_t userCommand(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    const hb_xcp_hooks* hooks = &slave->description.hooks;
    (void)length;
    if (packet[1] == USER_STOP && hooks->stop) {
        slave->response[1] = hooks->stop(slave->description.board);
    } else if (packet[1] == USER_RESET && hooks->reset) {
        slave->response[1] = hooks->reset(slave->description.board);
    } else {
        return HB_ERR_CMD_UNKNOWN;
    }
    slave->response_length = 2;
    return HB_OK;
}

static const command Commands[] HB_ROM = {
    {CMD_CONNECT, 2, connectCommand},
    {CMD_DISCONNECT, 1, disconnectCommand},
    {0xFD, 1, getStatus},
    {CMD_SYNCH, 1, synch},
    {CMD_COMM_MODE_INFO, 1, answerFixed},
    {0xFA, 2, hb_cmd_get_id},
    {0xF6, 8, hb_cmd_set_mta},
    {0xF5, 2, hb_cmd_upload},
    {0xF4, 8, hb_cmd_short_upload},
    {0xF3, 8, hb_cmd_build_checksum},
    {CMD_USER, 2, userCommand},
    {0xF0, 2, hb_cmd_download},
    {0xED, 8, hb_cmd_short_download},
    {0xEB, 4, hb_cmd_set_cal_page},
    {0xEA, 3, hb_cmd_get_cal_page},
    {CMD_PAG_PROCESSOR_INFO, 1, answerFixed},
    {0xE4, 5, hb_cmd_copy_cal_page},
    {0xE2, 6, hb_cmd_set_daq_ptr},
    {0xE1, 8, hb_cmd_write_daq},
    {0xE0, 8, hb_cmd_set_daq_list_mode},
    {0xDE, 4, hb_cmd_start_stop_daq_list},
    {0xDD, 2, hb_cmd_start_stop_synch},
    {0xDC, 1, hb_cmd_get_daq_clock},
    {0xDA, 1, hb_cmd_get_daq_processor_info},
    {CMD_DAQ_RESOLUTION_INFO, 1, answerFixed},
    {0xD7, 4, hb_cmd_get_daq_event_info},
    {0xD6, 1, hb_cmd_free_daq},
    {0xD5, 4, hb_cmd_alloc_daq},
    {0xD4, 5, hb_cmd_alloc_odt},
    {0xD3, 6, hb_cmd_alloc_odt_entry},
#if HB_FEATURE_STORE
    {0xF9, 4, hb_cmd_set_request},
#endif
#if HB_FEATURE_FULL
    {0xE8, 5, hb_cmd_get_segment_info},
    {0xE7, 4, hb_cmd_get_page_info},
    {0xDF, 4, hb_cmd_get_daq_list_mode},
    {0xC7, 2, hb_cmd_write_daq_multiple},
    {0xC0, 2, hb_cmd_get_version},
#endif
};

void hb_xcp_init(hb_xcp* slave, const hb_xcp_description* description) {
    memset(slave, 0, sizeof *slave);
    slave->description = *description;
    hb_a2l_identify(slave);
}

/* Commands that change what the control tick uses: session, measurement lists, latches. All of them are
 * short; the long ones only read, or lock the little that they change. */
static uint8_t isShared(uint8_t code) {
    enum { FIRST_DAQ = 0xD3, LAST_DAQ = 0xE2 };
    return code >= CMD_DISCONNECT || code == CMD_USER || (code >= FIRST_DAQ && code <= LAST_DAQ);
}

static uint8_t run(hb_xcp* slave, command_function function, const uint8_t* packet, hb_length length) {
    uint8_t result;
    if (!isShared(packet[0])) {
        return function(slave, packet, length);
    }
    HB_LOCK();
    result = function(slave, packet, length);
    HB_UNLOCK();
    return result;
}

static uint8_t execute(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    for (uint8_t i = 0; i < sizeof Commands / sizeof Commands[0]; i++) {
        if (hb_rom_octet(&Commands[i].code) == packet[0]) {
            command entry;
            hb_rom_copy(&entry, &Commands[i], sizeof entry);
            return length < entry.min_length ? (uint8_t)HB_ERR_CMD_SYNTAX
                                             : run(slave, entry.run, packet, length);
        }
    }
    return HB_ERR_CMD_UNKNOWN;
}

/* Not connected, the slave obeys CONNECT and the stop, and answers only the former. */
static void receiveUnconnected(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    if (packet[0] == CMD_USER && length >= 2 && packet[1] == USER_STOP) {
        slave->response_length = 1;
        (void)run(slave, userCommand, packet, length);
    } else if (packet[0] == CMD_CONNECT && length >= 2 && packet[1] == 0) {
        slave->response[0] = RES;
        (void)run(slave, connectCommand, packet, length);
        hb_xcp_send(slave, slave->response, slave->response_length);
    }
}

/* Lower first octets are stimulation data, which are never answered. */
enum { FIRST_COMMAND = 0xC0 };

/* Octets that a command finds cleared in its response. */
enum { SHORT_RESPONSE = 8 };

void hb_xcp_receive(hb_xcp* slave, const uint8_t* packet, uint16_t length) {
    uint8_t result;
    if (length == 0 || length > HB_MAX_CTO || packet[0] < FIRST_COMMAND) {
        return;
    }
    if (!slave->connected) {
        receiveUnconnected(slave, packet, (hb_length)length);
        return;
    }
    if (slave->sum_left > 0) { /* whoever asks for more has the stop answered before the rest of a checksum */
        slave->sum_left = 0;
        hb_xcp_answer(slave, HB_ERR_BUSY);
    }
    memset(slave->response, 0, SHORT_RESPONSE);
    slave->response[0] = RES;
    slave->response_length = 1;
    result = execute(slave, packet, (hb_length)length);
    if (result != HB_ERR_CMD_UNKNOWN && result != HB_ERR_CMD_SYNTAX) {
        HB_LOCK();
        slave->silent_ms = 0;
        HB_UNLOCK();
    }
    hb_xcp_answer(slave, result);
    hb_memory_continue(slave);
}

uint16_t hb_xcp_transmit(hb_xcp* slave, uint8_t* packet, uint16_t capacity) {
    const hb_length room = capacity < HB_RING_OCTETS ? (hb_length)capacity : (hb_length)(HB_RING_OCTETS - 1);
    hb_length length;
    HB_LOCK();
    length = hb_queue_take(&slave->queue, packet, room, &slave->last_counter);
    HB_UNLOCK();
    hb_memory_continue(slave);
    return length;
}

uint16_t hb_xcp_counter(const hb_xcp* slave) {
    return slave->last_counter;
}

uint8_t hb_xcp_watchdog_expired(hb_xcp* slave, uint16_t limit_ms) {
    if (limit_ms == 0) {
        slave->silent_ms = 0;
        return 0;
    }
    if (slave->silent_ms < limit_ms) {
        slave->silent_ms = (uint16_t)(slave->silent_ms + HB_TICK_MS);
    }
    return slave->silent_ms >= limit_ms;
}

void hb_xcp_end_session(hb_xcp* slave, uint8_t reason) {
    uint8_t packet[3];
    if (slave->connected) {
        packet[0] = EV;
        packet[1] = HB_EV_SESSION_TERMINATED;
        packet[2] = reason;
        hb_daq_clear(slave);
        hb_xcp_send(slave, packet, 3);
        slave->connected = 0;
        slave->block_left = 0;
    }
    slave->silent_ms = 0;
}

/* Octet by octet from where it lies: the caller may be the control tick on a small stack. */
static void sendServiceText(hb_xcp* slave, hb_rom_char* text) {
    enum { FRAME = 3, LONGEST = HB_MAX_CTO - FRAME };
    uint8_t frame[FRAME] = {SERV, 1, 0};
    hb_length length = 0;
    while (text[length] && text[length] != '|' && length < LONGEST) {
        length++;
    }
    if (hb_queue_free(&slave->queue) < length + FRAME + HB_PACKET_OVERHEAD) {
        hb_queue_skip(&slave->queue, 1);
        return;
    }
    hb_queue_begin(&slave->queue, (hb_length)(length + FRAME));
    hb_queue_put(&slave->queue, frame, FRAME - 1);
    for (hb_length i = 0; i < length; i++) {
        uint8_t octet = (uint8_t)text[i];
        hb_queue_put(&slave->queue, &octet, 1);
    }
    hb_queue_put(&slave->queue, &frame[FRAME - 1], 1);
}

void hb_xcp_report_user_event(hb_xcp* slave, uint8_t code, hb_rom_char* text) {
    uint8_t packet[3];
    if (slave->connected) {
        packet[0] = EV;
        packet[1] = HB_EV_USER;
        packet[2] = code;
        hb_xcp_send(slave, packet, sizeof packet);
        sendServiceText(slave, text);
    }
}

const void* hb_xcp_take_page(hb_xcp* slave) {
    slave->active_page = slave->next_page;
    return slave->description.pages[slave->active_page];
}
