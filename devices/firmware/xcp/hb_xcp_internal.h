/* SPDX-License-Identifier: MIT */
#ifndef HB_XCP_INTERNAL_H
#define HB_XCP_INTERNAL_H

/* Shared by the files of the slave; nobody else includes it. Command functions get the whole packet, with the
 * code in packet[0], have its minimum length checked, fill slave->response from octet 1 and return HB_OK or
 * an error. */

#include "devices/firmware/xcp/hb_xcp.h"

#ifdef __cplusplus
extern "C" {
#endif

static inline uint16_t hb_get16(const uint8_t* octets) {
    return (uint16_t)(octets[0] | ((uint16_t)octets[1] << 8));
}

static inline uint32_t hb_get32(const uint8_t* octets) {
    return (uint32_t)hb_get16(octets) | ((uint32_t)hb_get16(octets + 2) << 16);
}

static inline void hb_put16(uint8_t* octets, uint16_t value) {
    octets[0] = (uint8_t)value;
    octets[1] = (uint8_t)(value >> 8);
}

static inline void hb_put32(uint8_t* octets, uint32_t value) {
    hb_put16(octets, (uint16_t)value);
    hb_put16(octets + 2, (uint16_t)(value >> 16));
}

/* Longest measurement packet: what the build holds and the line carries. */
static inline uint16_t hb_xcp_max_dto(const hb_xcp_description* description) {
#if HB_FEATURE_FULL
    if (description->max_dto != 0 && description->max_dto < HB_MAX_DTO) {
        return description->max_dto;
    }
#else
    (void)description;
#endif
    return HB_MAX_DTO;
}

/* The parameters of the board, then the further ones. */
static inline uint16_t hb_xcp_parameter_count(const hb_xcp_description* description) {
#if HB_FEATURE_FULL
    return (uint16_t)(description->parameter_count + description->extra.count);
#else
    return description->parameter_count;
#endif
}

static inline const hb_parameter* hb_xcp_parameter(const hb_xcp_description* description, uint16_t index) {
#if HB_FEATURE_FULL
    if (index >= description->parameter_count) {
        return &description->extra.entries[index - description->parameter_count];
    }
#endif
    return &description->parameters[index];
}

/* Response of `length` octets whose first is the packet identifier. */
void hb_xcp_send(hb_xcp* slave, const uint8_t* packet, hb_length length);
/* slave->response for HB_OK, else the error. */
void hb_xcp_answer(hb_xcp* slave, uint8_t result);

/* hb_xcp_memory.c: every access goes through the tables. */
/* Takes extension and address as they come in a command. */
void hb_memory_set_mta(hb_xcp* slave, uint8_t extension, const uint8_t address[4]);
/* `count` octets at the MTA, which moves behind them if all is well. */
uint8_t hb_memory_read(hb_xcp* slave, uint8_t* destination, uint8_t count);
uint8_t hb_memory_write(hb_xcp* slave, const uint8_t* source, uint8_t count);
/* The table that holds signal `index`, which becomes the index within that table; NULL behind the last. */
const hb_signal_table* hb_memory_signal_table(const hb_xcp* slave, uint16_t* index);
/* Variable behind the address of one signal; NULL if there is none of at least `size` octets. */
const uint8_t* hb_memory_signal(const hb_xcp* slave, hb_address address, uint8_t size);
/* 1 if every parameter of the page is finite and within its limits. */
uint8_t hb_memory_page_is_valid(const hb_xcp* slave, uint8_t page);
uint8_t hb_cmd_set_mta(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_upload(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_short_upload(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_build_checksum(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_download(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_short_download(hb_xcp* slave, const uint8_t* packet, hb_length length);
/* Goes on with a block-mode UPLOAD or a BUILD_CHECKSUM; on a small board one step, so that a stop never waits
 * for the rest. */
void hb_memory_continue(hb_xcp* slave);

/* hb_xcp_info.c */
uint8_t hb_cmd_get_id(hb_xcp* slave, const uint8_t* packet, hb_length length);
/* Texts at extension 3: GET_ID types at 256 * type, event names at 0x1000 + 16 * event. */
uint8_t hb_names_octet(hb_xcp* slave, hb_address address, uint8_t* octet);
#define HB_EVENT_NAMES ((hb_address)0x1000)
/* hb_xcp_pages.c */
uint8_t hb_cmd_set_cal_page(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_get_cal_page(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_copy_cal_page(hb_xcp* slave, const uint8_t* packet, hb_length length);
#if HB_FEATURE_STORE
uint8_t hb_cmd_set_request(hb_xcp* slave, const uint8_t* packet, hb_length length);
#endif
#if HB_FEATURE_FULL
uint8_t hb_cmd_get_segment_info(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_get_page_info(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_get_version(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_write_daq_multiple(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_get_daq_list_mode(hb_xcp* slave, const uint8_t* packet, hb_length length);
#endif

/* Octets of a measurement packet: its number, the time in the first of a list, the longest entry. */
enum { HB_PID_OCTETS = 1, HB_TIMESTAMP_OCTETS = 4, HB_MAX_ENTRY_OCTETS = 8 };

/* hb_xcp_daq.c (allocation, contents) and hb_xcp_daq_run.c (modes, start, samples) */
uint8_t hb_cmd_free_daq(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_alloc_daq(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_alloc_odt(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_alloc_odt_entry(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_set_daq_ptr(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_write_daq(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_set_daq_list_mode(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_start_stop_daq_list(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_start_stop_synch(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_get_daq_clock(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_get_daq_processor_info(hb_xcp* slave, const uint8_t* packet, hb_length length);
uint8_t hb_cmd_get_daq_event_info(hb_xcp* slave, const uint8_t* packet, hb_length length);
/* The list that octets 2 and 3 of a command name; NULL if there is none. */
hb_daq_list* hb_daq_list_at(hb_xcp* slave, const uint8_t* packet);
void hb_daq_clear(hb_xcp* slave);
void hb_daq_stop_all(hb_xcp* slave);
uint8_t hb_daq_is_running(const hb_xcp* slave);

/* hb_a2l.c, hb_epk.c */
hb_address hb_a2l_length(hb_xcp* slave);
void hb_a2l_read(hb_xcp* slave, hb_address offset, uint8_t* destination, uint16_t count);
/* Computes what the EPK says about the tables: some milliseconds on a small processor. */
void hb_a2l_identify(hb_xcp* slave);
/* "0.3.0-0x1A2B3C4D" plus the variant, zero ended. */
enum { HB_EPK_CAPACITY = HB_FEATURE_FULL ? 64 : 20 };
void hb_a2l_epk(hb_xcp* slave, char text[HB_EPK_CAPACITY]);

#ifdef __cplusplus
}
#endif

#endif
