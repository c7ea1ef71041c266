/* SPDX-License-Identifier: MIT */
#include "devices/firmware/spherical/hb_orientation.h"

#include "devices/firmware/spherical/hb_rotor_field.h"
#include "devices/firmware/spherical/hb_sensor_frames.h"

#include <math.h>
#include <string.h>

#define HALF_ROOT 0.70710678F  /* 1/sqrt(2) */
#define SIXTH_ROOT 0.40824829F /* 1/sqrt(6) */
#define TWO_PI 6.2831853F

/* Trace of the inverse information below this: no singular value under 0.05. */
#define LARGEST_VARIANCE 400.0F

/* sqrt(-2 ln 0.05): of a planar Gaussian error with equal deviations 95 % lie within so many of them. */
#define CONE95 2.4477468F

/* A field weaker than this share of the calibrated one is none to orient by. */
#define LEAST_STRENGTH 0.05F

/* Passes that subtract the harmonics: amplitudes of 3 mT leave a few 1e-4 degrees, and the tick that also
 * prepares the least-squares problem stays under 20 000 instructions. */
#define HARMONIC_PASSES 3U

static float dotTensor(const float a[HB_TENSOR_SIZE], const float b[HB_TENSOR_SIZE]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] + a[4] * b[4];
}

static void normalise(float a[3]) {
    float scale = 1.0F / sqrtf(hb_dot(a, a));
    for (uint8_t i = 0; i < 3; i++) {
        a[i] *= scale;
    }
}

/* Coordinates of a b^T + b a^T without its trace. */
static void symmetricProduct(const float a[3], const float b[3], float x[HB_TENSOR_SIZE]) {
    float xx = 2.0F * a[0] * b[0];
    float yy = 2.0F * a[1] * b[1];
    float zz = 2.0F * a[2] * b[2];
    x[0] = HALF_ROOT * (xx - yy);
    x[1] = SIXTH_ROOT * (2.0F * zz - xx - yy);
    x[2] = 2.0F * HALF_ROOT * (a[0] * b[1] + a[1] * b[0]);
    x[3] = 2.0F * HALF_ROOT * (a[0] * b[2] + a[2] * b[0]);
    x[4] = 2.0F * HALF_ROOT * (a[1] * b[2] + a[2] * b[1]);
}

static void tensorOf(const float x[HB_TENSOR_SIZE], float tensor[3][3]) {
    tensor[0][0] = HALF_ROOT * x[0] - SIXTH_ROOT * x[1];
    tensor[1][1] = -HALF_ROOT * x[0] - SIXTH_ROOT * x[1];
    tensor[2][2] = 2.0F * SIXTH_ROOT * x[1];
    tensor[0][1] = HALF_ROOT * x[2];
    tensor[0][2] = HALF_ROOT * x[3];
    tensor[1][2] = HALF_ROOT * x[4];
    tensor[1][0] = tensor[0][1];
    tensor[2][0] = tensor[0][2];
    tensor[2][1] = tensor[1][2];
}

/* Inverse of a symmetric positive matrix by Gauss-Jordan without exchange; 0 when it is none. */
static uint8_t invert(const float matrix[HB_TENSOR_SIZE][HB_TENSOR_SIZE],
                      float inverse[HB_TENSOR_SIZE][HB_TENSOR_SIZE]) {
    memcpy(inverse, matrix, sizeof(float) * HB_TENSOR_SIZE * HB_TENSOR_SIZE);
    for (uint8_t k = 0; k < HB_TENSOR_SIZE; k++) {
        float pivot = inverse[k][k];
        if (!(pivot > 1.0e-6F)) {
            return 0;
        }
        inverse[k][k] = 1.0F;
        for (uint8_t j = 0; j < HB_TENSOR_SIZE; j++) {
            inverse[k][j] /= pivot;
        }
        for (uint8_t i = 0; i < HB_TENSOR_SIZE; i++) {
            float factor = inverse[i][k];
            if (i != k) {
                inverse[i][k] = 0.0F;
                for (uint8_t j = 0; j < HB_TENSOR_SIZE; j++) {
                    inverse[i][j] -= factor * inverse[k][j];
                }
            }
        }
    }
    return 1;
}

