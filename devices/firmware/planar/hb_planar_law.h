/* SPDX-License-Identifier: MIT */
#ifndef HB_PLANAR_LAW_H
#define HB_PLANAR_LAW_H

/* Position law of one axis (resources/help/planar-theory.md section 9); effort in N or N m, position y from
 * where the mode began, speed v filtered:
 *
 *   u = kp (b r_s + r_p - y) + kd (r_p' - v) + m r_p'' + I;   while not saturated: I <- I + ki Ts (r - y)
 *
 * r = r_s + r_p: steps and set-points, weighted by b, and profiles with speed and acceleration. A free mass
 * is a double integrator: with b = 1 the integral of the error after a step is zero, overshoot is certain. */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    float kp, ki, kd;
    float setpoint_weight; /* b */
    float inertia;         /* m of the feed-forward; 0: none */
} hb_planar_gains;

typedef struct {
    float position, speed;
    float step;
    float profile, profile_speed, profile_acceleration;
} hb_planar_law_input;

/* `integral` is the state I; `may_integrate` 0 while the actuator is saturated. */
float hb_planar_law_step(float* integral, const hb_planar_gains* gains, const hb_planar_law_input* input,
                         float period_s, uint8_t may_integrate);

#ifdef __cplusplus
}
#endif

#endif
