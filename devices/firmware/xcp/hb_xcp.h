/* SPDX-License-Identifier: MIT */
#ifndef HB_XCP_H
#define HB_XCP_H

/* XCP slave, the subset of resources/help/protocol.md section 3. Portable, no heap, no globals: one `hb_xcp`
 * is one slave. Packets go in by hb_xcp_receive() and come out of hb_xcp_transmit(); framing and counters on
 * the wire are the transport's. Call everything from one context; or let the control tick interrupt the rest
 * and give HB_LOCK and HB_UNLOCK (hb_config.h), which hold it back. */

#include "devices/firmware/xcp/hb_queue.h"
#include "devices/firmware/xcp/hb_table.h"

#ifdef __cplusplus
extern "C" {
#endif

#define HB_LIBRARY_VERSION "0.3.0"

enum hb_xcp_error {
    HB_OK = 0xFF, /* not an error code of the protocol: "answer RES" */
    HB_ERR_SYNCH = 0x00,
    HB_ERR_BUSY = 0x10,
    HB_ERR_DAQ_ACTIVE = 0x11,
    HB_ERR_CMD_UNKNOWN = 0x20,
    HB_ERR_CMD_SYNTAX = 0x21,
    HB_ERR_OUT_OF_RANGE = 0x22,
    HB_ERR_WRITE_PROTECTED = 0x23,
    HB_ERR_ACCESS_DENIED = 0x24,
    HB_ERR_PAGE_NOT_VALID = 0x26,
    HB_ERR_MODE_NOT_VALID = 0x27,
    HB_ERR_SEGMENT_NOT_VALID = 0x28,
    HB_ERR_SEQUENCE = 0x29,
    HB_ERR_DAQ_CONFIG = 0x2A,
    HB_ERR_MEMORY_OVERFLOW = 0x30,
    HB_ERR_GENERIC = 0x31
};

enum hb_xcp_event_code {
    HB_EV_STORE_CAL = 3,
    HB_EV_DAQ_OVERLOAD = 6,
    HB_EV_SESSION_TERMINATED = 7,
    HB_EV_USER = 0xFE
};

/* Address map: extension 0, 8*i = signal i; 0x8000 + offset = live parameter; 0xC000 + offset = further
 * parameter of the caller; 0x10000 + offset = segment 0 through the XCP page; extension 1 = A2L text; 2 =
 * block (capture data); 3 = names, for GET_ID and event names. */
#define HB_ADDRESS_LIVE ((uint32_t)0x8000)
#define HB_ADDRESS_EXTRA ((uint32_t)0xC000)
#define HB_ADDRESS_SEGMENT ((uint32_t)0x10000)
enum hb_xcp_extension {
    HB_EXT_VALUES = 0,
    HB_EXT_A2L = 1,
    HB_EXT_BLOCK = 2,
    HB_EXT_NAMES = 3,
    HB_EXT_SEGMENT = 4, /* these two not on the wire: segment 0 from its start, nothing */
    HB_EXT_NONE = 5
};

/* HB_STORE_BEGUN: hb_xcp_stored() will follow. */
enum hb_store { HB_STORE_REFUSED, HB_STORE_DONE, HB_STORE_BEGUN };

/* What the board tells the slave. Every hook may be NULL. `parameter` is the index into the parameter table,
 * and behind its end into the further parameters. */
typedef struct {
    /* Before a value is taken: HB_OK or the error to answer. `value` is already within the limits. */
    uint8_t (*check)(void* board, uint16_t parameter, float value);
    void (*written)(void* board, uint16_t parameter);
    uint8_t (*stop)(void* board);  /* USER_CMD 45; returns the latch code for the response */
    uint8_t (*reset)(void* board); /* USER_CMD 52 */
    void (*read_block)(void* board, hb_address offset, uint8_t* destination, uint16_t count);
    /* SET_REQUEST; what comes of it is one of hb_store. */
    uint8_t (*store)(void* board, const void* page, uint16_t octets);
} hb_xcp_hooks;

typedef struct {
    const char* model;                         /* GET_ID 1: name of the A2L without extension, e.g. "htm" */
    const char* device;                        /* GET_ID 0: e.g. "sim-htm-1" */
    const char* variant;                       /* appended to the EPK; may be empty */
    hb_signal_table signals[HB_SIGNAL_TABLES]; /* handles run through them; the second may be empty */
    const hb_parameter* parameters;
    uint16_t parameter_count;
    const hb_event* events;
    uint8_t event_count;
    uint8_t* pages[2];
    uint16_t page_octets;
    uint8_t* live;
    uint16_t live_octets;
    hb_address block_octets;
#if HB_FEATURE_FULL            /* a small board knows its line when it is compiled */
    const char* transport_a2l; /* A2L block of the line this board is served on; NULL: HB_A2L_TRANSPORT */
    uint16_t max_dto;          /* longest measurement packet that line carries; 0: HB_MAX_DTO */
    hb_parameter_table extra;  /* further parameters; may be empty */
#endif
    hb_xcp_hooks hooks;
    void* board;
} hb_xcp_description;

typedef struct {
    const uint8_t* source;
    uint8_t size;
} hb_daq_entry;

typedef struct {
    hb_daq_count first_entry;
    hb_daq_count entry_count;
    hb_daq_count octets; /* of all entries written so far */
} hb_daq_odt;

typedef struct {
    uint8_t first_odt, odt_count;
    uint8_t mode; /* HB_DAQ_... bits below */
    uint8_t event, prescaler, countdown, priority;
} hb_daq_list;

enum { HB_DAQ_TIMESTAMP = 0x10, HB_DAQ_SELECTED = 0x01, HB_DAQ_RUNNING = 0x40 };

typedef struct {
    uint8_t stage; /* 0 none, 1 freed, 2 lists, 3 ODTs, 4 entries */
    uint8_t list_count, odt_count;
    hb_daq_count entry_count;
    hb_daq_odt* write_odt; /* what the next WRITE_DAQ fills; NULL: nothing */
    hb_daq_count write_entry;
    uint8_t writes_first_odt; /* the one with the time stamp */
    uint8_t overload_reported;
    hb_daq_list lists[HB_DAQ_LISTS];
    hb_daq_odt odts[HB_DAQ_ODTS];
    hb_daq_entry entries[HB_DAQ_ENTRIES];
} hb_daq;

typedef struct {
    hb_address length; /* 0 = not yet known */
    uint32_t epk_hash; /* over all tables */
    uint16_t item;     /* where the last read left off */
    hb_extent row;
    hb_address item_offset;
} hb_a2l_cursor;

typedef struct hb_xcp {
    uint32_t time_us; /* device clock, set by the board before its events */
    uint16_t silent_ms;
    uint8_t connected;
    uint8_t active_page; /* what the control loop reads in this cycle */
    uint8_t next_page;   /* what it will take at the start of its next cycle */
    uint8_t xcp_page;    /* what the master reads and writes */
    uint8_t mta_extension;
    uint8_t is_storing;
    uint8_t block_left; /* octets of a block-mode UPLOAD still to be sent */
    hb_address mta_address;
    hb_address sum_left; /* octets of a BUILD_CHECKSUM still to be read */
    uint16_t sum;
    uint16_t last_counter;
    uint8_t response_length;
    uint8_t response[HB_MAX_CTO];
    hb_xcp_description description; /* behind what small processors reach with short instructions */
    hb_a2l_cursor a2l;
    hb_daq daq;
    hb_queue queue;
} hb_xcp;

void hb_xcp_init(hb_xcp* slave, const hb_xcp_description* description);
/* One packet from the master. Damaged or unknown content is answered as the protocol says; never more than
 * `length` octets are read. */
void hb_xcp_receive(hb_xcp* slave, const uint8_t* packet, uint16_t length);
/* Next packet to send, 0 if none. hb_xcp_counter() is then its message counter; a gap means dropped samples.
 */
uint16_t hb_xcp_transmit(hb_xcp* slave, uint8_t* packet, uint16_t capacity);
uint16_t hb_xcp_counter(const hb_xcp* slave);
/* Sends the samples of all running lists of this event. */
void hb_xcp_event(hb_xcp* slave, uint8_t event);
/* Once a control tick: counts its HB_TICK_MS of silence; returns 1 when `limit_ms` (not 0) is reached. */
uint8_t hb_xcp_watchdog_expired(hb_xcp* slave, uint16_t limit_ms);
/* Ends the session from the slave's side: EV 07 with `reason`, DAQ stopped. */
void hb_xcp_end_session(hb_xcp* slave, uint8_t reason);
/* A save that took its time has ended. */
void hb_xcp_stored(hb_xcp* slave);
/* EV FE with one octet, and the same in words as SERV text: HB_ROM text up to its end or to '|'. */
void hb_xcp_report_user_event(hb_xcp* slave, uint8_t code, hb_rom_char* text);
/* Start of a control cycle: takes the page switch with one store and returns the active page. */
const void* hb_xcp_take_page(hb_xcp* slave);

#ifdef __cplusplus
}
#endif

#endif
