/* SPDX-License-Identifier: MIT */
#ifndef HB_PLANAR_WRENCH_H
#define HB_PLANAR_WRENCH_H

/* Coil currents and the wrench on the platen by the published model: heading ignored, fundamental only
 * (resources/help/planar-theory.md sections 5.1 and 6).
 *
 *   psi = g (y + y'_1 - L/4),  chi = g (x + a - 5L/4),  y'_1 = c56 - L
 *   Fx = b (i5 cos chi + i6 sin chi),  Fy = b [(i1 + i4) cos psi - (i2 + i3) sin psi]
 *   Tz = (3L/4) b [(i4 - i1) cos psi + (i2 - i3) sin psi] - c56 Fx,  about the origin of the platen frame */

#include "devices/firmware/planar/hb_planar_pose.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    float force_constant_N_per_A; /* b: negative by the sign of the phases */
    float pitch_m;                /* L */
    float coil_width_m;           /* a */
    float arm56_m;                /* c56 */
} hb_planar_coils;

/* Forces in lattice axes and torque about the origin of the platen frame. */
typedef struct {
    float x_N, y_N, torque_Nm;
} hb_wrench;

/* Set-wise allocation: the least power that gives the wrench, with the vertical forces of each set in
 * balance. */
void hb_planar_allocate(const hb_planar_coils* coils, const hb_pose* pose, const hb_wrench* wrench,
                        float current_A[HB_COILS]);
hb_wrench hb_planar_wrench(const hb_planar_coils* coils, const hb_pose* pose,
                           const float current_A[HB_COILS]);
/* Sum of the vertical forces, N, positive upward. */
float hb_planar_lift_N(const hb_planar_coils* coils, const hb_pose* pose, const float current_A[HB_COILS]);
/* All currents times one factor so that none exceeds the limit, which keeps the direction of the wrench;
 * returns the factor. */
float hb_planar_limit(float current_A[HB_COILS], float limit_A);

#ifdef __cplusplus
}
#endif

#endif
