/* SPDX-License-Identifier: MIT */
#ifndef HB_ROTOR_FIELD_H
#define HB_ROTOR_FIELD_H

/* Further spherical harmonics of the rotor's field (resources/help/spherical-theory.md section 3.4): degree
 * and order (4,2), (6,2), (6,6) and (10,10), amplitudes at 50 mm. */

#include "devices/firmware/spherical/hb_orientation.h"

#ifdef __cplusplus
extern "C" {
#endif

uint8_t hb_rotor_has_harmonics(const hb_rotor_field* rotor);

/* Their readings by ideal sensors of the rotor with these axes (u, v, shaft in stator axes). */
void hb_harmonic_readings(const hb_rotor_field* rotor, const hb_tensor_system* system, float axis[3][3],
                          float reading_T[HB_FIELD_CHANNELS]);

#ifdef __cplusplus
}
#endif

#endif