/* Rows of the design: readings of each axis t at r n per unit of the coordinates,
 * (r_ref/r)^4 (2.5 (n.t) [n n^T + n n^T] - [t n^T + n t^T]) in coordinates. */
static void fillDesign(hb_tensor_system* system, const hb_field_sensors* sensors, uint8_t frames) {
    for (uint8_t s = 0; s < HB_FIELD_SENSORS; s++) {
        hb_sensor_frame frame = hb_sensor_frame_of(sensors, s, frames);
        float ratio = HB_REFERENCE_RADIUS_M / sensors->radius_m[s];
        float fall = ratio * ratio * ratio * ratio;
        float radial[HB_TENSOR_SIZE];
        memcpy(system->place[s], frame.place, sizeof frame.place);
        memcpy(system->axis[3U * s], frame.axis, sizeof frame.axis);
        system->fall[s] = ratio;
        symmetricProduct(frame.place, frame.place, radial);
        for (uint8_t k = 0; k < 3; k++) {
            float* row = system->design[3U * s + k];
            float along = 2.5F * hb_dot(frame.place, frame.axis[k]);
            symmetricProduct(frame.axis[k], frame.place, row);
            for (uint8_t i = 0; i < HB_TENSOR_SIZE; i++) {
                row[i] = fall * (along * radial[i] - row[i]);
            }
        }
    }
}

uint8_t hb_tensor_prepare(hb_tensor_system* system, const hb_field_sensors* sensors, uint8_t frames,
                          uint16_t used) {
    float inverse[HB_TENSOR_SIZE][HB_TENSOR_SIZE];
    float variance = 0.0F;
    memset(system, 0, sizeof *system);
    system->used = used;
    for (uint8_t s = 0; s < HB_FIELD_SENSORS; s++) {
        if (!hb_sensor_correction(sensors, s, system->correction[s])) {
            return 0;
        }
    }
    fillDesign(system, sensors, frames);
    for (uint8_t c = 0; c < HB_FIELD_CHANNELS; c++) {
        for (uint8_t i = 0; i < HB_TENSOR_SIZE && (((uint32_t)used >> c) & 1U); i++) {
            for (uint8_t j = 0; j < HB_TENSOR_SIZE; j++) {
                system->information[i][j] += system->design[c][i] * system->design[c][j];
            }
        }
    }
    if (!invert((const float(*)[HB_TENSOR_SIZE])system->information, inverse)) {
        return 0;
    }
    for (uint8_t i = 0; i < HB_TENSOR_SIZE; i++) {
        variance += inverse[i][i];
        for (uint8_t c = 0; c < HB_FIELD_CHANNELS; c++) {
            system->solver[i][c] =
                (((uint32_t)used >> c) & 1U) ? dotTensor(inverse[i], system->design[c]) : 0.0F;
        }
    }
    system->is_determined = variance > 0.0F && variance < LARGEST_VARIANCE;
    return system->is_determined;
}

void hb_field_correct(const hb_tensor_system* system, const hb_field_sensors* sensors, float current_A,
                      float reading_T[HB_FIELD_CHANNELS]) {
    for (uint8_t s = 0; s < HB_FIELD_SENSORS; s++) {
        float own_T[3];
        for (uint8_t k = 0; k < 3; k++) {
            uint8_t c = (uint8_t)(3U * s + k);
            own_T[k] = ((system->used >> c) & 1U)
                           ? reading_T[c] - current_A * sensors->coil_T_per_A[c] - sensors->offset_T[c]
                           : 0.0F;
        }
        for (uint8_t k = 0; k < 3; k++) {
            reading_T[3U * s + k] = hb_dot(system->correction[s][k], own_T);
        }
    }
}

