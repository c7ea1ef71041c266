/* SPDX-License-Identifier: MIT */
#ifndef HB_PLANAR_WINDINGS_H
#define HB_PLANAR_WINDINGS_H

/* Coil forces of the closed windings with rounded corners, with the heading and up to three harmonics, and
 * the least-norm currents for a wrench (resources/help/planar-theory.md sections 5.3 and 6):
 *
 *   Phi_k = sum_n C_n [cos(n g X_k) G_x,n(phi) + cos(n g Y_k) G_y,n(phi)],  wrench_k = dPhi_k/d(x, y, phi)
 *
 * G of the published winding as polynomials in phi^2 within +-50 mrad, scaled as a whole to the force
 * constant that was identified. */

#include "devices/firmware/planar/hb_planar_wrench.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { HB_WINDING_ORDERS = 3 }; /* harmonics 1, 5, 9 */

/* Fx, Fy and Tz about the origin of the platen frame, per ampere in each coil. */
typedef struct {
    float row[3][HB_COILS];
} hb_coil_wrench;

/* The first `orders` harmonics. Beyond +-50 mrad the heading counts as 50 mrad. */
hb_coil_wrench hb_planar_windings(const hb_planar_coils* coils, const hb_pose* pose, uint8_t orders);

/* Currents K^T (K K^T)^-1 w; 0, and all zero, when the coils do not determine the wrench. */
uint8_t hb_planar_least_norm(const hb_coil_wrench* forces, const hb_wrench* wrench,
                             float current_A[HB_COILS]);

#ifdef __cplusplus
}
#endif

#endif
