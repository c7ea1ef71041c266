/* SPDX-License-Identifier: MIT */
#ifndef HB_LAW_H
#define HB_LAW_H

/* The one position control law; every preset is a parameter set of it
 * (resources/help/htm-theory.md 3.6, 6.6, 8.4 and resources/help/tuning.md, "Set-point weights and filters"):
 *
 *   d = (Tf d + Ts ((1 - c) r' + (w[k] - w[k-1])/Ts))/(Tf + Ts),   w = c r - psi
 *   v = F [ Kp (b r - psi) + x + Kd d ]
 *   u = v + inertia r'' + viscous r' + coulomb sat(r'/coulomb_speed)
 *         + (|r'| < stiction_speed and |e| > stiction_threshold) stiction sgn(e),   e = r - psi
 *   u_sat = clamp(u, +-limit);   if ((u = u_sat and the actuator has room) or e u < 0)  x <- x + Ts Ki e
 *
 * b and c are the set-point weights: of a smooth reference the derivative knows the speed r' whatever c is,
 * of a jump it sees the share c. F is a series of second-order sections in the shift d = z - 1, in which slow
 * filters keep their digits in single precision:
 *
 *   (b0 d^2 + b1 d + b2)/(d^2 + a1 d + a2)
 *
 * With b = 1, c = 0, Tf = 0 and sections of b0 = 1 alone it is the plain law, to the bit. */

#include "devices/firmware/xcp/hb_config.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HB_LAW_POSITIONAL = 0, HB_LAW_LITERAL = 1, HB_LAW_LITERAL_CLAMPED = 2 };

/* A section without a1 has no memory: b0 alone counts. */
typedef struct {
    float b0, b1, b2, a1, a2;
} hb_law_section;

typedef struct {
    uint8_t law;
    float kp_A_per_rad, ki_A_per_rad_s, kd_As_per_rad;
#if HB_LAW_WEIGHTS
    float reference_weight, derivative_reference_weight, derivative_filter_s; /* b, c, Tf */
#endif
#if HB_LAW_SECTIONS > 0
    hb_law_section sections[HB_LAW_SECTIONS];
#endif
    float inertia_As2_per_rad, viscous_As_per_rad, coulomb_A, coulomb_speed_rad_s;
    float stiction_A, stiction_threshold_rad, stiction_speed_rad_s;
    float limit_A, period_s;
    uint8_t delay_samples; /* 0, 1 or 2 */
} hb_law_config;

typedef struct {
    float integral_A;
#if HB_LAW_WEIGHTS
    float previous_weighted_rad, rate_rad_s; /* w and d */
#else
    float previous_position_rad;
#endif
#if HB_LAW_SECTIONS > 0
    float filtered[HB_LAW_SECTIONS][2];
#endif
    float previous_error_rad, memory_A; /* of the literal difference equation */
    float delayed_A[2];
    uint8_t started;
} hb_law;

typedef struct {
    float position_rad;
    float reference_rad, reference_speed_rad_s, reference_acceleration_rad_s2;
    uint8_t is_saturated; /* what the law drives has no room left: the integral stops as at its own limit */
} hb_law_input;

void hb_law_reset(hb_law* law);
/* One position-loop sample: the current command in A, within the limit, delayed as configured. */
float hb_law_step(hb_law* law, const hb_law_config* config, const hb_law_input* input);

#ifdef __cplusplus
}
#endif

#endif
