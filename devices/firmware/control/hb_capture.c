/* SPDX-License-Identifier: MIT */
#include "devices/firmware/control/hb_capture.h"

#if HB_FEATURE_CAPTURE

#include <string.h>

void hb_capture_init(hb_capture* capture) {
    memset(capture, 0, sizeof *capture);
}

void hb_capture_start(hb_capture* capture, const hb_capture_config* config) {
    capture->config = *config;
    capture->next = 0;
    capture->filled = 0;
    capture->countdown = 1;
    capture->has_previous = 0;
    capture->state = config->pretrigger > 0 ? HB_CAPTURE_FILLING : HB_CAPTURE_WAITING;
}

void hb_capture_stop(hb_capture* capture) {
    if (capture->state != HB_CAPTURE_FULL) {
        capture->state = HB_CAPTURE_IDLE;
    }
}

/* The trigger signal crosses the level between two ticks. */
static uint8_t crossesLevel(hb_capture* capture, float value) {
    float level = capture->config.level;
    float before = capture->previous_level;
    uint8_t had_previous = capture->has_previous;
    capture->previous_level = value;
    capture->has_previous = 1;
    if (!had_previous) {
        return 0;
    }
    return capture->config.slope == HB_SLOPE_RISING ? before < level && value >= level
                                                    : before > level && value <= level;
}

static uint8_t isTriggered(hb_capture* capture, float trigger_value, uint8_t reference_started) {
    switch (capture->config.trigger) {
    case HB_TRIGGER_LEVEL:
        return crossesLevel(capture, trigger_value);
    case HB_TRIGGER_REFERENCE:
        return reference_started;
    default:
        return 1;
    }
}

static void record(hb_capture* capture, const float values[HB_CAPTURE_SIGNALS]) {
    for (uint8_t i = 0; i < HB_CAPTURE_SIGNALS; i++) {
        capture->samples[i][capture->next] = values[i];
    }
    capture->next = (uint16_t)((capture->next + 1U) % HB_CAPTURE_SAMPLES);
    if (capture->filled < HB_CAPTURE_SAMPLES) {
        capture->filled++;
    }
}

void hb_capture_tick(hb_capture* capture, const float values[HB_CAPTURE_SIGNALS], float trigger_value,
                     uint8_t reference_started, uint32_t time_us) {
    uint8_t triggered;
    if (capture->state == HB_CAPTURE_IDLE || capture->state == HB_CAPTURE_FULL) {
        return;
    }
    triggered = isTriggered(capture, trigger_value, reference_started);
    if (capture->state == HB_CAPTURE_WAITING && triggered) {
        capture->state = HB_CAPTURE_RUNNING;
        capture->left = (uint16_t)(HB_CAPTURE_SAMPLES - capture->config.pretrigger);
    }
    if (--capture->countdown > 0) {
        return; /* samples stay evenly spaced across the trigger */
    }
    if (capture->state == HB_CAPTURE_RUNNING &&
        capture->left == HB_CAPTURE_SAMPLES - capture->config.pretrigger) {
        capture->trigger_time_us = time_us;
    }
    capture->countdown = capture->config.prescaler;
    record(capture, values);
    if (capture->state == HB_CAPTURE_FILLING && capture->filled >= capture->config.pretrigger) {
        capture->state = HB_CAPTURE_WAITING;
    } else if (capture->state == HB_CAPTURE_RUNNING) {
        capture->left--;
        capture->state = capture->left > 0 ? HB_CAPTURE_RUNNING : HB_CAPTURE_FULL;
    }
}

float hb_capture_sample(const hb_capture* capture, uint16_t channel, uint16_t index) {
    uint16_t oldest = capture->filled < HB_CAPTURE_SAMPLES ? 0 : capture->next;
    if (index >= capture->filled) {
        return 0.0F;
    }
    return capture->samples[channel][(oldest + index) % HB_CAPTURE_SAMPLES];
}

#endif
