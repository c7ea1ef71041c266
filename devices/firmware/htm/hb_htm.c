/* SPDX-License-Identifier: MIT */
#include "devices/firmware/htm/hb_htm.h"

#include "devices/firmware/htm/hb_htm_internal.h"
#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <math.h>
#include <string.h>

enum { LOOP_TICKS = 10 / HB_TICK_MS };
#define DAC_CODES_PER_A 409.6F /* 4096 codes, 5 V, 2 A/V */
#define DAC_MIDDLE 2048.0F
#define DAC_HIGHEST 4095.0F

static uint16_t liveOffset(uint16_t parameter) {
    hb_parameter numbers;
    hb_parameter_read(&hb_htm_parameter_table[parameter], &numbers);
    return numbers.space == HB_LIVE ? numbers.entry.offset : 0xFFFF;
}

static uint8_t drivesCurrent(const hb_htm* board) {
    return board->safety.armed && (board->mode == HB_MODE_CURRENT || board->mode == HB_MODE_D_AXIS);
}

/* What the tables' limits cannot say. */
static uint8_t checkParameter(void* context, uint16_t parameter, float value) {
    const hb_htm* board = (const hb_htm*)context;
    uint16_t offset = liveOffset(parameter);
    if (offset == offsetof(hb_htm_live, arm) && value > 0.5F && hb_safety_latch(&board->safety)) {
        return HB_ERR_ACCESS_DENIED;
    }
    if (offset == offsetof(hb_htm_live, reference_start) && value > 0.5F && !board->safety.armed) {
        return HB_ERR_ACCESS_DENIED;
    }
#if !HB_FEATURE_GENERATOR
    if (offset == offsetof(hb_htm_live, reference.shape) &&
        (value == (float)HB_SHAPE_CHIRP || value == (float)HB_SHAPE_MULTISINE)) {
        return HB_ERR_OUT_OF_RANGE;
    }
#endif
    if (offset == offsetof(hb_htm_live, arm) && value > 0.5F && !board->sensing.started) {
        return HB_ERR_BUSY; /* the position to start from is not known before the first tick */
    }
    if (offset == offsetof(hb_htm_live, watchdog_ms) && value < 0.5F && board->safety.armed) {
        return HB_ERR_OUT_OF_RANGE; /* nobody would end the motion of a master that is gone */
    }
    if (offset == offsetof(hb_htm_live, setpoint) && drivesCurrent(board) &&
        fabsf(value) > board->pages[board->xcp.active_page].limit_current) {
        return HB_ERR_OUT_OF_RANGE;
    }
    return HB_OK;
}

/* 1 starts every time; another number starts once, so that a master that got no answer may repeat it
 * (resources/help/protocol.md 3.15). */
static uint8_t isNewOrder(uint8_t* last, uint8_t order) {
    uint8_t is_new = order == 1U || order != *last;
    *last = order;
    return is_new;
}

static void startOrStopReference(hb_htm* board) {
    uint8_t order = board->live.reference_start;
    if (order == 0) {
        board->reference_pending = 0;
        hb_reference_stop(&board->reference);
    } else if (isNewOrder(&board->reference_order, order)) {
        board->reference_pending = 1;
    }
}

#if HB_FEATURE_CAPTURE
static uint8_t isCapturing(const hb_htm* board) {
    return board->capture.state != HB_CAPTURE_IDLE && board->capture.state != HB_CAPTURE_FULL;
}

/* Also after the tick's sample, so that a full capture shows at once. */
static void publishCapture(hb_htm* board) {
    board->signals.capture_state = board->capture.state;
    board->signals.capture_time_us = board->capture.trigger_time_us;
}

static void startOrStopCapture(hb_htm* board) {
    uint8_t order = board->live.capture_start;
    if (order == 0) {
        hb_capture_stop(&board->capture);
    } else if (isNewOrder(&board->capture_order, order)) {
        hb_capture_start(&board->capture, &board->live.capture);
    }
    board->live.capture_start = isCapturing(board);
    publishCapture(
        board); /* whoever asks before the next tick asks for this capture, not for the one before */
}
#endif

