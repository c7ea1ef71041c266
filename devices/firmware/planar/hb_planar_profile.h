/* SPDX-License-Identifier: MIT */
#ifndef HB_PLANAR_PROFILE_H
#define HB_PLANAR_PROFILE_H

/* Travel from rest to rest over a distance with limits of speed and acceleration: a trapezoid of the speed,
 * a triangle where the distance is shorter than speed^2/acceleration. */

#include "devices/firmware/control/hb_reference.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    float from, distance, acceleration; /* acceleration with the sign of the distance */
    float ramp_s, flat_s;               /* duration of one ramp and of the constant speed */
    uint32_t ticks;                     /* since the start */
    uint8_t running;
} hb_profile;

/* t = 0 is the next hb_profile_point(). Limits that are not positive give no travel. */
void hb_profile_start(hb_profile* profile, float from, float distance, float speed, float acceleration);
/* The point at the present tick; `from` plus the distance at rest behind the end. */
hb_reference_point hb_profile_point(const hb_profile* profile);
/* One tick passes; ends the travel when its time is over. */
void hb_profile_advance(hb_profile* profile);
/* Of the whole travel. */
float hb_profile_duration_s(const hb_profile* profile);

#ifdef __cplusplus
}
#endif

#endif
