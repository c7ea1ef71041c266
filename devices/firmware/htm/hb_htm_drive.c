/* SPDX-License-Identifier: MIT */
#include "devices/firmware/control/hb_constants.h"
#include "devices/firmware/htm/hb_htm_internal.h"

enum { DEFAULT_WATCHDOG_MS = 1000 };

float hb_htm_excursion(const hb_htm* board) {
    return (float)(board->sensing.turns - board->origin_turns) * HB_TWO_PI +
           (board->sensing.angle_rad - board->origin_angle_rad);
}

void hb_htm_enter_mode(hb_htm* board, uint8_t mode) {
    board->mode = mode;
    board->origin_turns = board->sensing.turns;
    board->origin_angle_rad = board->sensing.angle_rad;
    board->command_A = 0.0F;
    board->live.setpoint = 0.0F;
    board->live.reference_start = 0;
    board->reference_pending = 0;
    hb_law_reset(&board->law);
    hb_reference_clear(&board->reference);
}

void hb_htm_arm(hb_htm* board) {
    if (board->safety.armed || !hb_safety_arm(&board->safety)) {
        return;
    }
    if (board->live.watchdog_ms == 0) {
        board->live.watchdog_ms = DEFAULT_WATCHDOG_MS;
    }
    hb_htm_enter_mode(board, board->live.mode);
}

void hb_htm_release(hb_htm* board) {
    hb_safety_disarm(&board->safety);
    hb_htm_enter_mode(board, HB_MODE_IDLE);
    board->live.arm = 0;
    board->signals.current_A[0] = 0.0F;
    board->signals.current_A[1] = 0.0F;
}

void hb_htm_raise_fault(hb_htm* board, uint8_t fault) {
    uint8_t is_first = board->safety.fault == HB_FAULT_NONE;
    hb_safety_fault(&board->safety, fault);
    hb_htm_release(board);
    if (is_first) {
        hb_xcp_report_user_event(&board->xcp, fault, hb_htm_fault_text(fault));
    }
}

uint8_t hb_htm_stop(hb_htm* board, uint8_t latch) {
    uint8_t code = hb_safety_stop(&board->safety, latch);
    hb_htm_release(board);
    board->live.stop = board->safety.stop == HB_LATCH_COMMAND;
    return code;
}

#if HB_FEATURE_TRIAL

void hb_htm_begin_trial(hb_htm* board) {
    board->trial_page = board->pages[board->xcp.next_page];
}

void hb_htm_abandon_trial(hb_htm* board) {
    /* The page the loop does not use in this cycle is free, also while a switch to it is ordered. */
    uint8_t idle = 1U - board->xcp.active_page;
    if (!board->live.trial) {
        return;
    }
    board->live.trial = 0;
    board->pages[idle] = board->trial_page;
    board->xcp.next_page = idle;
    board->xcp.xcp_page = idle;
}

#endif
