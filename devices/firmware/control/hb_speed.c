/* SPDX-License-Identifier: MIT */
#include "devices/firmware/control/hb_speed.h"

#include <string.h>

void hb_speed_init(hb_speed* speed) {
    memset(speed, 0, sizeof *speed);
}

static int32_t wrappingDifference(int32_t a, int32_t b) {
    return (int32_t)((uint32_t)a - (uint32_t)b);
}

static void moveOrigin(hb_speed* speed, int32_t position_counts) {
    int32_t shift = wrappingDifference(position_counts, speed->origin);
    speed->origin = position_counts;
    speed->sum = 0;
    speed->weighted_sum = 0;
    for (uint8_t age = 0; age < speed->filled; age++) {
        uint8_t index = (uint8_t)((speed->next + HB_SPEED_WINDOW - 1U - age) % HB_SPEED_WINDOW);
        speed->position[index] -= shift;
        speed->sum += speed->position[index];
        speed->weighted_sum += (hb_speed_sum)age * speed->position[index];
    }
}

/* Slope of y over time for ages 0..n-1 with S = sum y, W = sum age y:
 *   slope = -(12 W - 6 (n-1) S) / (n (n^2 - 1))
 * A new sample ages all others by one: W <- W + S, then the oldest (now of age n) leaves. */
float hb_speed_update(hb_speed* speed, int32_t position_counts) {
    int32_t relative;
    int32_t n;
    if (speed->filled == 0) {
        speed->origin = position_counts;
    }
    relative = wrappingDifference(position_counts, speed->origin);
    if (relative > HB_SPEED_LARGEST || relative < -HB_SPEED_LARGEST) {
        moveOrigin(speed, position_counts);
        relative = 0;
    }
    speed->weighted_sum += speed->sum;
    if (speed->filled == HB_SPEED_WINDOW) {
        int32_t oldest = speed->position[speed->next];
        speed->weighted_sum -= (hb_speed_sum)HB_SPEED_WINDOW * oldest;
        speed->sum -= oldest;
    } else {
        speed->filled++;
    }
    speed->position[speed->next] = relative;
    speed->sum += relative;
    speed->next = (uint8_t)((speed->next + 1U) % HB_SPEED_WINDOW);
    n = speed->filled;
    if (n < 2) {
        return 0.0F;
    }
    return (float)(6 * (n - 1) * speed->sum - 12 * speed->weighted_sum) / (float)(n * (n * n - 1));
}
