/* SPDX-License-Identifier: MIT */
#ifndef HB_REFERENCE_H
#define HB_REFERENCE_H

/* Reference generator of the board. r(t) from its start at t = 0, in rad (mode position) or A (modes current,
 * d-axis):
 *
 *   none        0
 *   step        amplitude
 *   ramp        rate t, held at |amplitude| when that is not 0
 *   sine        amplitude sin(2 pi frequency t)
 *   staircase   amplitude (1 + floor(t/period)), `count` steps
 *   chirp       amplitude sin(2 pi (f0 t + (f1 - f0) t^2/(2 duration)))
 *   multisine   amplitude sqrt(1/count) sum_k sin(2 pi f_k t + phase_k), f_k evenly from f0 to f1: the rms
 * value of a sine of this amplitude. Schroeder phases -pi k (k-1)/count for seed 0, else drawn from the seed
 *   plateaus    current[floor(t/dwell)], `count` of them
 *
 * `base` adds constant motion: base t in mode position (rad/s), the constant base in the current modes (A).
 * The generator ends after `duration` (staircase: count periods; plateaus: count dwells) or when stopped: a
 * position is then held, a current goes to zero. A position is also where the next start begins: r(t) counts
 * from it, so that nothing leaps back to where the mode was entered. */

#include "devices/firmware/xcp/hb_config.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hb_shape {
    HB_SHAPE_NONE,
    HB_SHAPE_STEP,
    HB_SHAPE_RAMP,
    HB_SHAPE_SINE,
    HB_SHAPE_STAIRCASE,
    HB_SHAPE_CHIRP, /* these two not in every build */
    HB_SHAPE_MULTISINE,
    HB_SHAPE_PLATEAUS,
    HB_SHAPE_COUNT
};

#if HB_FEATURE_GENERATOR
enum { HB_MULTISINE_LINES = 32 };
#endif

/* Part of the live parameters; start() copies it, so writes act on the next start only. */
typedef struct {
    float amplitude, rate, frequency_Hz, frequency_end_Hz, period_s, duration_s, base;
    uint32_t seed;
    uint16_t count;
    uint8_t shape;
} hb_reference_config;

typedef struct {
    float current_A[HB_PLATEAUS];
    float dwell_s;
    uint16_t count;
} hb_plateau_config;

#if HB_FEATURE_GENERATOR
typedef uint64_t hb_phase;
#else
typedef uint32_t hb_phase;
#endif

typedef struct {
    float value, speed, acceleration;
} hb_reference_point;

typedef struct {
    hb_reference_config config;
#if HB_FEATURE_GENERATOR
    hb_plateau_config plateaus;
    hb_phase line_phase[HB_MULTISINE_LINES]; /* as `phase` */
#else
    const hb_plateau_config* plateaus; /* RAM for a copy is not there: writes act at once */
#endif
    uint32_t ticks; /* control ticks since the start */
    uint32_t duration_ticks;
    hb_phase phase; /* of sine and chirp */
    hb_reference_point held;
    float from;       /* rad, what a position counts from */
    uint16_t segment; /* 1, 2, ... counts steps and plateaus while running, else 0 */
    uint8_t running, holds_position;
} hb_reference;

/* t = 0 is the next hb_reference_evaluate(), with segment 1; also when it is running already. */
void hb_reference_start(hb_reference* reference, const hb_reference_config* config,
                        const hb_plateau_config* plateaus, uint8_t is_position);
void hb_reference_stop(hb_reference* reference);
/* Forgets the held position. */
void hb_reference_clear(hb_reference* reference);
/* The point at the present tick; the held point (or zero) when not running. */
hb_reference_point hb_reference_evaluate(hb_reference* reference);
/* One control tick passes; ends the generator when its time is over. */
void hb_reference_advance(hb_reference* reference);

#ifdef __cplusplus
}
#endif

#endif
