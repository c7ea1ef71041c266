/* SPDX-License-Identifier: MIT */
#ifndef HB_TRIG_H
#define HB_TRIG_H

/* Sine and arctangent of the control cycle: the C library's, or with HB_FEATURE_TABLE_TRIG tables of 65
 * points with straight lines between them, within 2e-4 (sine) and 1.1e-4 rad (arctangent) in less than half
 * the time. One code of a 10 bit converter is 2.5e-3 rad. With HB_FEATURE_FUSED_TRIG sine and cosine come
 * together, within 1.2e-7 up to 200 rad, in a quarter of the instructions of a library without double
 * precision. */

#include "devices/firmware/xcp/hb_config.h"

#ifdef __cplusplus
extern "C" {
#endif

/* |angle| up to 1e5 rad. */
void hb_sine_cosine(float angle_rad, float* sine, float* cosine);
/* Angle of the vector (x, y), (-pi, pi]. */
float hb_angle_of(float y, float x);

#ifdef __cplusplus
}
#endif

#endif
