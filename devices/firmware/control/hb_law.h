/* SPDX-License-Identifier: MIT */
#ifndef HB_LAW_H
#define HB_LAW_H

/* The one position control law; every preset is a parameter set of it
 * (resources/help/htm-theory.md 3.6, 6.6, 8.4):
 *
 *   u = Kp e + x + Kd (r' - (psi[k] - psi[k-1])/Ts) + inertia r'' + viscous r' + coulomb
 * sat(r'/coulomb_speed)
 *       + (|r'| < stiction_speed and |e| > stiction_threshold) stiction sgn(e)
 *   u_sat = clamp(u, +-limit);   if (u = u_sat or e u < 0)  x <- x + Ts Ki e
 */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HB_LAW_POSITIONAL = 0, HB_LAW_LITERAL = 1, HB_LAW_LITERAL_CLAMPED = 2 };

typedef struct {
    uint8_t law;
    float kp_A_per_rad, ki_A_per_rad_s, kd_As_per_rad;
    float inertia_As2_per_rad, viscous_As_per_rad, coulomb_A, coulomb_speed_rad_s;
    float stiction_A, stiction_threshold_rad, stiction_speed_rad_s;
    float limit_A, period_s;
    uint8_t delay_samples; /* 0, 1 or 2 */
} hb_law_config;

typedef struct {
    float integral_A;
    float previous_position_rad;
    float previous_error_rad, memory_A; /* of the literal difference equation */
    float delayed_A[2];
    uint8_t started;
} hb_law;

typedef struct {
    float position_rad;
    float reference_rad, reference_speed_rad_s, reference_acceleration_rad_s2;
} hb_law_input;

void hb_law_reset(hb_law* law);
/* One position-loop sample: the current command in A, within the limit, delayed as configured. */
float hb_law_step(hb_law* law, const hb_law_config* config, const hb_law_input* input);

#ifdef __cplusplus
}
#endif

#endif