/* Column of a symmetric matrix with the largest diagonal entry. */
static uint8_t strongestColumn(float matrix[3][3]) {
    uint8_t first = (uint8_t)(matrix[0][0] >= matrix[1][1] ? 0 : 1);
    return matrix[first][first] >= matrix[2][2] ? first : 2U;
}

/* Columns in `axis`: axis[0] = u, axis[1] = v, axis[2] = shaft. With Q/q, Q^2 + Q and Q^2 - Q are twice the
 * projectors on u and v. */
static void projectorAxes(const float x[HB_TENSOR_SIZE], float strength_T, float axis[3][3]) {
    float unit[3][3];
    float scaled[HB_TENSOR_SIZE];
    float plus[3][3];
    float minus[3][3];
    float overlap;
    uint8_t column;
    for (uint8_t i = 0; i < HB_TENSOR_SIZE; i++) {
        scaled[i] = x[i] / strength_T;
    }
    tensorOf(scaled, unit);
    for (uint8_t i = 0; i < 3; i++) {
        for (uint8_t j = 0; j < 3; j++) {
            float square = hb_dot(unit[i], unit[j]);
            plus[i][j] = square + unit[i][j];
            minus[i][j] = square - unit[i][j];
        }
    }
    column = strongestColumn(plus);
    memcpy(axis[0], plus[column], sizeof axis[0]); /* symmetric: a row is a column */
    normalise(axis[0]);
    column = strongestColumn(minus);
    memcpy(axis[1], minus[column], sizeof axis[1]);
    normalise(axis[1]);
    /* Orthogonal in equal parts. */
    overlap = 0.5F * hb_dot(axis[0], axis[1]);
    for (uint8_t i = 0; i < 3; i++) {
        float u = axis[0][i];
        axis[0][i] -= overlap * axis[1][i];
        axis[1][i] -= overlap * u;
    }
    normalise(axis[0]);
    overlap = hb_dot(axis[0], axis[1]);
    for (uint8_t i = 0; i < 3; i++) {
        axis[1][i] -= overlap * axis[0][i];
    }
    normalise(axis[1]);
    hb_cross(axis[0], axis[1], axis[2]);
}

/* Rows of the derivative of the unit tensor's coordinates by a rotation about the rotor's own axes: turning
 * about u moves v to p, about v moves u to -p, about p moves u to v and v to -u. */
static void turnRows(float axis[3][3], float turn[3][HB_TENSOR_SIZE]) {
    symmetricProduct(axis[1], axis[2], turn[0]);
    symmetricProduct(axis[0], axis[2], turn[1]);
    symmetricProduct(axis[0], axis[1], turn[2]);
    for (uint8_t i = 0; i < HB_TENSOR_SIZE; i++) {
        turn[0][i] = -turn[0][i];
        turn[1][i] = -turn[1][i];
        turn[2][i] *= 2.0F;
    }
}

static void unitTensor(float axis[3][3], float x[HB_TENSOR_SIZE]) {
    float sum[3];
    float difference[3];
    for (uint8_t i = 0; i < 3; i++) {
        sum[i] = axis[0][i] + axis[1][i];
        difference[i] = 0.5F * (axis[0][i] - axis[1][i]);
    }
    symmetricProduct(sum, difference, x);
}

/* Larger deviation of the shaft's direction for readings with the deviation one: the shaft moves with
 * rotations about the first two axes of the rotor, whose covariance is the upper left part of the inverse
 * normal matrix. */
static float shaftDeviation(const float normal[3][3]) {
    static const float First[3] = {1.0F, 0.0F, 0.0F};
    static const float Second[3] = {0.0F, 1.0F, 0.0F};
    float u[3];
    float v[3];
    float mean;
    float half;
    if (!hb_solve3(normal, First, u) || !hb_solve3(normal, Second, v)) {
        return 0.0F;
    }
    mean = 0.5F * (u[0] + v[1]);
    half = 0.5F * (u[0] - v[1]);
    return sqrtf(fmaxf(mean + sqrtf(half * half + u[1] * u[1]), 0.0F));
}

