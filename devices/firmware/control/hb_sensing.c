/* SPDX-License-Identifier: MIT */
#include "devices/firmware/control/hb_sensing.h"

#include "devices/firmware/control/hb_constants.h"
#include "devices/firmware/control/hb_safety.h"
#include "devices/firmware/control/hb_trig.h"

#include <math.h>
#include <string.h>

/* Converter and sensors of the board (resources/help/htm-theory.md 2 and 3.4). */
#define VOLT_PER_CODE (5.0F / 1024.0F)
#define HALL_ZERO_V 2.5F
#define HALL_SENSITIVITY_V_PER_T 12.5F /* 12.5 mV/mT at 25 degC */
#define HALL_TEMPERATURE_PER_K 0.0012F
#define HALL_REFERENCE_DEGC 25.0F
#define DEGC_PER_VOLT 100.0F
#define DEGC_AT_ZERO_V (-50.0F)
/* A Hall output outside this is a broken or shorted wire; the sensor itself stays within 0.2..4.8 V. */
#define HALL_LOWEST_V 0.1F
#define HALL_HIGHEST_V 4.9F
/* Range of the temperature sensor, with its error. */
#define LOWEST_DEGC (-45.0F)
#define HIGHEST_DEGC 130.0F

void hb_sensing_init(hb_sensing* sensing) {
    memset(sensing, 0, sizeof *sensing);
    sensing->quadrature_inverse_cosine = 1.0F;
    sensing->gain_code[0] = -1.0F; /* no code: to be computed */
    sensing->gain_code[1] = -1.0F;
}

/* Temperature and the sensitivity at it change rarely from one tick to the next. */
static void takeTemperature(hb_sensing* sensing, uint8_t channel, float code) {
    float temperature = (code + 0.5F) * VOLT_PER_CODE * DEGC_PER_VOLT + DEGC_AT_ZERO_V;
    sensing->temperature_degC[channel] = temperature;
    sensing->gain_code[channel] = code;
    sensing->gain_V_per_T[channel] =
        HALL_SENSITIVITY_V_PER_T * (1.0F + HALL_TEMPERATURE_PER_K * (temperature - HALL_REFERENCE_DEGC));
}

uint8_t hb_sensing_convert(hb_sensing* sensing, const float hall_code[2], const float temperature_code[2]) {
    uint8_t fault = HB_FAULT_NONE;
    for (uint8_t i = 0; i < 2; i++) {
        float hall_V = (hall_code[i] + 0.5F) * VOLT_PER_CODE;
        float temperature;
        if (!isfinite(hall_V) || !isfinite(temperature_code[i])) {
            return HB_FAULT_NOT_FINITE;
        }
        if (temperature_code[i] != sensing->gain_code[i]) {
            takeTemperature(sensing, i, temperature_code[i]);
        }
        temperature = sensing->temperature_degC[i];
        if (hall_V < HALL_LOWEST_V || hall_V > HALL_HIGHEST_V || temperature < LOWEST_DEGC ||
            temperature > HIGHEST_DEGC) {
            fault = HB_FAULT_SENSOR_RANGE;
        }
        sensing->field_T[i] = (hall_V - HALL_ZERO_V) / sensing->gain_V_per_T[i];
    }
    return fault;
}

/* The smaller channel, its sine replaced by the line through 0 and +-45 degrees:
 * q = (pi/4)/(B0 sin 45 deg); on the A axis angle = q B_B, and so on around the circle. */
static float decodeLinear(float a, float b, float amplitude_T) {
    float q = (HB_PI / 4.0F) / (amplitude_T * HB_SQRT_HALF);
    float angle;
    if (fabsf(b) <= fabsf(a)) {
        angle = a > 0.0F ? q * b : HB_PI - q * b;
    } else {
        angle = b > 0.0F ? HB_PI / 2.0F - q * a : -HB_PI / 2.0F + q * a;
    }
    return angle > HB_PI ? angle - HB_TWO_PI : angle;
}

float hb_sensing_decode(hb_sensing* sensing, const hb_hall_correction* correction, float* amplitude_T2) {
    float a = sensing->field_T[0] - correction->stray_T[0] - correction->offset_T[0];
    float b =
        (sensing->field_T[1] - correction->stray_T[1] - correction->offset_T[1]) / correction->gain_ratio;
    if (sensing->quadrature_rad != correction->quadrature_rad) {
        sensing->quadrature_rad = correction->quadrature_rad;
        sensing->quadrature_sine = sinf(correction->quadrature_rad);
        sensing->quadrature_inverse_cosine = 1.0F / cosf(correction->quadrature_rad);
    }
    /* sin(psi + eps) = sin psi cos eps + cos psi sin eps */
    b = (b - a * sensing->quadrature_sine) * sensing->quadrature_inverse_cosine;
    *amplitude_T2 = a * a + b * b;
    if (correction->decode == HB_DECODE_LINEAR) {
        return decodeLinear(a, b, correction->amplitude_T);
    }
    return hb_angle_of(b, a);
}

float hb_error_map_correct(float angle_rad, const float* cosine_rad, const float* sine_rad) {
    float c1 = cosf(angle_rad);
    float s1 = sinf(angle_rad);
    float c = 1.0F;
    float s = 0.0F;
    float error = 0.0F;
    for (uint8_t k = 0; k < HB_ERROR_MAP_ORDERS; k++) {
        float next = c * c1 - s * s1;
        s = s * c1 + c * s1;
        c = next;
        error += cosine_rad[k] * c + sine_rad[k] * s;
    }
    angle_rad -= error;
    if (angle_rad > HB_PI) {
        return angle_rad - HB_TWO_PI;
    }
    return angle_rad <= -HB_PI ? angle_rad + HB_TWO_PI : angle_rad;
}

uint8_t hb_sensing_unwrap(hb_sensing* sensing, float angle_rad) {
    float increment = angle_rad - sensing->angle_rad;
    uint8_t fault = HB_FAULT_NONE;
    if (sensing->started) {
        if (increment > HB_PI) {
            increment -= HB_TWO_PI;
            sensing->turns--;
        } else if (increment < -HB_PI) {
            increment += HB_TWO_PI;
            sensing->turns++;
        }
        if (fabsf(increment) > HB_PI / 2.0F) {
            fault = HB_FAULT_ANGLE_JUMPED;
        }
    }
    sensing->started = 1;
    sensing->angle_rad = angle_rad;
    return fault;
}