/* Live parameters act here, in the receive path; paged ones at the next control cycle. */
static void parameterWritten(void* context, uint16_t parameter) {
    hb_htm* board = (hb_htm*)context;
    uint16_t offset = liveOffset(parameter);
    if (offset == offsetof(hb_htm_live, arm)) {
        if (board->live.arm) {
            hb_htm_arm(board);
        } else {
            hb_htm_release(board);
        }
    } else if (offset == offsetof(hb_htm_live, mode)) {
        if (board->safety.armed && board->live.mode != board->mode) {
            hb_htm_enter_mode(board, board->live.mode);
        }
    } else if (offset == offsetof(hb_htm_live, stop)) {
        if (board->live.stop) {
            hb_htm_stop(board, HB_LATCH_COMMAND);
        }
        board->live.stop = board->safety.stop == HB_LATCH_COMMAND; /* only the reset command clears it */
    } else if (offset == offsetof(hb_htm_live, reference_start)) {
        startOrStopReference(board);
    }
#if HB_FEATURE_TRIAL
    else if (offset == offsetof(hb_htm_live, trial)) {
        if (board->live.trial) {
            hb_htm_begin_trial(board);
        }
    }
#endif
#if HB_FEATURE_CAPTURE
    else if (offset == offsetof(hb_htm_live, capture_start)) {
        startOrStopCapture(board);
    }
#endif
}

static uint8_t stopByCommand(void* context) {
    return hb_htm_stop((hb_htm*)context, HB_LATCH_COMMAND);
}

static uint8_t resetByCommand(void* context) {
    hb_htm* board = (hb_htm*)context;
    hb_safety_reset(&board->safety);
    board->live.stop = 0;
    return hb_safety_latch(&board->safety);
}

#if HB_FEATURE_CAPTURE
static void readCapture(void* context, hb_address offset, uint8_t* destination, uint16_t count) {
    const hb_htm* board = (const hb_htm*)context;
    for (uint16_t i = 0; i < count; i++) {
        uint32_t octet = offset + i;
        uint16_t sample = (uint16_t)(octet / sizeof(float) % HB_CAPTURE_SAMPLES);
        uint16_t channel = (uint16_t)(octet / sizeof(float) / HB_CAPTURE_SAMPLES);
        float value = hb_capture_sample(&board->capture, channel, sample);
        uint8_t octets[sizeof value];
        memcpy(octets, &value, sizeof value);
        destination[i] = octets[octet % sizeof value];
    }
}
#endif

static uint8_t storePage(void* context, const void* page, uint16_t octets) {
    hb_htm* board = (hb_htm*)context;
    (void)octets;
    return board->store(board->store_context, (const hb_htm_calibration*)page);
}

static hb_xcp_hooks hooksOf(const hb_htm* board) {
    hb_xcp_hooks hooks;
    memset(&hooks, 0, sizeof hooks);
    hooks.check = checkParameter;
    hooks.written = parameterWritten;
    hooks.stop = stopByCommand;
    hooks.reset = resetByCommand;
#if HB_FEATURE_CAPTURE
    hooks.read_block = readCapture;
#endif
    hooks.store = board->store ? storePage : NULL;
    return hooks;
}

