/* SPDX-License-Identifier: MIT */
#ifndef HB_SPEED_H
#define HB_SPEED_H

/* Speed as the least-squares slope over the last HB_SPEED_WINDOW positions. Differencing quantised angles at
 * 1 kHz would show 2.5 rad/s per count; the slope over 32 ms shows about 0.02 rad/s. Exact integer sums: no
 * drift. */

#include "devices/firmware/xcp/hb_config.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if HB_SPEED_WINDOW <= 16
typedef int32_t hb_speed_sum;
#define HB_SPEED_LARGEST (1L << 18)
#else
typedef int64_t hb_speed_sum;
#define HB_SPEED_LARGEST (1L << 28)
#endif

typedef struct {
    int32_t position[HB_SPEED_WINDOW]; /* counts relative to `origin` */
    int32_t origin;
    hb_speed_sum sum, weighted_sum; /* sum of y, sum of age * y */
    uint8_t next, filled;
} hb_speed;

void hb_speed_init(hb_speed* speed);
/* Adds one position in counts; returns the slope in counts per sample, 0 until two samples are there. */
float hb_speed_update(hb_speed* speed, int32_t position_counts);

#ifdef __cplusplus
}
#endif

#endif
