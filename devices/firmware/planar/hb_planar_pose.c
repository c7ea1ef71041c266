/* SPDX-License-Identifier: MIT */
#include "devices/firmware/planar/hb_planar_pose.h"

#include "devices/firmware/control/hb_constants.h"
#include "devices/firmware/control/hb_trig.h"

#include <math.h>
#include <string.h>

#define LEAST_INFORMATION 0.01F
#define LIMIT_OF_THREE 45.0F
#define LIMIT_OF_TWO 37.3F
#define REACH_M 0.02F
/* After a step of this size the pose and its residuals stay within single precision. */
#define LAST_STEP_M 1.0e-7F
enum { ITERATIONS = 12 };

typedef struct {
    float matrix[3][3], right[3];
    float square_T2; /* of the residuals */
} normal_equations;

static uint8_t isUsed(uint8_t used, uint8_t chip) {
    return (uint8_t)(((unsigned int)used >> chip) & 1U);
}

static uint8_t countOf(uint8_t used) {
    return (uint8_t)(isUsed(used, 0) + isUsed(used, 1) + isUsed(used, 2));
}

void hb_chips_correct(const hb_chips* chips, float field_T[HB_CHIP_FIELDS], const float current_A[HB_COILS]) {
    for (uint8_t j = 0; j < HB_CHIPS; j++) {
        float a = 1.0F + chips->gain_x[j];
        float d = 1.0F + chips->gain_y[j];
        float b = chips->cross_xy[j];
        float c = chips->cross_yx[j];
        float x = field_T[2 * j] - chips->offset_x_T[j];
        float y = field_T[2 * j + 1] - chips->offset_y_T[j];
        for (uint8_t k = 0; k < HB_COILS; k++) {
            x -= chips->crosstalk_T_per_A[2 * j * HB_COILS + k] * current_A[k];
            y -= chips->crosstalk_T_per_A[(2 * j + 1) * HB_COILS + k] * current_A[k];
        }
        field_T[2 * j] = (d * x - b * y) / (a * d - b * c);
        field_T[2 * j + 1] = (a * y - c * x) / (a * d - b * c);
    }
}

/* Phase of one axis from sin(p) cos(q_j) + cos(p) sin(q_j) = value_j. */
static uint8_t phaseOf(const float value[HB_CHIPS], const float phase_rad[HB_CHIPS], uint8_t used,
                       float* result_rad) {
    float ss = 0.0F;
    float sc = 0.0F;
    float cc = 0.0F;
    float right_s = 0.0F;
    float right_c = 0.0F;
    float determinant;
    for (uint8_t j = 0; j < HB_CHIPS; j++) {
        if (isUsed(used, j)) {
            float c;
            float s;
            hb_sine_cosine(phase_rad[j], &s, &c);
            ss += c * c;
            sc += c * s;
            cc += s * s;
            right_s += c * value[j];
            right_c += s * value[j];
        }
    }
    determinant = ss * cc - sc * sc;
    *result_rad = atan2f(cc * right_s - sc * right_c, ss * right_c - sc * right_s);
    return determinant >= LEAST_INFORMATION;
}

uint8_t hb_pose_start(const hb_chips* chips, float pitch_m, const float field_T[HB_CHIP_FIELDS], uint8_t used,
                      hb_pose* pose) {
    float wave_1_m = HB_TWO_PI / pitch_m;
    float value[2][HB_CHIPS];
    float phase[2][HB_CHIPS];
    float x_rad;
    float y_rad;
    uint8_t has_both;
    for (uint8_t j = 0; j < HB_CHIPS; j++) {
        value[0][j] = field_T[2 * j] / chips->amplitude_T[j];
        value[1][j] = field_T[2 * j + 1] / chips->amplitude_T[j];
        phase[0][j] = wave_1_m * chips->place_x_m[j];
        phase[1][j] = wave_1_m * chips->place_y_m[j];
    }
    has_both = phaseOf(value[0], phase[0], used, &x_rad);
    has_both &= phaseOf(value[1], phase[1], used, &y_rad);
    pose->x_m = x_rad / wave_1_m;
    pose->y_m = y_rad / wave_1_m;
    pose->phi_rad = 0.0F;
    return has_both;
}

