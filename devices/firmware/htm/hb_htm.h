/* SPDX-License-Identifier: MIT */
#ifndef HB_HTM_H
#define HB_HTM_H

/* The controller board of the two-phase Halbach-cylinder motor. One struct is one board; it needs about 100
 * kB in the full build, so put it on the heap or in static storage of the caller, and do not copy or move it
 * once initialised (it holds pointers into itself).
 *
 * Timing (resources/help/htm-theory.md 3.8): tick k at t = k HB_TICK_MS samples, decodes, runs the position
 * loop every 10 ms, commutates and sets the outputs, which act immediately. The device clock is t. */

#include "devices/firmware/control/hb_capture.h"
#include "devices/firmware/control/hb_law.h"
#include "devices/firmware/control/hb_reference.h"
#include "devices/firmware/control/hb_safety.h"
#include "devices/firmware/control/hb_sensing.h"
#include "devices/firmware/control/hb_speed.h"
#include "devices/firmware/xcp/hb_xcp.h"

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

enum hb_mode { HB_MODE_IDLE, HB_MODE_CURRENT, HB_MODE_POSITION, HB_MODE_D_AXIS };

/* One calibration page. Units are those of the A2L; order is the order on the wire. */
typedef struct {
    uint32_t set_first; /* transaction marks: a cycle that sees them differ counts as torn */
    float kp, ki, kd;
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
    uint16_t watchdog_ms;
    uint8_t arm, mode, stop;
#if HB_FEATURE_TRIAL
    uint8_t trial;
#endif
    uint8_t reference_start;
    hb_reference_config reference;
    hb_plateau_config plateaus;
#if HB_FEATURE_CAPTURE
    hb_capture_config capture;
    uint8_t capture_start;
#endif
} hb_htm_live;

/* What can be measured. Position in counts of 2 pi/2^18 rad, wrapping after 8192 turns. */
typedef struct {
    int32_t position;
    float speed_rad_s;
    float reference; /* rad in mode position, A in the current modes */
    float current_command_A;
    float current_A[2];
    float hall_T[2];
    float temperature_degC[2];
    uint32_t torn_count;
    uint32_t capture_time_us;
    uint16_t reference_segment;
    uint8_t status, fault;
    uint8_t reference_running, capture_state;
} hb_htm_signals;

#define HB_HTM_COUNTS_PER_TURN 262144L

typedef struct {
    const char* device;  /* identity, e.g. "sim-htm-1"; NULL: "htm" */
    const char* variant; /* appended to the EPK; NULL: nothing */
#if HB_FEATURE_FULL
    const char* transport_a2l; /* A2L block of the line the board is served on; NULL: HB_A2L_TRANSPORT */
    uint16_t max_dto;          /* longest measurement packet that line carries; 0: HB_MAX_DTO */
    hb_signal_table extra;     /* further signals of the caller, e.g. the simulated truth; count 0: none */
#endif
    /* Stores a page in non-volatile memory: one of hb_store. NULL: SET_REQUEST is answered with an error. */
    uint8_t (*store)(void* context, const hb_htm_calibration* page);
    void* store_context;
    const hb_htm_calibration* stored; /* page to start with; NULL: the defaults (preset "published") */
} hb_htm_config;

typedef struct hb_htm {
    hb_xcp xcp;
    hb_htm_calibration pages[2];
#if HB_FEATURE_TRIAL
    hb_htm_calibration trial_page; /* what ran when the trial began */
#endif
    hb_htm_live live;
    hb_htm_signals signals;
    hb_sensing sensing;
    hb_speed speed;
    hb_law law;
    hb_reference reference;
    hb_safety safety;
#if HB_FEATURE_CAPTURE
    hb_capture capture;
#endif
    uint32_t tick; /* number of ticks done */
    int32_t origin_turns;
    float origin_angle_rad; /* where the rotor was when armed */
    float excursion_rad;    /* since arming, where this tick needs it */
    float command_A;        /* held between position-loop samples */
    uint8_t mode;           /* mode in force; a new one restarts the loop */
    float flowing_A[2];     /* written at the last tick: what the sensors see until this one */
    uint8_t loop_phase;     /* ticks since the position loop ran */
    uint8_t reference_pending, reference_started;
    uint8_t reference_order; /* number of the last start, so that its repetition is known */
#if HB_FEATURE_CAPTURE
    uint8_t capture_order;
#endif
    uint8_t (*store)(void* context, const hb_htm_calibration* page);
    void* store_context;
} hb_htm;

/* Cannot fail; a NULL config means all defaults. Set-points zero, disarmed, not connected. */
void hb_htm_init(hb_htm* board, const hb_htm_config* config);

/* Every HB_TICK_MS. A value that is not finite anywhere leads to a latched fault and zero outputs. */
void hb_htm_fast_tick(hb_htm* board, const hb_htm_inputs* inputs, hb_htm_outputs* outputs);

/* What only the board itself can notice, e.g. HB_FAULT_OUTPUT: latched like any fault, outputs at zero from
 * the next tick on. */
void hb_htm_raise_fault(hb_htm* board, uint8_t fault);

/* One XCP packet from the master; may be any octets. */
void hb_htm_receive(hb_htm* board, const uint8_t* packet, uint16_t length);

/* Next packet for the master, 0 if none; HB_MAX_DTO octets always suffice. */
uint16_t hb_htm_transmit(hb_htm* board, uint8_t* packet, uint16_t capacity);

/* Message counter of the packet taken last, for the transport's CTR field; a gap = samples dropped in the
 * board. */
uint16_t hb_htm_counter(const hb_htm* board);

#ifdef __cplusplus
}
#endif

#endif
