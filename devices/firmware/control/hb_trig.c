/* SPDX-License-Identifier: MIT */
#include "devices/firmware/control/hb_trig.h"

#include "devices/firmware/control/hb_constants.h"

#include <math.h>
#include <stdint.h>

#if HB_FEATURE_TABLE_TRIG

/* 32767 sin(i pi/128) */
static const uint16_t QuarterSine[65] HB_ROM = {
    0,     804,   1608,  2410,  3212,  4011,  4808,  5602,  6393,  7179,  7962,  8739,  9512,
    10278, 11039, 11793, 12539, 13279, 14010, 14732, 15446, 16151, 16846, 17530, 18204, 18868,
    19519, 20159, 20787, 21403, 22005, 22594, 23170, 23731, 24279, 24811, 25329, 25832, 26319,
    26790, 27245, 27683, 28105, 28510, 28898, 29268, 29621, 29956, 30273, 30571, 30852, 31113,
    31356, 31580, 31785, 31971, 32137, 32285, 32412, 32521, 32609, 32678, 32728, 32757, 32767,
};

/* atan(i/64) in counts of 2 pi/2^18 */
static const uint16_t EighthArc[65] HB_ROM = {
    0,     652,   1303,  1954,  2604,  3253,  3900,  4545,  5188,  5829,  6467,  7101,  7733,
    8361,  8985,  9605,  10221, 10832, 11439, 12040, 12637, 13228, 13814, 14394, 14968, 15537,
    16100, 16656, 17206, 17750, 18288, 18819, 19344, 19862, 20374, 20879, 21378, 21870, 22355,
    22834, 23306, 23771, 24230, 24682, 25128, 25568, 26001, 26427, 26848, 27262, 27670, 28072,
    28467, 28857, 29241, 29619, 29991, 30357, 30718, 31073, 31423, 31767, 32106, 32439, 32768,
};

#define COUNTS_PER_RAD (262144.0F / HB_TWO_PI)
#define QUARTER_COUNTS 65536L
#define HALF_COUNTS 131072L
enum { PHASE_QUARTER = 0x4000, PHASE_HALF = 0x8000 };

/* The table's value at `position`/256. */
static uint16_t between(const uint16_t* table, uint16_t position) {
    const uint16_t* point = &table[position >> 8];
    uint8_t fraction = (uint8_t)position;
    uint16_t low = hb_rom_word(point);
    if (fraction == 0) {
        return low; /* also the last point, behind which there is none */
    }
    return (uint16_t)(low + (((uint32_t)(hb_rom_word(point + 1) - low) * fraction) >> 8));
}

/* `phase` counts 2^-16 turn. */
static float sineOf(uint16_t phase) {
    uint16_t quarter = phase & (PHASE_QUARTER - 1);
    float sine;
    if (phase & PHASE_QUARTER) {
        quarter = (uint16_t)(PHASE_QUARTER - quarter);
    }
    sine = (float)between(QuarterSine, quarter) * (1.0F / 32767.0F);
    return phase & PHASE_HALF ? -sine : sine;
}

void hb_sine_cosine(float angle_rad, float* sine, float* cosine) {
    uint16_t phase = (uint16_t)(int32_t)(angle_rad * (65536.0F / HB_TWO_PI));
    *sine = sineOf(phase);
    *cosine = sineOf((uint16_t)(phase + PHASE_QUARTER));
}

float hb_angle_of(float y, float x) {
    float ay = fabsf(y);
    float ax = fabsf(x);
    uint8_t is_steep = ay > ax;
    float longer = is_steep ? ay : ax;
    int32_t counts;
    if (!(longer > 0.0F)) {
        return 0.0F; /* no direction; the caller sees the missing amplitude */
    }
    counts = between(EighthArc, (uint16_t)((is_steep ? ax : ay) / longer * 16384.0F));
    counts = is_steep ? QUARTER_COUNTS - counts : counts;
    counts = x < 0.0F ? HALF_COUNTS - counts : counts;
    return (float)(y < 0.0F ? -counts : counts) * (1.0F / COUNTS_PER_RAD);
}

#else

#if HB_FEATURE_FUSED_TRIG

/* pi/2 in two parts of single precision, the first one rounded. */
#define QUARTER_TURN_HIGH 1.57079637F
#define QUARTER_TURN_LOW -4.37113883e-8F

/* Both from the rest of one division by a quarter turn: minimax polynomials over +-pi/4 (those of FreeBSD's
 * k_sinf.c and k_cosf.c in single precision), then the quadrant. */
void hb_sine_cosine(float angle_rad, float* sine, float* cosine) {
    float quarters = angle_rad * (4.0F / HB_TWO_PI);
    int32_t quadrant = (int32_t)(quarters + (quarters < 0.0F ? -0.5F : 0.5F));
    float rest = fmaf(-(float)quadrant, QUARTER_TURN_HIGH, angle_rad);
    float square;
    float s;
    float c;
    rest = fmaf(-(float)quadrant, QUARTER_TURN_LOW, rest);
    square = rest * rest;
    s = fmaf(square, fmaf(square, fmaf(square, 2.71831149e-6F, -1.98393348e-4F), 8.33332911e-3F),
             -1.66666667e-1F);
    s = fmaf(rest * square, s, rest);
    c = fmaf(square, fmaf(square, fmaf(square, 2.43904487e-5F, -1.38867637e-3F), 4.16666233e-2F),
             -4.99999997e-1F);
    c = fmaf(square, c, 1.0F);
    *sine = ((uint32_t)quadrant & 1U) != 0U ? c : s;
    *cosine = ((uint32_t)quadrant & 1U) != 0U ? s : c;
    if (((uint32_t)quadrant & 2U) != 0U) {
        *sine = -*sine;
    }
    if ((((uint32_t)quadrant + 1U) & 2U) != 0U) {
        *cosine = -*cosine;
    }
}

#else

void hb_sine_cosine(float angle_rad, float* sine, float* cosine) {
    *sine = sinf(angle_rad);
    *cosine = cosf(angle_rad);
}

#endif

float hb_angle_of(float y, float x) {
    return atan2f(y, x);
}

#endif
