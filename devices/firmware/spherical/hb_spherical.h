/* SPDX-License-Identifier: MIT */
#ifndef HB_SPHERICAL_H
#define HB_SPHERICAL_H

/* The sensing board of the spherical motor: an actuator of hb_board without axes and without outputs. Every
 * millisecond it reads nine field channels, corrects them and finds the orientation of the rotor from them
 * alone; there is nothing to arm (resources/help/spherical-theory.md section 5.1).
 *
 * A channel at the end of its converter or not finite is left out; while the rest does not determine the
 * orientation the last one is held and said to be old. */

#include "devices/firmware/board/hb_board.h"
#include "devices/firmware/spherical/hb_orientation.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Converter as built. */
typedef struct {
    float field_T_per_code;
    float lowest_code, highest_code; /* ends of the range */
} hb_spherical_hardware;

/* Codes; fractions allowed (ideal chain). */
typedef struct {
    float field_code[HB_FIELD_CHANNELS];
    float coil_current_A;
    float temperature_degC;
} hb_spherical_inputs;

/* Integrity: added. */
enum hb_integrity {
    HB_INTEGRITY_CHANNEL_LEFT_OUT = 1,
    HB_INTEGRITY_HELD = 2,     /* no orientation: the last one is shown */
    HB_INTEGRITY_RESIDUAL = 4, /* chi-square above its limit: a fault, a stray field or a bad calibration */
    HB_INTEGRITY_STRENGTH = 8, /* q far from the calibrated one at this temperature */
    HB_INTEGRITY_UNTESTED = 16 /* five channels: nothing left to test them with */
};

/* One calibration page, all float but the marks; order is the order on the wire. */
typedef struct {
    uint32_t set_first;
    hb_field_sensors sensors;
    float frames; /* enum hb_sensor_frames */
    hb_rotor_field rotor;
    float drift_per_K, reference_degC;
    float strength_tolerance; /* share of q beyond which it is flagged */
    float chi_square_limit;
    float coil_compensation; /* 0 off, 1 on */
    uint32_t set_last;
} hb_spherical_calibration;

typedef struct {
    uint16_t channels_off; /* bit i: channel i is left out by command */
    hb_board_live board;
#if HB_FEATURE_CAPTURE
    hb_board_capture capture;
#endif
} hb_spherical_live;

typedef struct {
    float field_T[HB_FIELD_CHANNELS]; /* as read, not corrected */
    hb_orientation orientation;
    float expected_T; /* q by calibration and temperature */
    float coil_current_A, temperature_degC;
    uint16_t left_out; /* bit i: channel i is not used */
    uint8_t integrity;
    uint8_t is_fresh; /* the orientation is of this tick */
    hb_board_signals board;
} hb_spherical_signals;

typedef struct hb_spherical {
    hb_board board;
    hb_spherical_calibration pages[2];
#if HB_FEATURE_TRIAL
    hb_spherical_calibration trial_page;
#endif
    hb_spherical_live live;
    hb_spherical_signals signals;
    hb_spherical_hardware hardware;
    hb_tensor_system system;
    hb_field_sensors prepared; /* what the system was prepared for */
    float prepared_frames;
    uint8_t is_prepared;
} hb_spherical;

/* Cannot fail; a NULL config means all defaults, NULL hardware 12 bit of -0.3 ... +0.3 T. */
void hb_spherical_init(hb_spherical* spherical, const hb_spherical_hardware* hardware,
                       const hb_board_config* config);

/* Every HB_TICK_MS. */
void hb_spherical_tick(hb_spherical* spherical, const hb_spherical_inputs* inputs);

#ifdef __cplusplus
}
#endif

#endif
