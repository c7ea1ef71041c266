/* SPDX-License-Identifier: MIT */
#ifndef HB_PLANAR_H
#define HB_PLANAR_H

/* The controller board of the planar six-coil positioner: an actuator of hb_board with three axes.
 *
 * Timing (resources/help/planar-theory.md section 8): tick k at t = k ms samples the chips, finds the pose,
 * runs the law and computes six currents, which go out `delay.samples` ticks later and are held.
 *
 * A platen on air without current glides on. So whatever ends the driving (stop, watchdog, a limit, disarm)
 * brakes first, with the current limit, until the platen rests, 0.3 s at most. With a chip that is left out
 * or readings that give no pose, the currents are zero at once. */

#include "devices/firmware/board/hb_board.h"
#include "devices/firmware/control/hb_law.h"
#include "devices/firmware/control/hb_reference.h"
#include "devices/firmware/planar/hb_planar_path.h"
#include "devices/firmware/planar/hb_planar_pieces.h"
#include "devices/firmware/planar/hb_planar_profile.h"
#include "devices/firmware/planar/hb_planar_tracker.h"
#include "devices/firmware/planar/hb_planar_windings.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { HB_AXES = 3, HB_PLANAR_DELAY = 2 };

/* Converters and amplifiers as built. */
typedef struct {
    float adc_V_per_code, adc_lowest_V; /* volts = (code + 1/2) V_per_code + lowest */
    float adc_last_code;
    float field_V_per_T;
    float dac_codes_per_A, dac_zero_code;
} hb_planar_hardware;

/* Codes; fractions allowed (ideal chain). */
typedef struct {
    float field_code[HB_CHIP_FIELDS];
    float temperature_code[HB_COILS]; /* 10 mV/degC, 750 mV at 25 degC */
} hb_planar_inputs;

typedef struct {
    float dac_code[HB_COILS]; /* not rounded */
} hb_planar_outputs;

enum hb_planar_mode {
    HB_PLANAR_CURRENTS = HB_MODE_IDLE + 1, /* set-points are the six coil currents */
    HB_PLANAR_POSITION,                    /* m and rad from the pose where the mode began */
    HB_PLANAR_WRENCH                       /* N, N, N m about the origin of the platen frame */
};

/* Wrench to currents: by the published model, or by the windings with the heading and one or all harmonics.
 */
enum hb_planar_allocation { HB_ALLOCATION_SET_WISE, HB_ALLOCATION_FUNDAMENTAL, HB_ALLOCATION_FULL };

/* Shapes of the reference beyond those of hb_reference: `amplitude` is the distance, `rate` the largest
 * speed, with `reference.<axis>.acceleration` and, of the S-curve, `.jerk`; in mode position only. The last
 * one is of an axis that follows `path`, and no value of a parameter. */
enum { HB_PLANAR_TRAPEZOID = HB_SHAPE_COUNT, HB_PLANAR_S_CURVE, HB_PLANAR_ON_PATH };

/* In mode position the reference of an axis goes where the law follows it, or is added to the force or torque
 * that the law commands: an excitation of the closed loop. Trapezoid and S-curve add nothing. */
enum hb_planar_target { HB_TARGET_POSITION, HB_TARGET_EFFORT };

enum hb_planar_fault {
    HB_PLANAR_FAULT_LIFT = HB_FAULT_COUNT, /* vertical force near the weight */
    HB_PLANAR_FAULT_COUNT
};

/* What the position law (hb_law.h) has of one axis; effort in N or N m, position in m or rad. Defaults: the
 * design of resources/help/planar-theory.md section 9, whose filter of 2 ms decays by exp(-1/2) in a sample.
 */
typedef struct {
    float kp, ki, kd;
    float reference_weight, derivative_reference_weight, derivative_filter_s;
    hb_law_section sections[HB_LAW_SECTIONS];
    float inertia; /* effort per acceleration of a profile */
} hb_planar_gains;

/* One calibration page, all float but the marks; order is the order on the wire. */
typedef struct {
    uint32_t set_first;
    hb_planar_gains gains[HB_AXES];
    float mass_kg, inertia_kg_m2;
    float centre_x_m, centre_y_m; /* centre of mass in platen axes */
    hb_planar_coils coils;
    float allocation; /* HB_ALLOCATION_... */
    float estimator;  /* 0: least squares and filtered difference, 1: tracking filter */
    float speed_filter_s;
    float limit_current_A, limit_temperature_degC, limit_lift_N;
    float window_position[HB_AXES], window_position_enabled;
    float window_speed_m_s, window_speed_rad_s, window_speed_enabled;
    float delay_samples;
    hb_chips chips;
    uint32_t set_last;
} hb_planar_calibration;

typedef struct {
    float setpoint[HB_AXES];
    float current_A[HB_COILS];
    hb_board_live board;
    uint8_t home;
    hb_reference_config reference[HB_AXES];
    float acceleration[HB_AXES]; /* of trapezoid and S-curve */
    float jerk[HB_AXES];         /* of the S-curve */
    uint8_t target[HB_AXES];     /* HB_TARGET_... */
    hb_path_config path;         /* where it has a shape, x and y follow it instead of their references */
    hb_piece piece;              /* stored as number `piece_number` when that is written */
    uint16_t piece_number;
    uint16_t piece_count; /* that HB_PATH_TABLE follows */
    hb_board_capture capture;
} hb_planar_live;

typedef struct {
    float position[HB_AXES]; /* m, m, rad */
    float speed[HB_AXES];
    float reference[HB_AXES]; /* N, N m in mode wrench */
    float command[HB_AXES];   /* of law and excitation, about the centre of mass, before limit and delay */
    float effort[HB_AXES];    /* wrench of the currents that flow, by the board's own model */
    float current_A[HB_COILS];
    float field_T[HB_CHIP_FIELDS]; /* as read, not corrected */
    float temperature_degC[HB_COILS];
    float chi_square, innovation_square, current_scale, lift_N;
    int16_t cell[2];  /* pitches from the start */
    uint8_t left_out; /* bit j: chip j + 1 is not used */
    uint8_t homed;
    hb_board_signals board;
} hb_planar_signals;

typedef struct hb_planar {
    hb_board board;
    hb_planar_calibration pages[2];
#if HB_FEATURE_TRIAL
    hb_planar_calibration trial_page;
#endif
    hb_planar_live live;
    hb_planar_signals signals;
    hb_planar_hardware hardware;
    hb_tracker tracker;
    hb_reference reference[HB_AXES];
    hb_reference excitation[HB_AXES]; /* beside a reference that is held */
    hb_profile profile[HB_AXES];
    hb_path path;
    hb_pieces pieces;
    hb_law law[HB_AXES];
    float origin[HB_AXES];     /* pose where the mode began */
    float flowing_A[HB_COILS]; /* what the chips see until this tick */
    float pending_A[HB_PLANAR_DELAY][HB_COILS];
    float demand_A[HB_COILS];
    uint8_t has_pose;
    uint8_t rest_ticks; /* of the braking, one after the other with little speed */
} hb_planar;

/* Cannot fail; a NULL config means all defaults, NULL hardware the published one: 16 bit of -5 ... +5 V both
 * ways, 200 V/T, 0.506 A/V. */
void hb_planar_init(hb_planar* planar, const hb_planar_hardware* hardware, const hb_board_config* config);

/* Every HB_TICK_MS. */
void hb_planar_tick(hb_planar* planar, const hb_planar_inputs* inputs, hb_planar_outputs* outputs);

#ifdef __cplusplus
}
#endif

#endif
