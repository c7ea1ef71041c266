/* SPDX-License-Identifier: MIT */
#ifndef HB_PLANAR_POSE_H
#define HB_PLANAR_POSE_H

/* Pose of the platen from three two-axis Hall chips over the magnet matrix (resources/help/planar-theory.md
 * section 7). A point r' of the platen lies at (x, y) + R(phi) r' in the lattice; chip j at (X_j, Y_j) sees
 *
 *   Bx' = b_j (sin gX_j cos phi + sin gY_j sin phi),  By' = b_j (-sin gX_j sin phi + sin gY_j cos phi).
 *
 * Fields in the order Bx'1, By'1, Bx'2, ... By'3, T. */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HB_CHIPS = 3, HB_CHIP_FIELDS = 2 * HB_CHIPS, HB_COILS = 6, HB_ALL_CHIPS = 7 };
/* Angles times this are lengths. */
#define HB_POSE_LEVER_M 0.05F

typedef struct {
    float x_m, y_m, phi_rad;
} hb_pose;

/* What is known of the chips; in the order of the calibration. Reading of the pair (x', y') of chip j =
 * (1 + gain) B + cross B of the other axis + offset + crosstalk times the coil currents. */
typedef struct {
    float amplitude_T[HB_CHIPS];
    float place_x_m[HB_CHIPS], place_y_m[HB_CHIPS]; /* in platen axes */
    float gain_x[HB_CHIPS], gain_y[HB_CHIPS];       /* errors, 0 = perfect */
    float cross_xy[HB_CHIPS];                       /* share of B_y' in the reading of x' */
    float cross_yx[HB_CHIPS];
    float offset_x_T[HB_CHIPS], offset_y_T[HB_CHIPS];
    float crosstalk_T_per_A[HB_CHIP_FIELDS * HB_COILS]; /* row after row, by fields */
    float deviation_T; /* of a reading from the model: noise and what calibration leaves */
} hb_chips;

typedef struct {
    hb_pose pose;
    float chi_square; /* sum of squared residuals over their deviation */
    uint8_t is_determined;
} hb_pose_estimate;

enum hb_chip_verdict {
    HB_CHIPS_AGREE,     /* all used */
    HB_CHIP_LEFT_OUT,   /* one contradicts the two others, which determine the pose */
    HB_CHIPS_CONTRADICT /* no pose near the predicted one, or more than one chip could be wrong */
};

typedef struct {
    hb_pose_estimate estimate;
    uint8_t verdict;
    uint8_t used; /* bit j: chip j */
} hb_checked_pose;

/* What a chip should see at a pose, and the derivative by x, y (T/m) and phi (T/rad). */
typedef struct {
    float field_T[2];
    float slope[2][3];
} hb_chip_model;
hb_chip_model hb_chip_model_at(const hb_chips* chips, float pitch_m, const hb_pose* pose, uint8_t chip);

/* The fields behind the readings, in place. */
void hb_chips_correct(const hb_chips* chips, float field_T[HB_CHIP_FIELDS], const float current_A[HB_COILS]);

/* Pose modulo the pitch for small rotations in closed form, by linear least squares of
 * Bx'_j/b_j = sin(g x) cos(g x'_j) + cos(g x) sin(g x'_j), likewise in y. 0 where the chips in use have no
 * quadrature. */
uint8_t hb_pose_start(const hb_chips* chips, float pitch_m, const float field_T[HB_CHIP_FIELDS], uint8_t used,
                      hb_pose* pose);

/* Least squares for (x, y, phi) by Gauss-Newton from `start` (within a fifth of a pitch and 0.2 rad). Not
 * determined: no pose near the start, or a direction with less than 1 % of the information of one reading. */
hb_pose_estimate hb_pose_fit(const hb_chips* chips, float pitch_m, const float field_T[HB_CHIP_FIELDS],
                             const hb_pose* start, uint8_t used);

/* From all trusted chips; when they contradict each other, from each two that determine the pose. Chi-square
 * above 45 (three chips) or 37.3 (two) contradicts: 1e-9 of healthy readings do. A pose farther than
 * `jump_m` (angle times 50 mm) from the predicted one is not believed. */
hb_checked_pose hb_pose_check(const hb_chips* chips, float pitch_m, const float field_T[HB_CHIP_FIELDS],
                              const hb_pose* predicted, uint8_t trusted, float jump_m);

#ifdef __cplusplus
}
#endif

#endif