/* Sine and cosine of the rotation are the same for all chips. */
typedef struct {
    float c, s;
} heading;

static heading headingOf(const hb_pose* pose) {
    heading turned;
    hb_sine_cosine(pose->phi_rad, &turned.s, &turned.c);
    return turned;
}

static hb_chip_model modelAt(const hb_chips* chips, float pitch_m, const hb_pose* pose, const heading* turned,
                             uint8_t chip) {
    float wave_1_m = HB_TWO_PI / pitch_m;
    float c = turned->c;
    float s = turned->s;
    float amplitude_T = chips->amplitude_T[chip];
    float arm_x = c * chips->place_x_m[chip] - s * chips->place_y_m[chip];
    float arm_y = s * chips->place_x_m[chip] + c * chips->place_y_m[chip];
    float phase_x = wave_1_m * (pose->x_m + arm_x);
    float phase_y = wave_1_m * (pose->y_m + arm_y);
    hb_chip_model model;
    float bx;
    float by;
    float slope_x;
    float slope_y;
    hb_sine_cosine(phase_x, &bx, &slope_x);
    hb_sine_cosine(phase_y, &by, &slope_y);
    bx *= amplitude_T;
    by *= amplitude_T;
    slope_x *= wave_1_m * amplitude_T;
    slope_y *= wave_1_m * amplitude_T;
    model.field_T[0] = bx * c + by * s;
    model.field_T[1] = by * c - bx * s;
    model.slope[0][0] = slope_x * c;
    model.slope[0][1] = slope_y * s;
    model.slope[0][2] = slope_y * arm_x * s - slope_x * arm_y * c + model.field_T[1];
    model.slope[1][0] = -slope_x * s;
    model.slope[1][1] = slope_y * c;
    model.slope[1][2] = slope_x * arm_y * s + slope_y * arm_x * c - model.field_T[0];
    return model;
}

hb_chip_model hb_chip_model_at(const hb_chips* chips, float pitch_m, const hb_pose* pose, uint8_t chip) {
    heading turned = headingOf(pose);
    return modelAt(chips, pitch_m, pose, &turned, chip);
}

/* Adds one chip; the angle counts as a length. */
static void addChip(const hb_chips* chips, float pitch_m, const float field_T[HB_CHIP_FIELDS],
                    const hb_pose* pose, const heading* turned, uint8_t chip, normal_equations* normal) {
    hb_chip_model model = modelAt(chips, pitch_m, pose, turned, chip);
    model.slope[0][2] /= HB_POSE_LEVER_M;
    model.slope[1][2] /= HB_POSE_LEVER_M;
    for (uint8_t axis = 0; axis < 2; axis++) {
        float residual = field_T[2 * chip + axis] - model.field_T[axis];
        normal->square_T2 += residual * residual;
        for (uint8_t i = 0; i < 3; i++) {
            normal->right[i] += model.slope[axis][i] * residual;
            for (uint8_t k = 0; k < 3; k++) {
                normal->matrix[i][k] += model.slope[axis][i] * model.slope[axis][k];
            }
        }
    }
}

static float minorOf(float matrix[3][3], uint8_t i, uint8_t k) {
    uint8_t i1 = (uint8_t)((i + 1) % 3);
    uint8_t i2 = (uint8_t)((i + 2) % 3);
    uint8_t k1 = (uint8_t)((k + 1) % 3);
    uint8_t k2 = (uint8_t)((k + 2) % 3);
    return matrix[i1][k1] * matrix[i2][k2] - matrix[i1][k2] * matrix[i2][k1];
}

/* Solves by cofactors; returns a lower bound of the smallest eigenvalue, det (2/(trace))^2, since the product
 * of the two larger ones is at most a quarter of the squared trace. */
static float solve(normal_equations* normal, float step[3]) {
    float cofactor[3][3];
    float determinant = 0.0F;
    float trace = 0.0F;
    for (uint8_t i = 0; i < 3; i++) {
        for (uint8_t k = 0; k < 3; k++) {
            cofactor[i][k] = minorOf(normal->matrix, i, k);
        }
        determinant += normal->matrix[0][i] * cofactor[0][i];
        trace += normal->matrix[i][i];
    }
    for (uint8_t i = 0; i < 3; i++) {
        step[i] = 0.0F;
        for (uint8_t k = 0; k < 3; k++) {
            step[i] += cofactor[i][k] * normal->right[k] / determinant;
        }
    }
    return 4.0F * determinant / (trace * trace);
}

