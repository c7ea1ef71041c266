/* SPDX-License-Identifier: MIT */
#include "devices/firmware/board/hb_board.h"

#include "devices/firmware/board/hb_board_internal.h"
#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <math.h>
#include <string.h>

static void describe(hb_board* board, const hb_board_memory* memory, const hb_board_config* config,
                     hb_xcp_description* description) {
    const HB_FLASH hb_actuator* actuator = hb_board_actuator(board);
    memset(description, 0, sizeof *description);
    description->model = actuator->model;
    description->device = config->device ? config->device : actuator->model;
    description->variant = config->variant;
#if HB_FEATURE_FULL
    description->transport_a2l = config->transport_a2l;
    description->max_dto = config->max_dto;
#endif
    description->signals[0].entries = actuator->signals;
    description->signals[0].count = actuator->signal_count;
    description->signals[0].base = memory->signals;
#if HB_FEATURE_FULL
    description->signals[1] = config->extra;
    description->extra = config->extra_parameters;
#endif
    description->parameters = actuator->parameters;
    description->parameter_count = actuator->parameter_count;
    description->events = actuator->events;
    description->event_count = actuator->event_count;
    description->pages[0] = (uint8_t*)memory->pages[0];
    description->pages[1] = (uint8_t*)memory->pages[1];
    description->page_octets = actuator->page_octets;
    description->live = (uint8_t*)memory->live;
    description->live_octets = actuator->live_octets;
#if HB_FEATURE_CAPTURE
    description->block_octets = HB_CAPTURE_SIGNALS * HB_CAPTURE_SAMPLES * sizeof(float);
#endif
    description->hooks = hb_board_hooks(board);
    description->board = board;
}

static void loadPages(hb_board* board, const void* stored) {
    const hb_xcp_description* description = &board->xcp.description;
    if (stored) {
        memcpy(description->pages[0], stored, description->page_octets);
    }
    if (!stored || !hb_memory_page_is_valid(&board->xcp, 0)) {
        hb_parameters_reset(description->parameters, description->parameter_count, HB_PAGED,
                            description->pages[0]);
    }
    memcpy(description->pages[1], description->pages[0], description->page_octets);
}

static void* at(void* base, uint16_t offset) {
    return (uint8_t*)base + offset;
}

void hb_board_init(hb_board* board, const HB_FLASH hb_actuator* actuator, const hb_board_memory* memory,
                   const hb_board_config* config) {
    const hb_board_config defaults = {0};
    hb_xcp_description description;
    config = config ? config : &defaults;
    memset(board, 0, sizeof *board);
    board->actuator = actuator;
    board->context = memory->context;
    board->live = (hb_board_live*)at(memory->live, actuator->live_offset);
    board->signals = (hb_board_signals*)at(memory->signals, actuator->signal_offset);
    board->outputs = (float*)at(memory->signals, actuator->output_offset);
    board->store = config->store;
    board->store_context = config->store_context;
#if HB_FEATURE_TRIAL
    board->trial_page = memory->trial_page;
#endif
    describe(board, memory, config, &description);
    hb_xcp_init(&board->xcp, &description);
    hb_parameters_reset(actuator->parameters, actuator->parameter_count, HB_LIVE, memory->live);
    loadPages(board, config->stored);
    hb_safety_init(&board->safety);
    hb_board_enter_mode(board, HB_MODE_IDLE);
#if HB_FEATURE_CAPTURE
    hb_capture_init(&board->capture);
#endif
}

static void watch(hb_board* board) {
    uint8_t somebody_counts_on_us = board->safety.armed || board->xcp.connected;
    if (hb_xcp_watchdog_expired(&board->xcp, somebody_counts_on_us ? board->live->watchdog_ms : 0)) {
        hb_board_stop(board, HB_LATCH_WATCHDOG);
#if HB_FEATURE_TRIAL
        hb_board_abandon_trial(board);
#endif
        hb_xcp_end_session(&board->xcp, HB_LATCH_WATCHDOG);
    }
}

