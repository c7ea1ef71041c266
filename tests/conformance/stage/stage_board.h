/* SPDX-License-Identifier: MIT */
#ifndef STAGE_BOARD_H
#define STAGE_BOARD_H

/* The board of a stage with two linear axes a and b, one voice coil each, 5 N/A. Positions in m. Both run the
 * one position law (hb_law.h) with force in N as their effort. */

#include "devices/firmware/board/hb_board.h"
#include "devices/firmware/control/hb_law.h"
#include "devices/firmware/control/hb_reference.h"

#ifdef __cplusplus
extern "C" {
#endif

#define STAGE_FORCE_N_PER_A 5.0F
enum { STAGE_AXES = 2 };
enum stage_mode { STAGE_MODE_FORCE = HB_MODE_IDLE + 1, STAGE_MODE_POSITION };

typedef struct {
    float kp, ki, kd, reference_weight, derivative_filter_s, inertia;
} stage_gains;

typedef struct {
    uint32_t set_first;
    stage_gains gains[STAGE_AXES];
    float limit_A, delay_samples, window_m[STAGE_AXES], window_position_enabled, window_speed_m_s,
        window_speed_enabled;
    uint32_t set_last;
} stage_calibration;

typedef struct {
    float setpoint[STAGE_AXES];
    hb_board_live board;
    hb_reference_config reference[STAGE_AXES];
    hb_board_capture capture;
} stage_live;

typedef struct {
    float position[STAGE_AXES], speed[STAGE_AXES], reference[STAGE_AXES], effort[STAGE_AXES];
    float current_A[STAGE_AXES];
    hb_board_signals board;
} stage_signals;

typedef struct {
    hb_board board;
    stage_calibration pages[2], trial_page;
    stage_live live;
    stage_signals signals;
    hb_reference reference[STAGE_AXES];
    hb_law law[STAGE_AXES];
    float origin[STAGE_AXES];
} stage_board;

void stage_board_init(stage_board* stage, const hb_board_config* config);

#ifdef __cplusplus
}
#endif

#endif