static void describe(hb_htm* board, const hb_htm_config* config, hb_xcp_description* description) {
    memset(description, 0, sizeof *description);
    description->model = "htm";
    description->device = config->device ? config->device : "htm";
    description->variant = config->variant;
#if HB_FEATURE_FULL
    description->transport_a2l = config->transport_a2l;
    description->max_dto = config->max_dto;
#endif
    description->signals[0].entries = hb_htm_signal_table;
    description->signals[0].count = hb_htm_signal_count;
    description->signals[0].base = &board->signals;
#if HB_FEATURE_FULL
    description->signals[1] = config->extra;
#endif
    description->parameters = hb_htm_parameter_table;
    description->parameter_count = hb_htm_parameter_count;
    description->events = hb_htm_event_table;
    description->event_count = HB_HTM_EVENT_COUNT;
    description->pages[0] = (uint8_t*)&board->pages[0];
    description->pages[1] = (uint8_t*)&board->pages[1];
    description->page_octets = sizeof board->pages[0];
    description->live = (uint8_t*)&board->live;
    description->live_octets = sizeof board->live;
#if HB_FEATURE_CAPTURE
    description->block_octets = HB_CAPTURE_SIGNALS * HB_CAPTURE_SAMPLES * sizeof(float);
#endif
    description->hooks = hooksOf(board);
    description->board = board;
}

static void loadPages(hb_htm* board, const hb_htm_calibration* stored) {
    if (stored) {
        board->pages[0] = *stored;
    }
    if (!stored || !hb_memory_page_is_valid(&board->xcp, 0)) {
        hb_parameters_reset(hb_htm_parameter_table, hb_htm_parameter_count, HB_PAGED, &board->pages[0]);
    }
    board->pages[1] = board->pages[0];
}

void hb_htm_init(hb_htm* board, const hb_htm_config* config) {
    const hb_htm_config defaults = {0};
    hb_xcp_description description;
    config = config ? config : &defaults;
    memset(board, 0, sizeof *board);
    board->store = config->store;
    board->store_context = config->store_context;
    describe(board, config, &description);
    hb_xcp_init(&board->xcp, &description);
    hb_parameters_reset(hb_htm_parameter_table, hb_htm_parameter_count, HB_LIVE, &board->live);
    loadPages(board, config->stored);
    hb_sensing_init(&board->sensing);
    hb_speed_init(&board->speed);
    hb_safety_init(&board->safety);
    hb_htm_enter_mode(board, HB_MODE_IDLE);
#if HB_FEATURE_CAPTURE
    hb_capture_init(&board->capture);
#endif
}

static void watch(hb_htm* board) {
    uint8_t somebody_counts_on_us = board->safety.armed || board->xcp.connected;
    if (hb_xcp_watchdog_expired(&board->xcp, somebody_counts_on_us ? board->live.watchdog_ms : 0)) {
        hb_htm_stop(board, HB_LATCH_WATCHDOG);
#if HB_FEATURE_TRIAL
        hb_htm_abandon_trial(board);
#endif
        hb_xcp_end_session(&board->xcp, HB_LATCH_WATCHDOG);
    }
}

static uint16_t dacCode(float current_A) {
    float code = current_A * DAC_CODES_PER_A + DAC_MIDDLE;
    if (code <= 0.0F) {
        return 0;
    }
    return (uint16_t)(code >= DAC_HIGHEST ? DAC_HIGHEST : code + 0.5F);
}

static void writeOutputs(hb_htm* board, hb_htm_outputs* outputs) {
    for (uint8_t i = 0; i < 2; i++) {
        outputs->phase_current_A[i] = board->signals.current_A[i];
        outputs->dac_code[i] = dacCode(board->signals.current_A[i]);
        board->flowing_A[i] = board->signals.current_A[i];
    }
    outputs->current_command_A = board->command_A;
    outputs->output_enabled = board->safety.armed && board->mode != HB_MODE_IDLE;
}

static void publish(hb_htm* board) {
    hb_htm_signals* signals = &board->signals;
    signals->current_command_A = board->command_A;
    for (uint8_t i = 0; i < 2; i++) {
        signals->hall_T[i] = board->sensing.field_T[i];
        signals->temperature_degC[i] = board->sensing.temperature_degC[i];
    }
    signals->status = hb_safety_status(&board->safety);
    signals->fault = board->safety.fault;
    signals->reference_segment = board->reference.segment;
    signals->reference_running = board->reference.running;
}

