/* SPDX-License-Identifier: MIT */
#include "devices/firmware/spherical/hb_sensor_frames.h"

#include <math.h>
#include <string.h>

#define QUARTER_TURN 1.5707963F

static void multiply(const float a[3][3], const float b[3][3], float product[3][3]) {
    for (uint8_t i = 0; i < 3; i++) {
        for (uint8_t j = 0; j < 3; j++) {
            product[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
        }
    }
}

/* Rotation about axis 0, 1 or 2. */
static void rotationAbout(uint8_t axis, float angle_rad, float rotation[3][3]) {
    uint8_t next = (uint8_t)((axis + 1U) % 3U);
    uint8_t last = (uint8_t)((axis + 2U) % 3U);
    memset(rotation, 0, 9U * sizeof(float));
    rotation[axis][axis] = 1.0F;
    rotation[next][next] = cosf(angle_rad);
    rotation[last][last] = rotation[next][next];
    rotation[last][next] = sinf(angle_rad);
    rotation[next][last] = -rotation[last][next];
}

float hb_dot(const float a[3], const float b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void hb_cross(const float a[3], const float b[3], float product[3]) {
    product[0] = a[1] * b[2] - a[2] * b[1];
    product[1] = a[2] * b[0] - a[0] * b[2];
    product[2] = a[0] * b[1] - a[1] * b[0];
}

/* Rodrigues: v cos a + (w x v) sin a / a + w (w.v) (1 - cos a)/a^2. */
static void turn(const float turn_rad[3], float vector[3]) {
    float square = turn_rad[0] * turn_rad[0] + turn_rad[1] * turn_rad[1] + turn_rad[2] * turn_rad[2];
    float angle_rad = sqrtf(square);
    /* Below this the next term of the series is under the precision of a float. */
    uint8_t is_small = angle_rad < 1.0e-2F;
    float along = turn_rad[0] * vector[0] + turn_rad[1] * vector[1] + turn_rad[2] * vector[2];
    float sine = is_small ? 1.0F - square / 6.0F : sinf(angle_rad) / angle_rad;
    float half = is_small ? 0.5F - square / 24.0F : (1.0F - cosf(angle_rad)) / square;
    float across[3];
    hb_cross(turn_rad, vector, across);
    for (uint8_t i = 0; i < 3; i++) {
        vector[i] = vector[i] * (1.0F - half * square) + across[i] * sine + turn_rad[i] * along * half;
    }
}

static void placementRotation(const hb_field_sensors* sensors, uint8_t sensor, uint8_t frames,
                              float rotation[3][3]) {
    float x[3][3];
    float y[3][3];
    float z[3][3];
    float inner[3][3];
    rotationAbout(0, sensors->alpha_rad[sensor], x);
    rotationAbout(1, sensors->beta_rad[sensor], y);
    rotationAbout(2, sensors->gamma_rad[sensor], z);
    if (frames == HB_FRAMES_XYZ) {
        multiply((const float(*)[3])y, (const float(*)[3])z, inner);
        multiply((const float(*)[3])x, (const float(*)[3])inner, rotation);
        return;
    }
    multiply((const float(*)[3])y, (const float(*)[3])x, inner);
    multiply((const float(*)[3])z, (const float(*)[3])inner, rotation);
    if (frames == HB_FRAMES_NATURAL) {
        float across = sqrtf(rotation[0][0] * rotation[0][0] + rotation[1][0] * rotation[1][0]);
        rotationAbout(1, atan2f(across, rotation[2][0]) - QUARTER_TURN, y);
        rotationAbout(2, atan2f(rotation[1][0], rotation[0][0]), z);
        multiply((const float(*)[3])z, (const float(*)[3])y, rotation);
    }
}

hb_sensor_frame hb_sensor_frame_of(const hb_field_sensors* sensors, uint8_t sensor, uint8_t frames) {
    hb_sensor_frame frame;
    float rotation[3][3];
    placementRotation(sensors, sensor, frames, rotation);
    for (uint8_t i = 0; i < 3; i++) {
        frame.place[i] = rotation[i][0];
        frame.axis[0][i] = rotation[i][0];
        frame.axis[1][i] = -rotation[i][2];
        frame.axis[2][i] = rotation[i][1];
    }
    for (uint8_t k = 0; k < 3; k++) {
        turn(&sensors->turn_rad[3U * sensor], frame.axis[k]);
    }
    return frame;
}

uint8_t hb_solve3(const float matrix[3][3], const float right[3], float x[3]) {
    float minor[3][3];
    float determinant;
    for (uint8_t i = 0; i < 3; i++) {
        hb_cross(matrix[(i + 1U) % 3U], matrix[(i + 2U) % 3U], minor[i]);
    }
    determinant = matrix[0][0] * minor[0][0] + matrix[0][1] * minor[0][1] + matrix[0][2] * minor[0][2];
    if (!(fabsf(determinant) > 1.0e-30F)) {
        return 0;
    }
    for (uint8_t i = 0; i < 3; i++) {
        x[i] = (minor[0][i] * right[0] + minor[1][i] * right[1] + minor[2][i] * right[2]) / determinant;
    }
    return 1;
}

uint8_t hb_sensor_correction(const hb_field_sensors* sensors, uint8_t sensor, float correction[3][3]) {
    const float* gain = &sensors->gain[3U * sensor];
    const float* skew = &sensors->skew[3U * sensor];
    const float mixing[3][3] = {{1.0F + gain[0], skew[0] * (1.0F + gain[1]), skew[1] * (1.0F + gain[2])},
                                {skew[0] * (1.0F + gain[0]), 1.0F + gain[1], skew[2] * (1.0F + gain[2])},
                                {skew[1] * (1.0F + gain[0]), skew[2] * (1.0F + gain[1]), 1.0F + gain[2]}};
    for (uint8_t k = 0; k < 3; k++) {
        float unit[3] = {0.0F, 0.0F, 0.0F};
        float column[3];
        unit[k] = 1.0F;
        if (!hb_solve3(mixing, unit, column)) {
            return 0;
        }
        for (uint8_t i = 0; i < 3; i++) {
            correction[i][k] = column[i];
        }
    }
    return 1;
}

void hb_turn_own(float axis[3][3], const float turn_rad[3]) {
    float stator[3];
    for (uint8_t i = 0; i < 3; i++) {
        stator[i] = axis[0][i] * turn_rad[0] + axis[1][i] * turn_rad[1] + axis[2][i] * turn_rad[2];
    }
    for (uint8_t k = 0; k < 3; k++) {
        turn(stator, axis[k]);
    }
}

void hb_quaternion_of(const float rotation[3][3], float quaternion[4]) {
    float trace = rotation[0][0] + rotation[1][1] + rotation[2][2];
    uint8_t largest = 0; /* 0: w, 1 ... 3: x, y, z */
    float square = trace;
    float sign;
    for (uint8_t i = 0; i < 3; i++) {
        float candidate = 2.0F * rotation[i][i] - trace;
        if (candidate > square) {
            square = candidate;
            largest = (uint8_t)(i + 1U);
        }
    }
    if (largest == 0) {
        quaternion[0] = 1.0F + trace;
        quaternion[1] = rotation[2][1] - rotation[1][2];
        quaternion[2] = rotation[0][2] - rotation[2][0];
        quaternion[3] = rotation[1][0] - rotation[0][1];
    } else {
        uint8_t i = (uint8_t)(largest - 1U);
        uint8_t j = (uint8_t)((i + 1U) % 3U);
        uint8_t k = (uint8_t)((i + 2U) % 3U);
        quaternion[0] = rotation[k][j] - rotation[j][k];
        quaternion[1U + i] = 1.0F + square;
        quaternion[1U + j] = rotation[j][i] + rotation[i][j];
        quaternion[1U + k] = rotation[k][i] + rotation[i][k];
    }
    sign = quaternion[0] < 0.0F ? -1.0F : 1.0F;
    square = 0.0F;
    for (uint8_t i = 0; i < 4; i++) {
        square += quaternion[i] * quaternion[i];
    }
    for (uint8_t i = 0; i < 4; i++) {
        quaternion[i] *= sign / sqrtf(square);
    }
}