static float distance_m(const hb_pose* a, const hb_pose* b) {
    float x = a->x_m - b->x_m;
    float y = a->y_m - b->y_m;
    float turned = HB_POSE_LEVER_M * (a->phi_rad - b->phi_rad);
    return sqrtf(x * x + y * y + turned * turned);
}

static float largestAmplitude_T(const hb_chips* chips) {
    return fmaxf(chips->amplitude_T[0], fmaxf(chips->amplitude_T[1], chips->amplitude_T[2]));
}

hb_pose_estimate hb_pose_fit(const hb_chips* chips, float pitch_m, const float field_T[HB_CHIP_FIELDS],
                             const hb_pose* start, uint8_t used) {
    float slope = HB_TWO_PI / pitch_m * largestAmplitude_T(chips);
    hb_pose_estimate estimate;
    estimate.pose = *start;
    estimate.chi_square = 0.0F;
    estimate.is_determined = 0;
    for (uint8_t i = 0; i < ITERATIONS && countOf(used) > 1; i++) {
        heading turned = headingOf(&estimate.pose);
        normal_equations normal;
        float step[3];
        float information;
        memset(&normal, 0, sizeof normal);
        for (uint8_t j = 0; j < HB_CHIPS; j++) {
            if (isUsed(used, j)) {
                addChip(chips, pitch_m, field_T, &estimate.pose, &turned, j, &normal);
            }
        }
        estimate.chi_square = normal.square_T2 / (chips->deviation_T * chips->deviation_T);
        information = solve(&normal, step);
        /* Also false for what is not a number. */
        if (!(information >= LEAST_INFORMATION * slope * slope)) {
            return estimate;
        }
        estimate.pose.x_m += step[0];
        estimate.pose.y_m += step[1];
        estimate.pose.phi_rad += step[2] / HB_POSE_LEVER_M;
        if (!(distance_m(&estimate.pose, start) <= REACH_M)) {
            return estimate;
        }
        if (step[0] * step[0] + step[1] * step[1] + step[2] * step[2] <= LAST_STEP_M * LAST_STEP_M) {
            estimate.is_determined = 1;
            return estimate;
        }
    }
    return estimate;
}

static uint8_t isBelieved(const hb_pose_estimate* estimate, uint8_t used, const hb_pose* predicted,
                          float jump_m) {
    float limit = used == HB_ALL_CHIPS ? LIMIT_OF_THREE : LIMIT_OF_TWO;
    return estimate->is_determined && estimate->chi_square <= limit &&
           distance_m(&estimate->pose, predicted) <= jump_m;
}

hb_checked_pose hb_pose_check(const hb_chips* chips, float pitch_m, const float field_T[HB_CHIP_FIELDS],
                              const hb_pose* predicted, uint8_t trusted, float jump_m) {
    hb_checked_pose result;
    uint8_t candidates = 0;
    result.used = trusted;
    result.estimate = hb_pose_fit(chips, pitch_m, field_T, predicted, trusted);
    if (isBelieved(&result.estimate, trusted, predicted, jump_m)) {
        result.verdict = trusted == HB_ALL_CHIPS ? HB_CHIPS_AGREE : HB_CHIP_LEFT_OUT;
        return result;
    }
    result.verdict = HB_CHIPS_CONTRADICT;
    for (uint8_t j = 0; j < HB_CHIPS && trusted == HB_ALL_CHIPS; j++) {
        uint8_t used = (uint8_t)(HB_ALL_CHIPS & ~(1U << j));
        hb_pose_estimate estimate = hb_pose_fit(chips, pitch_m, field_T, predicted, used);
        if (isBelieved(&estimate, used, predicted, jump_m)) {
            candidates++;
            result.estimate = estimate;
            result.used = used;
        }
    }
    if (candidates == 1) {
        result.verdict = HB_CHIP_LEFT_OUT;
    } else if (candidates > 1) {
        result.used = HB_ALL_CHIPS;
    }
    return result;
}
