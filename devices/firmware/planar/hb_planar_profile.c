/* SPDX-License-Identifier: MIT */
#include "devices/firmware/planar/hb_planar_profile.h"

#include <math.h>
#include <string.h>

#define TICK_S (0.001F * HB_TICK_MS)

void hb_profile_start(hb_profile* profile, float from, float distance, float speed, float acceleration) {
    float length = fabsf(distance);
    memset(profile, 0, sizeof *profile);
    profile->from = from;
    if (speed <= 0.0F || acceleration <= 0.0F) {
        return;
    }
    profile->distance = distance;
    profile->acceleration = distance < 0.0F ? -acceleration : acceleration;
    profile->ramp_s = speed / acceleration;
    if (length < speed * profile->ramp_s) {
        profile->ramp_s = sqrtf(length / acceleration);
    } else {
        profile->flat_s = length / speed - profile->ramp_s;
    }
    profile->running = 1;
}

float hb_profile_duration_s(const hb_profile* profile) {
    return 2.0F * profile->ramp_s + profile->flat_s;
}

hb_reference_point hb_profile_point(const hb_profile* profile) {
    float time_s = (float)profile->ticks * TICK_S;
    float left_s = hb_profile_duration_s(profile) - time_s;
    float peak = profile->acceleration * profile->ramp_s;
    hb_reference_point point;
    if (!profile->running || left_s <= 0.0F) {
        point.value = profile->from + profile->distance;
        point.speed = 0.0F;
        point.acceleration = 0.0F;
    } else if (time_s < profile->ramp_s) {
        point.value = profile->from + 0.5F * profile->acceleration * time_s * time_s;
        point.speed = profile->acceleration * time_s;
        point.acceleration = profile->acceleration;
    } else if (left_s < profile->ramp_s) {
        point.value = profile->from + profile->distance - 0.5F * profile->acceleration * left_s * left_s;
        point.speed = profile->acceleration * left_s;
        point.acceleration = -profile->acceleration;
    } else {
        point.value = profile->from + peak * (time_s - 0.5F * profile->ramp_s);
        point.speed = peak;
        point.acceleration = 0.0F;
    }
    return point;
}

void hb_profile_advance(hb_profile* profile) {
    if (profile->running) {
        profile->ticks++;
        profile->running = (float)profile->ticks * TICK_S < hb_profile_duration_s(profile);
    }
}
