/* SPDX-License-Identifier: MIT */
#include "devices/firmware/board/hb_board_internal.h"

#include <string.h>

/* A further parameter of the caller's, which nothing on the board depends on. */
static uint8_t isForeign(const hb_board* board, uint16_t parameter) {
#if HB_FEATURE_FULL
    return parameter >= board->xcp.description.parameter_count;
#else
    (void)board;
    (void)parameter;
    return 0;
#endif
}

/* Offset of a live parameter, HB_NO_LIVE for one that is paged. */
static uint16_t liveOffset(const hb_board* board, uint16_t parameter) {
    hb_parameter numbers;
    hb_parameter_read(&hb_board_actuator(board)->parameters[parameter], &numbers);
    return numbers.space == HB_LIVE ? numbers.entry.offset : (uint16_t)HB_NO_LIVE;
}

/* The same from the start of hb_board_live; what lies before it is beyond its end, too. */
static uint16_t boardOffset(const hb_board* board, uint16_t live_offset) {
    return live_offset == HB_NO_LIVE ? live_offset
                                     : (uint16_t)(live_offset - hb_board_actuator(board)->live_offset);
}

/* What holds for every actuator beyond the limits in the tables. */
static uint8_t checkParameter(void* context, uint16_t parameter, float value) {
    const hb_board* board = (const hb_board*)context;
    uint16_t live;
    uint16_t offset;
    if (isForeign(board, parameter)) {
        return HB_OK;
    }
    live = liveOffset(board, parameter);
    offset = boardOffset(board, live);
    if (offset == offsetof(hb_board_live, arm) && value > 0.5F && hb_safety_latch(&board->safety)) {
        return HB_ERR_ACCESS_DENIED;
    }
    if (offset == offsetof(hb_board_live, reference_start) && value > 0.5F && !board->safety.armed) {
        return HB_ERR_ACCESS_DENIED;
    }
    if (offset == offsetof(hb_board_live, arm) && value > 0.5F && board->tick == 0) {
        return HB_ERR_BUSY; /* the state to start from is not known before the first tick */
    }
    if (offset == offsetof(hb_board_live, watchdog_ms) && value < 0.5F && board->safety.armed) {
        return HB_ERR_OUT_OF_RANGE; /* the motion of a master that is gone would not end */
    }
    return hb_board_actuator(board)->check(board->context, live, value);
}

/* 1 starts every time; another number starts once, so that a master that got no answer may repeat it
 * (resources/help/protocol.md 3.15). */
static uint8_t isNewOrder(uint8_t* last, uint8_t order) {
    uint8_t is_new = order == 1U || order != *last;
    *last = order;
    return is_new;
}

static void startOrStopReference(hb_board* board) {
    uint8_t order = board->live->reference_start;
    if (order == 0) {
        board->reference_pending = 0;
        hb_board_actuator(board)->stop_reference(board->context);
    } else if (isNewOrder(&board->reference_order, order)) {
        board->reference_pending = 1;
    }
}

#if HB_FEATURE_CAPTURE

static uint16_t captureStartOffset(const hb_board* board) {
    return (uint16_t)(hb_board_actuator(board)->capture_offset + offsetof(hb_board_capture, start));
}

static hb_board_capture* captureOrder(hb_board* board) {
    void* order = board->xcp.description.live + hb_board_actuator(board)->capture_offset;
    return (hb_board_capture*)order;
}

static uint8_t isCapturing(const hb_board* board) {
    return board->capture.state != HB_CAPTURE_IDLE && board->capture.state != HB_CAPTURE_FULL;
}

static void publishCapture(hb_board* board) {
    board->signals->capture_state = board->capture.state;
    board->signals->capture_time_us = board->capture.trigger_time_us;
}

static void startOrStopCapture(hb_board* board) {
    hb_board_capture* order = captureOrder(board);
    if (order->start == 0) {
        hb_capture_stop(&board->capture);
    } else if (isNewOrder(&board->capture_order, order->start)) {
        hb_capture_start(&board->capture, &order->config);
    }
    order->start = isCapturing(board);
    publishCapture(board); /* a question before the next tick is about this capture */
}

static float signalValue(const hb_board* board, uint8_t handle) {
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

/* Published after the tick's sample, so that a full capture shows at once. */
void hb_board_capture_tick(hb_board* board) {
    float values[HB_CAPTURE_SIGNALS];
    const hb_capture_config* config = &board->capture.config;
    if (isCapturing(board)) {
        for (uint8_t i = 0; i < HB_CAPTURE_SIGNALS; i++) {
            values[i] = signalValue(board, config->signal[i]);
        }
        hb_capture_tick(&board->capture, values, signalValue(board, config->trigger_signal),
                        board->reference_started, board->xcp.time_us);
        if (board->capture.state == HB_CAPTURE_FULL) {
            captureOrder(board)->start = 0;
        }
    }
    publishCapture(board);
}

static void readCapture(void* context, hb_address offset, uint8_t* destination, uint16_t count) {
    const hb_board* board = (const hb_board*)context;
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

/* Live parameters act here, in the receive path; paged ones at the next control cycle. */
static void parameterWritten(void* context, uint16_t parameter) {
    hb_board* board = (hb_board*)context;
    uint16_t live;
    uint16_t offset;
    if (isForeign(board, parameter)) {
        return;
    }
    live = liveOffset(board, parameter);
    offset = boardOffset(board, live);
    if (offset == offsetof(hb_board_live, arm)) {
        if (board->live->arm) {
            hb_board_arm(board);
        } else {
            hb_board_release(board);
        }
    } else if (offset == offsetof(hb_board_live, mode)) {
        if (board->safety.armed && board->live->mode != board->mode) {
            hb_board_change_mode(board, board->live->mode);
        }
    } else if (offset == offsetof(hb_board_live, stop)) {
        if (board->live->stop) {
            hb_board_stop(board, HB_LATCH_COMMAND);
        }
        board->live->stop = board->safety.stop == HB_LATCH_COMMAND; /* only the reset command clears it */
    } else if (offset == offsetof(hb_board_live, reference_start)) {
        startOrStopReference(board);
    }
#if HB_FEATURE_TRIAL
    else if (offset == offsetof(hb_board_live, trial)) {
        if (board->live->trial) {
            hb_board_begin_trial(board);
        }
    }
#endif
#if HB_FEATURE_CAPTURE
    else if (live == captureStartOffset(board)) {
        startOrStopCapture(board);
    }
#endif
    else if (live != HB_NO_LIVE && hb_board_actuator(board)->written) {
        hb_board_actuator(board)->written(board->context, live);
    }
}

static uint8_t stopByCommand(void* context) {
    return hb_board_stop((hb_board*)context, HB_LATCH_COMMAND);
}

static uint8_t resetByCommand(void* context) {
    hb_board* board = (hb_board*)context;
    hb_safety_reset(&board->safety);
    board->live->stop = 0;
    return hb_safety_latch(&board->safety);
}

static uint8_t storePage(void* context, const void* page, uint16_t octets) {
    hb_board* board = (hb_board*)context;
    (void)octets;
    return board->store(board->store_context, page);
}

hb_xcp_hooks hb_board_hooks(const hb_board* board) {
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