#if HB_FEATURE_CAPTURE

static float signalValue(const hb_htm* board, uint8_t handle) {
    const hb_signal_table* table = &board->xcp.description.signals[0];
    hb_signal signal;
    if (handle >= table->count) {
        handle = (uint8_t)(handle - table->count);
        table = &board->xcp.description.signals[1];
    }
    if (handle >= table->count) {
        return 0.0F;
    }
    hb_signal_read(&table->entries[handle], &signal);
    return hb_value_as_float(signal.entry.type, (const uint8_t*)table->base + signal.entry.offset) *
           signal.scale;
}

static void capture(hb_htm* board) {
    float values[HB_CAPTURE_SIGNALS];
    const hb_capture_config* config = &board->capture.config;
    if (!isCapturing(board)) {
        return;
    }
    for (uint8_t i = 0; i < HB_CAPTURE_SIGNALS; i++) {
        values[i] = signalValue(board, config->signal[i]);
    }
    hb_capture_tick(&board->capture, values, signalValue(board, config->trigger_signal),
                    board->reference_started, board->xcp.time_us);
    if (board->capture.state == HB_CAPTURE_FULL) {
        board->live.capture_start = 0;
    }
}

#endif

void hb_htm_fast_tick(hb_htm* board, const hb_htm_inputs* inputs, hb_htm_outputs* outputs) {
    const hb_htm_calibration* page = (const hb_htm_calibration*)hb_xcp_take_page(&board->xcp);
    board->signals.torn_count += page->set_first != page->set_last;
    board->xcp.time_us = board->tick * (1000U * HB_TICK_MS);
    watch(board);
    hb_htm_sense(board, page, inputs);
    hb_htm_supervise(board, page);
    hb_htm_control(board, page);
    hb_htm_commutate(board, page);
    writeOutputs(board, outputs);
    publish(board);
#if HB_FEATURE_CAPTURE
    capture(board);
    publishCapture(board);
#endif
    hb_xcp_event(&board->xcp, HB_HTM_EVENT_FAST);
    if (board->loop_phase == 0) {
        hb_xcp_event(&board->xcp, HB_HTM_EVENT_POSITION);
    }
    hb_reference_advance(&board->reference);
    board->live.reference_start = board->reference.running || board->reference_pending;
    board->loop_phase = (uint8_t)((board->loop_phase + 1U) % LOOP_TICKS);
    board->tick++;
}

/* Somebody else takes over: never armed after that, and his orders count anew. A master that leaves an armed
 * board leaves it to the watchdog, but what it was trying ends at once. */
static void endOfMaster(hb_htm* board, const uint8_t* packet, uint16_t length) {
    enum { CONNECT = 0xFF, DISCONNECT = 0xFE };
    uint8_t takes_over = length > 1 && packet[0] == CONNECT && packet[1] == 0;
    uint8_t leaves = length > 0 && packet[0] == DISCONNECT && board->xcp.connected;
    if (takes_over) {
        board->reference_order = 0;
#if HB_FEATURE_CAPTURE
        board->capture_order = 0;
#endif
        if (board->safety.armed) {
            hb_htm_release(board);
        }
    }
#if HB_FEATURE_TRIAL
    if (takes_over || leaves) {
        hb_htm_abandon_trial(board);
    }
#else
    (void)leaves;
#endif
}

void hb_htm_receive(hb_htm* board, const uint8_t* packet, uint16_t length) {
    HB_LOCK();
    endOfMaster(board, packet, length);
    HB_UNLOCK();
    hb_xcp_receive(&board->xcp, packet, length);
}

uint16_t hb_htm_transmit(hb_htm* board, uint8_t* packet, uint16_t capacity) {
    return hb_xcp_transmit(&board->xcp, packet, capacity);
}

uint16_t hb_htm_counter(const hb_htm* board) {
    return hb_xcp_counter(&board->xcp);
}
