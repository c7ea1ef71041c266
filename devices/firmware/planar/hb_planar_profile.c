/* SPDX-License-Identifier: MIT */
#include "devices/firmware/planar/hb_planar_profile.h"

#include <math.h>
#include <string.h>

#define TICK_S (0.001F * HB_TICK_MS)

/* A duration that rounding may have made negative. */
static float notNegative(float duration_s) {
    return duration_s > 0.0F ? duration_s : 0.0F;
}

/* Durations of the pieces up to the speed, and of the constant speed for what is left of the length. */
static void solveLong(hb_profile* profile, float length, const hb_profile_limits* limits, uint8_t is_flat) {
    if (is_flat) {
        profile->jerk_s = limits->acceleration / limits->jerk;
        profile->hold_s = notNegative(limits->speed / limits->acceleration - profile->jerk_s);
    } else {
        profile->jerk_s = sqrtf(limits->speed / limits->jerk);
        profile->hold_s = 0.0F;
    }
    profile->flat_s = length / limits->speed - 2.0F * profile->jerk_s - profile->hold_s;
}

/* The length is too short for the speed: it is made of acceleration a x (x + jerk_s), x = jerk_s + hold_s, or
 * of jerks alone, 2 jerk jerk_s^3. */
static void solveShort(hb_profile* profile, float length, const hb_profile_limits* limits) {
    float jerk_s = limits->acceleration / limits->jerk;
    profile->flat_s = 0.0F;
    if (length >= 2.0F * limits->acceleration * jerk_s * jerk_s) {
        float root = sqrtf(jerk_s * jerk_s + 4.0F * length / limits->acceleration);
        profile->jerk_s = jerk_s;
        profile->hold_s = notNegative(0.5F * (root - 3.0F * jerk_s));
    } else {
        profile->jerk_s = cbrtf(0.5F * length / limits->jerk);
        profile->hold_s = 0.0F;
    }
}

static uint8_t isPositive(const hb_profile_limits* limits) {
    return limits->speed > 0.0F && limits->acceleration > 0.0F && limits->jerk > 0.0F;
}

void hb_profile_start(hb_profile* profile, float from, float distance, const hb_profile_limits* limits) {
    float length = fabsf(distance);
    float rise_s;
    uint8_t is_flat; /* the acceleration stays at its limit for a while */
    memset(profile, 0, sizeof *profile);
    profile->from = from;
    if (!isPositive(limits) || !(length > 0.0F)) {
        return;
    }
    is_flat = limits->speed * limits->jerk >= limits->acceleration * limits->acceleration;
    solveLong(profile, length, limits, is_flat);
    if (profile->flat_s < 0.0F) {
        solveShort(profile, length, limits);
    }
    /* What arrives exactly with these durations: the limits, but for rounding. */
    rise_s = profile->jerk_s + profile->hold_s;
    profile->distance = distance;
    profile->acceleration = distance / (rise_s * (rise_s + profile->jerk_s + profile->flat_s));
    profile->jerk = profile->jerk_s > 0.0F ? profile->acceleration / profile->jerk_s : 0.0F;
    profile->running = 1;
}

float hb_profile_duration_s(const hb_profile* profile) {
    return 4.0F * profile->jerk_s + 2.0F * profile->hold_s + profile->flat_s;
}

/* Up to the end of the constant speed. */
static hb_reference_point rising(const hb_profile* profile, float time_s) {
    float ramp_s = 2.0F * profile->jerk_s + profile->hold_s;
    float peak = profile->acceleration * (profile->jerk_s + profile->hold_s);
    hb_reference_point point;
    if (time_s < profile->jerk_s) {
        point.acceleration = profile->jerk * time_s;
        point.speed = 0.5F * point.acceleration * time_s;
        point.value = point.speed * time_s / 3.0F;
    } else if (time_s < profile->jerk_s + profile->hold_s) {
        float held_s = time_s - profile->jerk_s;
        point.acceleration = profile->acceleration;
        point.speed = profile->acceleration * (0.5F * profile->jerk_s + held_s);
        point.value = profile->acceleration *
                      (profile->jerk_s * profile->jerk_s / 6.0F + 0.5F * held_s * (profile->jerk_s + held_s));
    } else if (time_s < ramp_s) {
        float left_s = ramp_s - time_s;
        point.acceleration = profile->jerk * left_s;
        point.speed = peak - 0.5F * point.acceleration * left_s;
        point.value = 0.5F * peak * ramp_s - peak * left_s + point.acceleration * left_s * left_s / 6.0F;
    } else {
        point.acceleration = 0.0F;
        point.speed = peak;
        point.value = peak * (time_s - 0.5F * ramp_s);
    }
    return point;
}

hb_reference_point hb_profile_point(const hb_profile* profile) {
    float time_s = (float)profile->ticks * TICK_S;
    float left_s = hb_profile_duration_s(profile) - time_s;
    hb_reference_point point;
    if (!profile->running || left_s <= 0.0F) {
        point.value = profile->from + profile->distance;
        point.speed = 0.0F;
        point.acceleration = 0.0F;
    } else if (left_s < 2.0F * profile->jerk_s + profile->hold_s) {
        point = rising(profile, left_s); /* the way there, backwards */
        point.value = profile->from + profile->distance - point.value;
        point.acceleration = -point.acceleration;
    } else {
        point = rising(profile, time_s);
        point.value += profile->from;
    }
    return point;
}

void hb_profile_advance(hb_profile* profile) {
    if (profile->running) {
        profile->ticks++;
        profile->running = (float)profile->ticks * TICK_S < hb_profile_duration_s(profile);
    }
}