/* One Gauss-Newton step over rotation and strength, the strength eliminated. Returns shaftDeviation(). */
static float refine(const hb_tensor_system* system, const float x[HB_TENSOR_SIZE], float axis[3][3],
                    float* strength_T) {
    float turn[3][HB_TENSOR_SIZE];
    float weighted[3][HB_TENSOR_SIZE];
    float unit[HB_TENSOR_SIZE];
    float weighted_unit[HB_TENSOR_SIZE];
    float missing[HB_TENSOR_SIZE];
    float normal[3][3];
    float coupling[3];
    float right[3];
    float step[3];
    float own;
    float excess;
    turnRows(axis, turn);
    unitTensor(axis, unit);
    for (uint8_t i = 0; i < HB_TENSOR_SIZE; i++) {
        weighted_unit[i] = dotTensor(system->information[i], unit);
        missing[i] = dotTensor(system->information[i], x) - *strength_T * weighted_unit[i];
        for (uint8_t k = 0; k < 3; k++) {
            weighted[k][i] = *strength_T * dotTensor(system->information[i], turn[k]);
        }
    }
    own = dotTensor(unit, weighted_unit);
    excess = dotTensor(unit, missing);
    for (uint8_t k = 0; k < 3; k++) {
        coupling[k] = dotTensor(unit, weighted[k]);
        right[k] = *strength_T * dotTensor(turn[k], missing) - coupling[k] * (excess / own);
    }
    for (uint8_t k = 0; k < 3; k++) {
        for (uint8_t j = 0; j < 3; j++) {
            normal[k][j] = *strength_T * dotTensor(turn[k], weighted[j]) - coupling[k] * coupling[j] / own;
        }
    }
    if (hb_solve3((const float(*)[3])normal, right, step)) {
        *strength_T += (excess - hb_dot(coupling, step)) / own;
        hb_turn_own(axis, step);
    }
    return shaftDeviation((const float(*)[3])normal);
}

/* Shaft up, gamma within -90 ... 90 degrees. */
static void chooseImage(float axis[3][3]) {
    uint8_t flips_tail = axis[2][2] < 0.0F;
    uint8_t flips_head = axis[0][0] < 0.0F;
    for (uint8_t i = 0; i < 3; i++) {
        axis[0][i] = flips_head ? -axis[0][i] : axis[0][i];
        axis[1][i] = flips_tail != flips_head ? -axis[1][i] : axis[1][i];
        axis[2][i] = flips_tail ? -axis[2][i] : axis[2][i];
    }
}

static void publish(float axis[3][3], hb_orientation* result) {
    const float* u = axis[0];
    const float* v = axis[1];
    const float* p = axis[2];
    float phi = atan2f(p[1], p[0]);
    for (uint8_t i = 0; i < 3; i++) {
        for (uint8_t j = 0; j < 3; j++) {
            result->rotation[i][j] = axis[j][i];
        }
    }
    result->angle_rad[0] = atan2f(-p[1], p[2]);
    result->angle_rad[1] = atan2f(p[0], sqrtf(u[0] * u[0] + v[0] * v[0]));
    result->angle_rad[2] = atan2f(-v[0], u[0]);
    result->shaft_rad[0] = atan2f(sqrtf(p[0] * p[0] + p[1] * p[1]), p[2]);
    result->shaft_rad[1] = phi < 0.0F ? phi + TWO_PI : phi;
    hb_quaternion_of((const float(*)[3])result->rotation, result->quaternion);
}

static void solveTensor(const hb_tensor_system* system, const float field_T[HB_FIELD_CHANNELS],
                        float x[HB_TENSOR_SIZE]) {
    for (uint8_t i = 0; i < HB_TENSOR_SIZE; i++) {
        x[i] = 0.0F;
        for (uint8_t c = 0; c < HB_FIELD_CHANNELS; c++) {
            x[i] += system->solver[i][c] * field_T[c];
        }
    }
}

