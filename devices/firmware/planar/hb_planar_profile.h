/* SPDX-License-Identifier: MIT */
#ifndef HB_PLANAR_PROFILE_H
#define HB_PLANAR_PROFILE_H

/* Travel from rest to rest over a distance with limits of speed, acceleration and jerk, as fast as these
 * allow: the jerk is +-j or 0 in seven pieces (S-curve of the speed), of which the constant acceleration and
 * the constant speed drop out where the distance is short. Without a limit of the jerk the speed is a
 * trapezoid. Formulas: resources/help/planar-theory.md section 9. */

#include "devices/firmware/control/hb_reference.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    float speed, acceleration, jerk; /* per s, s^2, s^3; INFINITY: no limit of the jerk */
} hb_profile_limits;

typedef struct {
    float from, distance;
    float jerk, acceleration;     /* with the sign of the distance */
    float jerk_s, hold_s, flat_s; /* duration of one jerk, of the constant acceleration, constant speed */
    uint32_t ticks;               /* since the start */
    uint8_t running;
} hb_profile;

/* t = 0 is the next hb_profile_point(). Limits that are not positive give no travel. */
void hb_profile_start(hb_profile* profile, float from, float distance, const hb_profile_limits* limits);
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
