/* SPDX-License-Identifier: MIT */
#ifndef HB_AXES_H
#define HB_AXES_H

/* The controller board of an actuator whose axes have a position sensor and a drive each: an actuator of
 * hb_board that brings its tables and, where an effort is not an output of the same number, its own `drive`.
 *
 * Each axis has the position law (hb_law.h), a reference and, beside it, an excitation that is added to the
 * effort (hb_reference.h). Positions and efforts are in the units that the tables say; positions are read
 * once a tick, the speed is their difference over the tick. */

#include "devices/firmware/board/hb_board.h"
#include "devices/firmware/control/hb_law.h"
#include "devices/firmware/control/hb_reference.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { HB_AXES_MOST = 3 };

enum hb_axes_mode {
    HB_AXES_EFFORT = HB_MODE_IDLE + 1, /* set-points and references are efforts */
    HB_AXES_POSITION                   /* positions, from where the mode began */
};

/* In mode position: the reference goes to the law, or is added to the effort that the law commands. */
enum hb_axes_target { HB_AXES_TO_POSITION, HB_AXES_TO_EFFORT };

/* Of one axis, in the calibration. */
typedef struct {
    float kp, ki, kd; /* effort per position, per its integral, per speed */
#if HB_LAW_WEIGHTS
    float reference_weight, derivative_reference_weight, derivative_filter_s;
#endif
    float limit; /* largest effort */
    float window_position,
        window_speed; /* from where the mode began, and of either sign: beyond is a fault */
} hb_axis_settings;

typedef struct {
    float setpoint;
    hb_reference_config reference;
    uint8_t target; /* HB_AXES_TO_... */
} hb_axis_live;

typedef struct {
    float position, speed;
    float reference; /* effort in mode effort */
    float command;   /* effort within the limit */
} hb_axis_signals;

typedef struct {
    uint32_t set_first;
    hb_axis_settings axis[HB_AXES_MOST];
    uint32_t set_last;
} hb_axes_calibration;

typedef struct {
    hb_axis_live axis[HB_AXES_MOST];
    hb_board_live board;
    hb_board_capture capture;
} hb_axes_live;

typedef struct {
    hb_axis_signals axis[HB_AXES_MOST];
    float output[HB_AXES_MOST];
    hb_board_signals board;
} hb_axes_signals;

typedef struct {
    hb_law law;
    hb_reference reference, excitation;
    float origin; /* position where the mode began */
} hb_axis;

typedef struct {
    hb_board board;
    hb_axes_calibration pages[2], trial_page;
    hb_axes_live live;
    hb_axes_signals signals;
    hb_axis axis[HB_AXES_MOST];
} hb_axes;

/* Cannot fail; a NULL config means all defaults. `actuator` has HB_AXES_HOOKS and at most HB_AXES_MOST axes.
 */
void hb_axes_init(hb_axes* axes, const HB_FLASH hb_actuator* actuator, const hb_board_config* config);

/* Hooks of hb_actuator; `axes` is the hb_axes. `inputs`: HB_AXES_MOST floats, the positions; those of axes
 * that the actuator does not have are zero. A position that is not finite is a fault. A device that only
 * senses (axis_count 0) reads them all and drives none. */
void hb_axes_sense(void* axes, const void* page, const void* inputs);
void hb_axes_supervise(void* axes, const void* page);
void hb_axes_control(void* axes, const void* page);
/* The effort of axis i becomes output i. */
void hb_axes_drive(void* axes, const void* page);
void hb_axes_enter_mode(void* axes, uint8_t mode);
uint8_t hb_axes_check(void* axes, uint16_t offset, float value);
void hb_axes_stop_reference(void* axes);
uint8_t hb_axes_advance(void* axes);

#ifdef __cplusplus
}
#endif

#endif
