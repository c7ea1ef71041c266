/* SPDX-License-Identifier: MIT */
#ifndef HB_BOARD_INTERNAL_H
#define HB_BOARD_INTERNAL_H

#include "devices/firmware/board/hb_board.h"

#ifdef __cplusplus
extern "C" {
#endif

/* hb_board_state.c: arming and its opposite. */
void hb_board_enter_mode(hb_board* board, uint8_t mode);
/* Of an armed board; idle brakes or clears the outputs. */
void hb_board_change_mode(hb_board* board, uint8_t mode);
void hb_board_arm(hb_board* board);
/* Every output and set-point to zero, or braking; what is latched stays latched. */
void hb_board_release(hb_board* board);
uint8_t hb_board_stop(hb_board* board, uint8_t latch);
#if HB_FEATURE_TRIAL
/* hb.trial = 1 keeps a copy of the calibration. When the master is lost before it wrote 0 again (watchdog,
 * disconnect, a new connection) the copy runs again, so that half-tried gains do not stay. */
void hb_board_begin_trial(hb_board* board);
void hb_board_abandon_trial(hb_board* board);
#endif

/* hb_board_orders.c: what the master writes and asks. */
hb_xcp_hooks hb_board_hooks(const hb_board* board);
#if HB_FEATURE_CAPTURE
/* One tick of a running capture. */
void hb_board_capture_tick(hb_board* board);
#endif

#ifdef __cplusplus
}
#endif

#endif