/* The set that is seen is a mixture of two: its marks differ. */
static uint8_t isTorn(const hb_board* board, const void* page) {
    const void* last = (const uint8_t*)page + hb_board_actuator(board)->page_octets - sizeof(uint32_t);
    return *(const uint32_t*)page != *(const uint32_t*)last;
}

static uint8_t mayDrive(const hb_board* board) {
    return board->safety.armed && board->mode != HB_MODE_IDLE;
}

uint8_t hb_board_is_driving(const hb_board* board) {
#if HB_FEATURE_BRAKE
    if (board->brake_ticks > 0) {
        return 1;
    }
#endif
    return mayDrive(board);
}

static uint8_t outputsAreFinite(const hb_board* board) {
    for (uint8_t i = 0; i < hb_board_actuator(board)->output_count; i++) {
        if (!isfinite(board->outputs[i])) {
            return 0;
        }
    }
    return 1;
}

static void drive(hb_board* board, const void* page) {
    if (mayDrive(board)) {
        hb_board_actuator(board)->drive(board->context, page);
    }
#if HB_FEATURE_BRAKE
    else if (board->brake_ticks > 0) {
        board->brake_ticks--;
        if (!hb_board_actuator(board)->brake(board->context, page)) {
            board->brake_ticks = 0;
            memset(board->outputs, 0, hb_board_actuator(board)->output_count * sizeof(float));
        }
    }
#endif
    else {
        memset(board->outputs, 0, hb_board_actuator(board)->output_count * sizeof(float));
    }
    if (!outputsAreFinite(board)) {
        hb_board_raise_fault(board, HB_FAULT_NOT_FINITE);
    }
}

void hb_board_tick(hb_board* board, const void* inputs) {
    const HB_FLASH hb_actuator* actuator = hb_board_actuator(board);
    const void* page = hb_xcp_take_page(&board->xcp);
    board->signals->torn_count += isTorn(board, page);
    board->xcp.time_us = board->tick * (1000U * HB_TICK_MS);
    board->reference_started = 0;
    watch(board);
    actuator->sense(board->context, page, inputs);
    actuator->supervise(board->context, page);
    actuator->control(board->context, page);
    drive(board, page);
    board->signals->status = hb_safety_status(&board->safety);
    board->signals->fault = board->safety.fault;
#if HB_FEATURE_CAPTURE
    hb_board_capture_tick(board);
#endif
    hb_xcp_event(&board->xcp, 0);
    if (board->loop_phase == 0 && actuator->event_count > 1) {
        hb_xcp_event(&board->xcp, 1);
    }
    board->live->reference_start = actuator->advance(board->context) || board->reference_pending;
    board->loop_phase++;
    if (board->loop_phase >= actuator->loop_ticks) {
        board->loop_phase = 0;
    }
    board->tick++;
}

/* Another master takes over: never armed after that, and its orders count anew. A master that leaves an armed
 * board leaves it to the watchdog, but what it was trying ends at once. */
static void endOfMaster(hb_board* board, const uint8_t* packet, uint16_t length) {
    enum { CONNECT = 0xFF, DISCONNECT = 0xFE };
    uint8_t takes_over = length > 1 && packet[0] == CONNECT && packet[1] == 0;
    uint8_t leaves = length > 0 && packet[0] == DISCONNECT && board->xcp.connected;
    if (takes_over) {
        board->reference_order = 0;
#if HB_FEATURE_CAPTURE
        board->capture_order = 0;
#endif
        if (board->safety.armed) {
            hb_board_release(board);
        }
    }
#if HB_FEATURE_TRIAL
    if (takes_over || leaves) {
        hb_board_abandon_trial(board);
    }
#else
    (void)leaves;
#endif
}

void hb_board_receive(hb_board* board, const uint8_t* packet, uint16_t length) {
    HB_LOCK();
    endOfMaster(board, packet, length);
    HB_UNLOCK();
    hb_xcp_receive(&board->xcp, packet, length);
}

uint16_t hb_board_transmit(hb_board* board, uint8_t* packet, uint16_t capacity) {
    return hb_xcp_transmit(&board->xcp, packet, capacity);
}

uint16_t hb_board_counter(const hb_board* board) {
    return hb_xcp_counter(&board->xcp);
}
