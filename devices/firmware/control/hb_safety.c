/* SPDX-License-Identifier: MIT */
#include "devices/firmware/control/hb_safety.h"

#include <math.h>
#include <string.h>

void hb_safety_init(hb_safety* safety) {
    memset(safety, 0, sizeof *safety);
}

uint8_t hb_safety_latch(const hb_safety* safety) {
    return safety->fault ? (uint8_t)HB_LATCH_FAULT : safety->stop;
}

uint8_t hb_safety_arm(hb_safety* safety) {
    if (hb_safety_latch(safety) == HB_LATCH_NONE) {
        safety->armed = 1;
    }
    return safety->armed;
}

void hb_safety_disarm(hb_safety* safety) {
    safety->armed = 0;
}

uint8_t hb_safety_stop(hb_safety* safety, uint8_t latch) {
    safety->armed = 0;
    if (safety->stop == HB_LATCH_NONE) {
        safety->stop = latch;
    }
    return hb_safety_latch(safety);
}

void hb_safety_fault(hb_safety* safety, uint8_t fault) {
    safety->armed = 0;
    if (safety->fault == HB_FAULT_NONE) {
        safety->fault = fault;
    }
}

void hb_safety_reset(hb_safety* safety) {
    safety->stop = HB_LATCH_NONE;
    safety->fault = HB_FAULT_NONE;
}

uint8_t hb_safety_status(const hb_safety* safety) {
    if (safety->fault) {
        return HB_STATUS_FAULT;
    }
    if (safety->stop) {
        return safety->stop == HB_LATCH_WATCHDOG ? HB_STATUS_WATCHDOG : HB_STATUS_STOPPED;
    }
    return safety->armed ? HB_STATUS_ARMED : HB_STATUS_IDLE;
}

uint8_t hb_safety_check(const hb_safety* safety, const hb_safety_limits* limits,
                        const hb_safety_state* state) {
    if (state->temperature_degC[0] > limits->limit_degC || state->temperature_degC[1] > limits->limit_degC) {
        return HB_FAULT_TEMPERATURE;
    }
    if (!safety->armed) {
        return HB_FAULT_NONE;
    }
    if (limits->speed_enabled && fabsf(state->speed_rad_s) > limits->speed_rad_s) {
        return HB_FAULT_SPEED;
    }
    if (limits->window_enabled && fabsf(state->excursion_rad) > limits->window_rad) {
        return HB_FAULT_POSITION;
    }
    return HB_FAULT_NONE;
}
