/* SPDX-License-Identifier: MIT */
#include "devices/firmware/examples/minimal_board.h"

#include <math.h>
#include <string.h>

enum { DEFAULT_WATCHDOG_MS = 1000, MODE_POSITION = 2 };

static hb_rom_char StatusChoices[] = "idle|armed|stopped by command|stopped by watchdog|fault";
static hb_rom_char ModeChoices[] = "idle|current|position";

static const hb_signal Signals[] HB_ROM = {
    HB_SIGNAL("position", "rad", HB_FLOAT32, minimal_signals, position_rad, 1.0F, -7.0F, 7.0F, NULL, "Angle"),
    HB_SIGNAL("current_command", "A", HB_FLOAT32, minimal_signals, current_command_A, 1.0F, -2.0F, 2.0F, NULL,
              "Current commanded"),
    HB_SIGNAL("status", "", HB_UBYTE, minimal_signals, status, 1.0F, 0.0F, 4.0F, StatusChoices, "State"),
};

static const hb_parameter Parameters[] HB_ROM = {
    HB_PARAM(HB_PAGED, "set.first", "", HB_ULONG, minimal_calibration, set_first, 0.0F, 0.0F, 4294967296.0F,
             NULL, ""),
    HB_PARAM(HB_PAGED, "gain.kp", "A/rad", HB_FLOAT32, minimal_calibration, kp_A_per_rad, 1.0F, 0.0F, 50.0F,
             NULL, "Proportional gain"),
    HB_PARAM(HB_PAGED, "limit.current", "A", HB_FLOAT32, minimal_calibration, limit_A, 2.0F, 0.0F, 2.0F, NULL,
             "Largest current"),
    HB_PARAM(HB_PAGED, "set.last", "", HB_ULONG, minimal_calibration, set_last, 0.0F, 0.0F, 4294967296.0F,
             NULL, ""),
    HB_PARAM(HB_LIVE, "hb.arm", "", HB_UBYTE, minimal_live, arm, 0.0F, 0.0F, 1.0F, NULL, "Arm the output"),
    HB_PARAM(HB_LIVE, "hb.mode", "", HB_UBYTE, minimal_live, mode, 0.0F, 0.0F, 2.0F, ModeChoices, "Mode"),
    HB_PARAM(HB_LIVE, "hb.setpoint", "", HB_FLOAT32, minimal_live, setpoint, 0.0F, -7.0F, 7.0F, NULL,
             "A or rad"),
    HB_PARAM(HB_LIVE, "hb.watchdog_ms", "ms", HB_UWORD, minimal_live, watchdog_ms, 0.0F, 0.0F,
             HB_LONGEST_WATCHDOG_MS, NULL, "Silence of the host that stops"),
    HB_PARAM(HB_LIVE, "hb.stop", "", HB_UBYTE, minimal_live, stop, 0.0F, 0.0F, 1.0F, NULL, "Write 1 to stop"),
};

static const hb_event Events[] HB_ROM = {{"fast", 1, 6}};

enum {
    SIGNAL_COUNT = sizeof Signals / sizeof Signals[0],
    PARAMETER_COUNT = sizeof Parameters / sizeof Parameters[0]
};

static void release(minimal_board* board) {
    hb_safety_disarm(&board->safety);
    board->live.arm = 0;
    board->live.setpoint = 0.0F;
}

static uint16_t liveOffset(uint16_t parameter) {
    hb_parameter numbers;
    hb_parameter_read(&Parameters[parameter], &numbers);
    return numbers.space == HB_LIVE ? numbers.entry.offset : 0xFFFF;
}

static uint8_t check(void* context, uint16_t parameter, float value) {
    minimal_board* board = (minimal_board*)context;
    uint16_t offset = liveOffset(parameter);
    if (offset == offsetof(minimal_live, arm) && value > 0.5F && hb_safety_latch(&board->safety)) {
        return HB_ERR_ACCESS_DENIED;
    }
    if (offset == offsetof(minimal_live, watchdog_ms) && value < 0.5F && board->safety.armed) {
        return HB_ERR_OUT_OF_RANGE;
    }
    return HB_OK;
}

