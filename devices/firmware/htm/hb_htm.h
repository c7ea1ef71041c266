/* SPDX-License-Identifier: MIT */
#ifndef HB_HTM_H
#define HB_HTM_H

/* The controller board of the two-phase Halbach-cylinder motor. One struct is one board; it needs about 100
 * kB in the full build, so put it on the heap or in static storage of the caller, and do not copy or move it
 * once initialised (it holds pointers into itself).
 *
 * Timing (resources/help/htm-theory.md 3.8): tick k at t = k HB_TICK_MS samples, decodes, runs the position
 * loop every 10 ms, commutates and sets the outputs, which act immediately. The device clock is t. */

#include "devices/firmware/board/hb_board.h"
#include "devices/firmware/control/hb_law.h"
#include "devices/firmware/control/hb_reference.h"
#include "devices/firmware/control/hb_sensing.h"
#include "devices/firmware/control/hb_speed.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    float hall_code[2];        /* 0..1023, volts = (code + 0.5) * 5/1024; fractions allowed (ideal chain) */
    float temperature_code[2]; /* same converter; 10 mV/degC, 750 mV at 25 degC */
} hb_htm_inputs;

typedef struct {
    uint16_t dac_code[2];     /* rounded: volts = code * 5/4096, current = 2 A/V * (volts - 2.5 V) */
    float phase_current_A[2]; /* the same, not rounded */
    float current_command_A;
    uint8_t output_enabled; /* 0: both phases at zero */
} hb_htm_outputs;

enum hb_htm_mode { HB_MODE_CURRENT = HB_MODE_IDLE + 1, HB_MODE_POSITION, HB_MODE_D_AXIS };

/* One calibration page. Units are those of the A2L; order is the order on the wire. */
typedef struct {
    uint32_t set_first; /* transaction marks: a cycle that sees them differ counts as torn */
    float kp, ki, kd;
#if HB_LAW_WEIGHTS
    float reference_weight, derivative_reference_weight, derivative_filter;
#endif
#if HB_LAW_SECTIONS > 0
    hb_law_section sections[HB_LAW_SECTIONS];
#endif
    float ff_inertia, ff_viscous, ff_coulomb, ff_coulomb_speed;
    float stiction_current, stiction_threshold, stiction_speed;
    float law;
    float limit_current, limit_temperature;
    float window_position, window_position_enabled, window_speed, window_speed_enabled;
    float stray_enabled, stray_coefficient;
    float decode_method, delay_samples;
    float commutation_divider, commutation_advance;
    float hall_offset_a, hall_offset_b, hall_gain_ratio, hall_quadrature, hall_amplitude;
#if HB_FEATURE_ERROR_MAP
    float errormap_enabled;
    float errormap_cosine[HB_ERROR_MAP_ORDERS], errormap_sine[HB_ERROR_MAP_ORDERS];
#endif
    uint32_t set_last;
} hb_htm_calibration;

/* Parameters that are not paged. */
typedef struct {
    float setpoint; /* A, or rad relative to the position at arming */
    hb_board_live board;
    hb_reference_config reference;
    hb_plateau_config plateaus;
#if HB_FEATURE_CAPTURE
    hb_board_capture capture;
#endif
} hb_htm_live;

/* What can be measured. Position in counts of 2 pi/2^18 rad, wrapping after 8192 turns. */
typedef struct {
    int32_t position;
    float speed_rad_s;
    float reference;         /* rad in mode position, A in the current modes */
    float current_command_A; /* held between samples of the position loop */
    float current_A[2];
    float hall_T[2];
    float temperature_degC[2];
    hb_board_signals board;
} hb_htm_signals;

#define HB_HTM_COUNTS_PER_TURN 262144L

typedef hb_board_config hb_htm_config;

typedef struct hb_htm {
    hb_board board;
    hb_htm_calibration pages[2];
#if HB_FEATURE_TRIAL
    hb_htm_calibration trial_page;
#endif
    hb_htm_live live;
    hb_htm_signals signals;
    hb_sensing sensing;
    hb_speed speed;
    hb_law law;
    hb_reference reference;
    int32_t origin_turns;
    float origin_angle_rad; /* where the rotor was when armed */
    float excursion_rad;    /* since arming, where this tick needs it */
    float flowing_A[2];     /* written at the last tick: what the sensors see until this one */
} hb_htm;

/* Cannot fail; a NULL config means all defaults. Set-points zero, disarmed, not connected. Everything else of
 * the board (faults, packets) is that of `board` in it. */
void hb_htm_init(hb_htm* motor, const hb_htm_config* config);

/* Every HB_TICK_MS. A value that is not finite anywhere leads to a latched fault and zero outputs. */
void hb_htm_fast_tick(hb_htm* motor, const hb_htm_inputs* inputs, hb_htm_outputs* outputs);

#ifdef __cplusplus
}
#endif

#endif
