/* SPDX-License-Identifier: MIT */
#ifndef HB_CAPTURE_H
#define HB_CAPTURE_H

/* Four signals at loop rate with pre-trigger. */

#include "devices/firmware/xcp/hb_config.h"

#include <stdint.h>

#if HB_FEATURE_CAPTURE

#ifdef __cplusplus
extern "C" {
#endif

enum { HB_CAPTURE_SIGNALS = 4, HB_CAPTURE_SAMPLES = 4096 };
enum hb_capture_state {
    HB_CAPTURE_IDLE,
    HB_CAPTURE_FILLING,
    HB_CAPTURE_WAITING,
    HB_CAPTURE_RUNNING,
    HB_CAPTURE_FULL
};
enum hb_capture_trigger { HB_TRIGGER_IMMEDIATE, HB_TRIGGER_LEVEL, HB_TRIGGER_REFERENCE };
enum { HB_SLOPE_RISING, HB_SLOPE_FALLING };

/* Part of the live parameters; start() copies it. */
typedef struct {
    float level;
    uint16_t pretrigger;                /* samples before the trigger, below HB_CAPTURE_SAMPLES */
    uint16_t prescaler;                 /* ticks per sample, >= 1 */
    uint8_t signal[HB_CAPTURE_SIGNALS]; /* handles of the signals; 255 = none */
    uint8_t trigger, trigger_signal, slope;
} hb_capture_config;

typedef struct {
    hb_capture_config config;
    uint8_t state;
    uint8_t has_previous;
    uint16_t next, filled, left, countdown;
    float previous_level;
    uint32_t trigger_time_us;                              /* device time of sample number `pretrigger` */
    float samples[HB_CAPTURE_SIGNALS][HB_CAPTURE_SAMPLES]; /* rings */
} hb_capture;

void hb_capture_init(hb_capture* capture);
void hb_capture_start(hb_capture* capture, const hb_capture_config* config);
void hb_capture_stop(hb_capture* capture);
/* One tick with the values of the four signals and of the trigger signal. */
void hb_capture_tick(hb_capture* capture, const float values[HB_CAPTURE_SIGNALS], float trigger_value,
                     uint8_t reference_started, uint32_t time_us);
/* Sample `index` in order of time; 0 for what was not recorded. */
float hb_capture_sample(const hb_capture* capture, uint16_t channel, uint16_t index);

#ifdef __cplusplus
}
#endif

#endif

#endif