static uint8_t stop(void* context) {
    minimal_board* board = (minimal_board*)context;
    uint8_t latch = hb_safety_stop(&board->safety, HB_LATCH_COMMAND);
    release(board);
    return latch;
}

static uint8_t reset(void* context) {
    minimal_board* board = (minimal_board*)context;
    hb_safety_reset(&board->safety);
    board->live.stop = 0;
    return hb_safety_latch(&board->safety);
}

static void written(void* context, uint16_t parameter) {
    minimal_board* board = (minimal_board*)context;
    uint16_t offset = liveOffset(parameter);
    if (offset == offsetof(minimal_live, arm) && board->live.arm && !board->safety.armed) {
        hb_safety_arm(&board->safety);
        board->live.setpoint = 0.0F;
        board->live.watchdog_ms = board->live.watchdog_ms ? board->live.watchdog_ms : DEFAULT_WATCHDOG_MS;
    } else if (offset == offsetof(minimal_live, arm) && !board->live.arm) {
        release(board);
    } else if (offset == offsetof(minimal_live, stop) && board->live.stop) {
        stop(board);
    }
}

void minimal_board_init(minimal_board* board) {
    hb_xcp_description description;
    memset(board, 0, sizeof *board);
    memset(&description, 0, sizeof description);
    description.model = "minimal";
    description.device = "minimal-1";
    description.signals[0].entries = Signals;
    description.signals[0].count = SIGNAL_COUNT;
    description.signals[0].base = &board->signals;
    description.parameters = Parameters;
    description.parameter_count = PARAMETER_COUNT;
    description.events = Events;
    description.event_count = 1;
    description.pages[0] = (uint8_t*)&board->pages[0];
    description.pages[1] = (uint8_t*)&board->pages[1];
    description.page_octets = sizeof board->pages[0];
    description.live = (uint8_t*)&board->live;
    description.live_octets = sizeof board->live;
    description.hooks.check = check;
    description.hooks.written = written;
    description.hooks.stop = stop;
    description.hooks.reset = reset;
    description.board = board;
    hb_xcp_init(&board->xcp, &description);
    hb_parameters_reset(Parameters, PARAMETER_COUNT, HB_PAGED, &board->pages[0]);
    hb_parameters_reset(Parameters, PARAMETER_COUNT, HB_PAGED, &board->pages[1]);
    hb_parameters_reset(Parameters, PARAMETER_COUNT, HB_LIVE, &board->live);
}

static float clampTo(float value, float limit) {
    if (value > limit) {
        return limit;
    }
    return value < -limit ? -limit : value;
}

float minimal_board_tick(minimal_board* board, float position_rad) {
    const minimal_calibration* page = (const minimal_calibration*)hb_xcp_take_page(&board->xcp);
    uint8_t watched = board->safety.armed || board->xcp.connected;
    float demand = 0.0F;
    board->xcp.time_us = 1000U * board->tick++;
    if (hb_xcp_watchdog_expired(&board->xcp, watched ? board->live.watchdog_ms : 0)) {
        hb_safety_stop(&board->safety, HB_LATCH_WATCHDOG);
        release(board);
        hb_xcp_end_session(&board->xcp, HB_LATCH_WATCHDOG);
    }
    if (!isfinite(position_rad)) {
        hb_safety_fault(&board->safety, HB_FAULT_NOT_FINITE);
        release(board);
    }
    if (board->safety.armed && board->live.mode == MODE_POSITION) {
        demand = page->kp_A_per_rad * (board->live.setpoint - position_rad);
    } else if (board->safety.armed && board->live.mode != 0) {
        demand = board->live.setpoint;
    }
    board->signals.position_rad = position_rad;
    board->signals.current_command_A = clampTo(demand, page->limit_A);
    board->signals.status = hb_safety_status(&board->safety);
    hb_xcp_event(&board->xcp, 0);
    return board->signals.current_command_A;
}
