/* SPDX-License-Identifier: MIT */
#ifndef HB_SENSING_H
#define HB_SENSING_H

/* From ADC codes to the unwrapped rotor angle (resources/help/htm-theory.md 3.4, 3.5, 7.5). Angle in rad,
 * field in T. */

#include "devices/firmware/xcp/hb_config.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HB_DECODE_ARCTANGENT = 0, HB_DECODE_LINEAR = 1 };
enum { HB_ERROR_MAP_ORDERS = 6 };

typedef struct {
    float field_T[2]; /* from the codes, temperature compensated, nothing else corrected */
    float temperature_degC[2];
    float gain_code[2], gain_V_per_T[2]; /* temperature code and the sensitivity that follows from it */
    float angle_rad;                     /* decoded, (-pi, pi] */
    int32_t turns;                       /* unwrapped angle = turns * 2 pi + angle */
    float quadrature_rad;                /* the value the two below belong to */
    float quadrature_sine, quadrature_inverse_cosine;
    uint8_t started;
} hb_sensing;

/* What the angle is corrected for. */
typedef struct {
    float offset_T[2];
    float gain_ratio;     /* amplitude of channel B over channel A */
    float quadrature_rad; /* channel B sees sin(psi + quadrature) */
    float amplitude_T;
    float stray_T[2]; /* field of the own phase's current, 0 when not compensated */
    uint8_t decode;
} hb_hall_correction;

void hb_sensing_init(hb_sensing* sensing);
/* Codes 0..1023 of the 10 bit, 5 V converter, fractions allowed. Returns 0, or the fault (hb_safety.h). */
uint8_t hb_sensing_convert(hb_sensing* sensing, const float hall_code[2], const float temperature_code[2]);
/* Corrects and decodes the last fields; (-pi, pi]. Also the square of their amplitude. */
float hb_sensing_decode(hb_sensing* sensing, const hb_hall_correction* correction, float* amplitude_T2);
/* Subtracts the angle error map: sum over k of cosine[k-1] cos(k angle) + sine[k-1] sin(k angle). */
float hb_error_map_correct(float angle_rad, const float* cosine_rad, const float* sine_rad);
/* Adds the nearest-difference increment; HB_FAULT_ANGLE_JUMPED if it exceeds 90 degrees. */
uint8_t hb_sensing_unwrap(hb_sensing* sensing, float angle_rad);

#ifdef __cplusplus
}
#endif

#endif
