/* SPDX-License-Identifier: MIT */
#ifndef HB_MINIMAL_BOARD_H
#define HB_MINIMAL_BOARD_H

/* The smallest complete board: one actuator of the author's own, one sensor, a proportional loop. It is the
 * example of resources/help/firmware-guide.md, compiled and driven by
 * tests/devices/firmware/minimal_board_test.cpp. */

#include "devices/firmware/control/hb_safety.h"
#include "devices/firmware/xcp/hb_xcp.h"

#ifdef __cplusplus
extern "C" {
#endif

/* 1. What can be measured. */
typedef struct {
    float position_rad;
    float current_command_A;
    uint8_t status;
} minimal_signals;

/* 2. What can be tuned as a set; lies twice in RAM. */
typedef struct {
    uint32_t set_first;
    float kp_A_per_rad;
    float limit_A;
    uint32_t set_last;
} minimal_calibration;

/* 3. What acts at once; these five names exist on every board. */
typedef struct {
    float setpoint;
    uint16_t watchdog_ms;
    uint8_t arm, mode, stop;
} minimal_live;

typedef struct {
    hb_xcp xcp;
    minimal_calibration pages[2];
    minimal_live live;
    minimal_signals signals;
    hb_safety safety;
    uint32_t tick;
} minimal_board;

void minimal_board_init(minimal_board* board);
/* Every millisecond: the measured position in, the current to drive out. */
float minimal_board_tick(minimal_board* board, float position_rad);

#ifdef __cplusplus
}
#endif

#endif
