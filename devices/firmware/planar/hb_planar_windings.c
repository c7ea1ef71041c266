/* SPDX-License-Identifier: MIT */
#include "devices/firmware/planar/hb_planar_windings.h"

#include "devices/firmware/control/hb_constants.h"
#include "devices/firmware/control/hb_trig.h"

#include <math.h>
#include <string.h>

enum { TERMS = 4 };
#define TABLE_LIMIT_RAD 0.05F
#define LEAST_DETERMINANT 1.0e-5F

/* C_n G_n over C_1 G_across,1(0) for the published winding (12 x 13 turns, 3.025 mm above the magnets), in
 * powers of (phi/50 mrad)^2; Gauss quadrature over all turns, error below 1e-11. */
typedef struct {
    float along[TERMS], across[TERMS];
} winding_shape;

static const winding_shape Shapes[HB_WINDING_ORDERS] = {
    {{-2.15584179e-3F, 1.96855214e-3F, 2.70641634e-8F, -2.77338838e-9F},
     {1.0F, -2.86614012e-3F, 2.72750665e-6F, 3.62317967e-10F}},
    {{2.83002566e-5F, -2.08936103e-5F, 5.3278648e-7F, -3.0818845e-9F},
     {-1.95601121e-3F, 2.09155842e-4F, -6.605621e-6F, 9.44817625e-8F}},
    {{-7.44319575e-7F, 3.12104041e-8F, -1.15707427e-8F, 5.17323129e-10F},
     {-7.06443527e-6F, 1.61636455e-7F, 1.7041688e-7F, -1.4744259e-8F}},
};

/* Value and slope by the heading. */
static void shapeAt(const float terms[TERMS], float phi_rad, float* value, float* slope) {
    float u = phi_rad / TABLE_LIMIT_RAD;
    float square = u * u;
    *value = terms[0] + square * (terms[1] + square * (terms[2] + square * terms[3]));
    *slope = 2.0F * u / TABLE_LIMIT_RAD * (terms[1] + square * (2.0F * terms[2] + 3.0F * square * terms[3]));
}

/* Centres in platen axes: coils 1 to 4 along x', 5 and 6 along y'; the second of a pair stands 3L/4 further.
 */
static void centreOf(const hb_planar_coils* coils, uint8_t coil, float* x_m, float* y_m) {
    float arm_m = 0.75F * coils->pitch_m;
    float upper_m = coils->arm56_m - coils->pitch_m;
    if (coil < 4U) {
        *x_m = coil < 2U ? -arm_m : arm_m;
        *y_m = coil == 0U || coil == 3U ? upper_m : upper_m - arm_m;
    } else {
        *x_m = coils->coil_width_m - arm_m + (coil == 4U ? 1.25F * coils->pitch_m : 0.0F);
        *y_m = coils->arm56_m;
    }
}

/* c and s: cosine and sine of the rotation. */
static void addOrder(const hb_planar_coils* coils, const hb_pose* pose, float c, float s, uint8_t order,
                     uint8_t coil, hb_coil_wrench* forces) {
    float heading = fminf(fmaxf(pose->phi_rad, -TABLE_LIMIT_RAD), TABLE_LIMIT_RAD);
    float wave_1_m = HB_TWO_PI / coils->pitch_m;
    float g = wave_1_m * (float)(4U * order + 1U);
    /* Linkage of one ampere at the largest: the positive sense is counter-clockwise, of 5 and 6 clockwise. */
    float scale = (coil < 4U ? -1.0F : 1.0F) * coils->force_constant_N_per_A / wave_1_m;
    uint8_t is_across = coil >= 4U;
    float x_m;
    float y_m;
    float along;
    float along_slope;
    float across;
    float across_slope;
    float arm_x;
    float arm_y;
    float force_x;
    float force_y;
    float sine_x;
    float cosine_x;
    float sine_y;
    float cosine_y;
    centreOf(coils, coil, &x_m, &y_m);
    shapeAt(Shapes[order].along, heading, &along, &along_slope);
    shapeAt(Shapes[order].across, heading, &across, &across_slope);
    arm_x = c * x_m - s * y_m;
    arm_y = s * x_m + c * y_m;
    hb_sine_cosine(g * (pose->x_m + arm_x), &sine_x, &cosine_x);
    hb_sine_cosine(g * (pose->y_m + arm_y), &sine_y, &cosine_y);
    force_x = -scale * g * sine_x * (is_across ? across : along);
    force_y = -scale * g * sine_y * (is_across ? along : across);
    forces->row[0][coil] += force_x;
    forces->row[1][coil] += force_y;
    forces->row[2][coil] += arm_x * force_y - arm_y * force_x +
                            scale * (cosine_x * (is_across ? across_slope : along_slope) +
                                     cosine_y * (is_across ? along_slope : across_slope));
}

hb_coil_wrench hb_planar_windings(const hb_planar_coils* coils, const hb_pose* pose, uint8_t orders) {
    hb_coil_wrench forces;
    float c;
    float s;
    hb_sine_cosine(pose->phi_rad, &s, &c);
    memset(&forces, 0, sizeof forces);
    for (uint8_t coil = 0; coil < HB_COILS; coil++) {
        for (uint8_t order = 0; order < orders && order < HB_WINDING_ORDERS; order++) {
            addOrder(coils, pose, c, s, order, coil, &forces);
        }
    }
    return forces;
}

uint8_t hb_planar_least_norm(const hb_coil_wrench* forces, const hb_wrench* wrench,
                             float current_A[HB_COILS]) {
    const float w[3] = {wrench->x_N, wrench->y_N, wrench->torque_Nm / HB_POSE_LEVER_M};
    float gram[3][3];
    float trace = 0.0F;
    float determinant = 0.0F;
    float share[3] = {0.0F, 0.0F, 0.0F};
    for (uint8_t i = 0; i < 3U; i++) {
        for (uint8_t j = 0; j < 3U; j++) {
            float scale =
                (i == 2U ? 1.0F / HB_POSE_LEVER_M : 1.0F) * (j == 2U ? 1.0F / HB_POSE_LEVER_M : 1.0F);
            gram[i][j] = 0.0F;
            for (uint8_t k = 0; k < HB_COILS; k++) {
                gram[i][j] += scale * forces->row[i][k] * forces->row[j][k];
            }
        }
        trace += gram[i][i];
    }
    for (uint8_t i = 0; i < 3U; i++) {
        uint8_t i1 = (uint8_t)((i + 1U) % 3U);
        uint8_t i2 = (uint8_t)((i + 2U) % 3U);
        for (uint8_t j = 0; j < 3U; j++) {
            uint8_t j1 = (uint8_t)((j + 1U) % 3U);
            uint8_t j2 = (uint8_t)((j + 2U) % 3U);
            float cofactor = gram[i1][j1] * gram[i2][j2] - gram[i1][j2] * gram[i2][j1];
            share[i] += cofactor * w[j];
            if (i == 0U) {
                determinant += gram[0][j] * cofactor;
            }
        }
    }
    memset(current_A, 0, HB_COILS * sizeof(float));
    /* Also false for what is not a number. */
    if (!(determinant > LEAST_DETERMINANT * trace * trace * trace)) {
        return 0;
    }
    for (uint8_t k = 0; k < HB_COILS; k++) {
        for (uint8_t i = 0; i < 3U; i++) {
            float scale = i == 2U ? 1.0F / HB_POSE_LEVER_M : 1.0F;
            current_A[k] += scale * forces->row[i][k] * share[i] / determinant;
        }
    }
    return 1;
}
