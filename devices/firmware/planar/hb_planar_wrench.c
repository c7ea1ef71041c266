/* SPDX-License-Identifier: MIT */
#include "devices/firmware/planar/hb_planar_wrench.h"

#include "devices/firmware/control/hb_constants.h"

#include <math.h>

typedef struct {
    float cos_psi, sin_psi, cos_chi, sin_chi;
} phases;

static phases phasesAt(const hb_planar_coils* coils, const hb_pose* pose) {
    float wave_1_m = HB_TWO_PI / coils->pitch_m;
    float psi = wave_1_m * (pose->y_m + coils->arm56_m - 1.25F * coils->pitch_m);
    float chi = wave_1_m * (pose->x_m + coils->coil_width_m - 1.25F * coils->pitch_m);
    phases result;
    result.cos_psi = cosf(psi);
    result.sin_psi = sinf(psi);
    result.cos_chi = cosf(chi);
    result.sin_chi = sinf(chi);
    return result;
}

void hb_planar_allocate(const hb_planar_coils* coils, const hb_pose* pose, const hb_wrench* wrench,
                        float current_A[HB_COILS]) {
    phases p = phasesAt(coils, pose);
    float turning_N = (wrench->torque_Nm + coils->arm56_m * wrench->x_N) / (1.5F * coils->pitch_m);
    float f12 = (0.5F * wrench->y_N - turning_N) / coils->force_constant_N_per_A;
    float f34 = (0.5F * wrench->y_N + turning_N) / coils->force_constant_N_per_A;
    float f56 = wrench->x_N / coils->force_constant_N_per_A;
    current_A[0] = f12 * p.cos_psi;
    current_A[1] = -f12 * p.sin_psi;
    current_A[2] = -f34 * p.sin_psi;
    current_A[3] = f34 * p.cos_psi;
    current_A[4] = f56 * p.cos_chi;
    current_A[5] = f56 * p.sin_chi;
}

hb_wrench hb_planar_wrench(const hb_planar_coils* coils, const hb_pose* pose,
                           const float current_A[HB_COILS]) {
    phases p = phasesAt(coils, pose);
    float b = coils->force_constant_N_per_A;
    hb_wrench wrench;
    wrench.x_N = b * (current_A[4] * p.cos_chi + current_A[5] * p.sin_chi);
    wrench.y_N = b * ((current_A[0] + current_A[3]) * p.cos_psi - (current_A[1] + current_A[2]) * p.sin_psi);
    wrench.torque_Nm =
        0.75F * coils->pitch_m * b *
            ((current_A[3] - current_A[0]) * p.cos_psi + (current_A[1] - current_A[2]) * p.sin_psi) -
        coils->arm56_m * wrench.x_N;
    return wrench;
}

float hb_planar_lift_N(const hb_planar_coils* coils, const hb_pose* pose, const float current_A[HB_COILS]) {
    phases p = phasesAt(coils, pose);
    return -coils->force_constant_N_per_A *
           ((current_A[0] + current_A[3]) * p.sin_psi + (current_A[1] + current_A[2]) * p.cos_psi +
            current_A[4] * p.sin_chi - current_A[5] * p.cos_chi);
}

float hb_planar_limit(float current_A[HB_COILS], float limit_A) {
    float largest_A = 0.0F;
    float scale = 1.0F;
    for (uint8_t k = 0; k < HB_COILS; k++) {
        largest_A = fmaxf(largest_A, fabsf(current_A[k]));
    }
    if (largest_A > limit_A) {
        scale = limit_A / largest_A;
        for (uint8_t k = 0; k < HB_COILS; k++) {
            current_A[k] *= scale;
        }
    }
    return scale;
}