/* The readings without the harmonics of the rotor with these axes, whose strength scales them. */
static void subtractHarmonics(const hb_tensor_system* system, const hb_rotor_field* rotor, float axis[3][3],
                              float strength_T, const float corrected_T[HB_FIELD_CHANNELS],
                              float linear_T[HB_FIELD_CHANNELS]) {
    float scale = strength_T / rotor->strength_T;
    hb_harmonic_readings(rotor, system, axis, linear_T);
    for (uint8_t c = 0; c < HB_FIELD_CHANNELS; c++) {
        linear_T[c] = corrected_T[c] - scale * linear_T[c];
    }
}

uint8_t hb_channel_count(uint16_t channels) {
    uint8_t count = 0;
    for (; channels; channels >>= 1) {
        count = (uint8_t)(count + (channels & 1U));
    }
    return count;
}

/* Residuals of the linear fit, and their squares over the noise. */
static void test(const hb_tensor_system* system, const float linear_T[HB_FIELD_CHANNELS],
                 const float x[HB_TENSOR_SIZE], float deviation_T, hb_orientation* result) {
    result->chi_square = 0.0F;
    for (uint8_t c = 0; c < HB_FIELD_CHANNELS; c++) {
        float residual_T = ((system->used >> c) & 1U) ? linear_T[c] - dotTensor(system->design[c], x) : 0.0F;
        result->residual_T[c] = residual_T;
        result->chi_square += (residual_T / deviation_T) * (residual_T / deviation_T);
    }
}

/* Deviation of a reading that the cone has to hold. */
static float wholeDeviation(const hb_tensor_system* system, const hb_field_sensors* sensors,
                            float chi_square) {
    uint8_t channels = hb_channel_count(system->used);
    float noise = sensors->deviation_T * sensors->deviation_T;
    float known = noise + sensors->tolerance_T * sensors->tolerance_T;
    float seen = channels > HB_TENSOR_SIZE ? noise * chi_square / (float)(channels - HB_TENSOR_SIZE) : 0.0F;
    return sqrtf(fmaxf(known, seen));
}

uint8_t hb_orientation_solve(const hb_tensor_system* system, const hb_field_sensors* sensors,
                             const hb_rotor_field* rotor, const float corrected_T[HB_FIELD_CHANNELS],
                             hb_orientation* result) {
    uint8_t passes = hb_rotor_has_harmonics(rotor) ? HARMONIC_PASSES : 0U;
    float linear_T[HB_FIELD_CHANNELS];
    float x[HB_TENSOR_SIZE];
    float axis[3][3];
    float strength_T;
    float deviation;
    memcpy(linear_T, corrected_T, sizeof linear_T);
    solveTensor(system, linear_T, x);
    strength_T = HALF_ROOT * sqrtf(dotTensor(x, x));
    if (!system->is_determined || !(strength_T > LEAST_STRENGTH * rotor->strength_T)) {
        return 0;
    }
    projectorAxes(x, strength_T, axis);
    deviation = refine(system, x, axis, &strength_T);
    for (uint8_t pass = 0; pass < passes; pass++) {
        subtractHarmonics(system, rotor, axis, strength_T, corrected_T, linear_T);
        solveTensor(system, linear_T, x);
        strength_T = HALF_ROOT * sqrtf(dotTensor(x, x));
        projectorAxes(x, strength_T, axis);
        deviation = refine(system, x, axis, &strength_T);
    }
    chooseImage(axis);
    publish(axis, result);
    result->strength_T = strength_T;
    test(system, linear_T, x, sensors->deviation_T, result);
    result->cone95_rad = CONE95 * wholeDeviation(system, sensors, result->chi_square) * deviation;
    return 1;
}
