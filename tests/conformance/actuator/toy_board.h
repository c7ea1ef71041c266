/* SPDX-License-Identifier: MIT */
#ifndef TOY_BOARD_H
#define TOY_BOARD_H

/* The board of the smallest actuator there is: a slide on one linear axis, pushed by two coils in quadrature.
 * Position x in m from the scale's zero, pitch 20 mm, force 5 N/A (i_a cos(2 pi x/pitch) + i_b sin(...)). */

#include "devices/firmware/board/hb_board.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TOY_PITCH_M 0.02F
#define TOY_FORCE_N_PER_A 5.0F

enum toy_mode { TOY_MODE_CURRENT = HB_MODE_IDLE + 1, TOY_MODE_POSITION };

typedef struct {
    uint32_t set_first;
    float kp_A_per_m, kd_As_per_m, limit_A, window_speed_m_s;
    uint32_t set_last;
} toy_calibration;

typedef struct {
    float setpoint; /* A, or m from where it was when the mode began */
    hb_board_live board;
    hb_board_capture capture;
} toy_live;

typedef struct {
    float position_m, speed_m_s, reference, command_A;
    float current_A[2];
    hb_board_signals board;
} toy_signals;

typedef struct {
    hb_board board;
    toy_calibration pages[2], trial_page;
    toy_live live;
    toy_signals signals;
    float origin_m;
} toy_board;

extern const hb_actuator toy_actuator;

/* `actuator`: toy_actuator, or one of the same tables and other hooks. */
void toy_board_init(toy_board* board, const hb_actuator* actuator, const hb_board_config* config);

#ifdef __cplusplus
}
#endif

#endif
