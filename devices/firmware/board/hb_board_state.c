/* SPDX-License-Identifier: MIT */
#include "devices/firmware/board/hb_board_internal.h"

#include <string.h>

enum { DEFAULT_WATCHDOG_MS = 1000 };

void hb_board_enter_mode(hb_board* board, uint8_t mode) {
    board->mode = mode;
    board->live->reference_start = 0;
    board->reference_pending = 0;
    hb_board_actuator(board)->enter_mode(board->context, mode);
}

void hb_board_arm(hb_board* board) {
    if (board->safety.armed || !hb_safety_arm(&board->safety)) {
        return;
    }
    if (board->live->watchdog_ms == 0) {
        board->live->watchdog_ms = DEFAULT_WATCHDOG_MS;
    }
#if HB_FEATURE_BRAKE
    board->brake_ticks = 0;
#endif
    hb_board_enter_mode(board, board->live->mode);
}

static void clearOutputs(hb_board* board) {
#if HB_FEATURE_BRAKE
    board->brake_ticks = 0;
#endif
    memset(board->outputs, 0, hb_board_actuator(board)->output_count * sizeof(float));
}

/* `was_driving`: outputs may be other than zero, an actuator that glides has to brake. */
static void brakeOrClear(hb_board* board, uint8_t was_driving) {
#if HB_FEATURE_BRAKE
    if (was_driving && hb_board_actuator(board)->brake) {
        board->brake_ticks = (uint16_t)(hb_board_actuator(board)->brake_ms / HB_TICK_MS);
    }
    if (board->brake_ticks == 0) {
        clearOutputs(board);
    }
#else
    (void)was_driving;
    clearOutputs(board);
#endif
}

static void endDriving(hb_board* board, uint8_t was_driving) {
    brakeOrClear(board, was_driving);
    hb_board_enter_mode(board, HB_MODE_IDLE);
    board->live->arm = 0;
}

static uint8_t isArmedInAMode(const hb_board* board) {
    return board->safety.armed && board->mode != HB_MODE_IDLE;
}

void hb_board_change_mode(hb_board* board, uint8_t mode) {
    if (mode == HB_MODE_IDLE) {
        brakeOrClear(board, isArmedInAMode(board));
    }
#if HB_FEATURE_BRAKE
    else {
        board->brake_ticks = 0;
    }
#endif
    hb_board_enter_mode(board, mode);
}

void hb_board_release(hb_board* board) {
    uint8_t was_driving = isArmedInAMode(board);
    hb_safety_disarm(&board->safety);
    endDriving(board, was_driving);
}

uint8_t hb_board_stop(hb_board* board, uint8_t latch) {
    uint8_t was_driving = isArmedInAMode(board);
    uint8_t code = hb_safety_stop(&board->safety, latch);
    endDriving(board, was_driving);
    board->live->stop = board->safety.stop == HB_LATCH_COMMAND;
    return code;
}

/* The text of a fault: HB_ROM text up to its end or to '|'. */
static hb_rom_char* faultText(const hb_board* board, uint8_t fault) {
    hb_rom_char* text = hb_board_actuator(board)->faults;
    for (; fault > 0 && *text; text++) {
        fault = (uint8_t)(fault - (*text == '|'));
    }
    return text;
}

void hb_board_raise_fault(hb_board* board, uint8_t fault) {
    uint8_t is_first = board->safety.fault == HB_FAULT_NONE;
    uint8_t was_driving = isArmedInAMode(board);
    hb_safety_fault(&board->safety, fault);
    endDriving(board, was_driving);
#if HB_FEATURE_BRAKE
    if (((hb_board_actuator(board)->braking_faults >> fault) & 1U) == 0) {
        clearOutputs(board);
    }
#endif
    if (is_first) {
        hb_xcp_report_user_event(&board->xcp, fault, faultText(board, fault));
    }
}

uint8_t hb_board_take_start(hb_board* board) {
    uint8_t is_pending = board->reference_pending;
    board->reference_pending = 0;
    board->reference_started |= is_pending;
    return is_pending;
}

#if HB_FEATURE_TRIAL

void hb_board_begin_trial(hb_board* board) {
    memcpy(board->trial_page, board->xcp.description.pages[board->xcp.next_page],
           hb_board_actuator(board)->page_octets);
}

void hb_board_abandon_trial(hb_board* board) {
    /* The page the loop does not use in this cycle is free, also while a switch to it is ordered. */
    uint8_t idle = 1U - board->xcp.active_page;
    if (!board->live->trial) {
        return;
    }
    board->live->trial = 0;
    memcpy(board->xcp.description.pages[idle], board->trial_page, hb_board_actuator(board)->page_octets);
    board->xcp.next_page = idle;
    board->xcp.xcp_page = idle;
}

#endif
