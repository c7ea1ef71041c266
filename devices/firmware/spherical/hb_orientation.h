/* SPDX-License-Identifier: MIT */
#ifndef HB_ORIENTATION_H
#define HB_ORIENTATION_H

/* Orientation of a rotor with a frozen four-pole field from nine field readings, in single precision and
 * without a start value (resources/help/spherical-theory.md section 5.1). Outside the rotor, in stator axes,
 *
 *   B(r n) = (r_ref/r)^4 (5 (n.Q n) n - 2 Q n),  Q = q (u u^T - v v^T),
 *
 * u, v the first two columns of the rotation matrix M (rotor to stator). Q has five coordinates in an
 * orthonormal basis; nine readings determine them by least squares, its eigenvectors are the columns of M. */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HB_FIELD_SENSORS = 3, HB_FIELD_CHANNELS = 9, HB_TENSOR_SIZE = 5, HB_FIELD_HARMONICS = 4 };

/* Sensor frames: S = Rz Ry Rx, Rx Ry Rz, or that of zyx without a roll about the radius. */
enum hb_sensor_frames { HB_FRAMES_ZYX, HB_FRAMES_XYZ, HB_FRAMES_NATURAL };

/* What is known of the sensors, in the order of the calibration; channels R, Theta, Phi of sensor 0, then 1,
 * then 2. Reading = (I + K) diag(gain) axes^T B + offset + coil I, K symmetric with the entries `skew`. */
typedef struct {
    float alpha_rad[HB_FIELD_SENSORS], beta_rad[HB_FIELD_SENSORS],
        gamma_rad[HB_FIELD_SENSORS];   /* placement */
    float turn_rad[HB_FIELD_CHANNELS]; /* mounting error: rotation vector of each sensor in stator axes */
    float radius_m[HB_FIELD_SENSORS];
    float gain[HB_FIELD_CHANNELS]; /* errors, 0 = perfect */
    float skew[HB_FIELD_CHANNELS]; /* (R, Theta), (R, Phi), (Theta, Phi) of each sensor */
    float offset_T[HB_FIELD_CHANNELS];
    float coil_T_per_A[HB_FIELD_CHANNELS];
    float deviation_T; /* noise of a reading */
    float tolerance_T; /* deviation that errors of this calibration leave in a reading */
} hb_field_sensors;

/* Field of the rotor at 50 mm: strength q of the tensor, amplitudes of the harmonics (4,2), (6,2), (6,6) and
 * (10,10). */
typedef struct {
    float strength_T;
    float harmonic_T[HB_FIELD_HARMONICS];
} hb_rotor_field;

/* The least-squares problem, prepared for sensors and channels in use. */
typedef struct {
    float correction[HB_FIELD_SENSORS][3][3]; /* ((I + K) diag(gain))^-1 */
    float place[HB_FIELD_SENSORS][3];         /* unit vectors from the centre */
    float axis[HB_FIELD_CHANNELS][3];         /* of the channels, stator axes */
    float fall[HB_FIELD_SENSORS];             /* 50 mm over the distance from the centre */
    float design[HB_FIELD_CHANNELS][HB_TENSOR_SIZE];
    float information[HB_TENSOR_SIZE][HB_TENSOR_SIZE]; /* design^T design of the channels in use */
    float solver[HB_TENSOR_SIZE][HB_FIELD_CHANNELS];
    uint16_t used;         /* bit i: channel i */
    uint8_t is_determined; /* smallest singular value of the design at least 0.05 */
} hb_tensor_system;

typedef struct {
    float rotation[3][3]; /* M */
    float quaternion[4];  /* w, x, y, z; w >= 0 */
    float angle_rad[3];   /* alpha, beta, gamma: M = Rx(alpha) Ry(beta) Rz(gamma) */
    float shaft_rad[2];   /* Theta from +Z, Phi from +X in 0 ... 2 pi */
    float cone95_rad;     /* half-angle about the shaft that holds it with at least 95 % */
    float strength_T;     /* q at the reference radius */
    float chi_square;     /* of the linear fit, 4 degrees of freedom with all channels */
    float residual_T[HB_FIELD_CHANNELS];
} hb_orientation;

/* Bits that are set. */
uint8_t hb_channel_count(uint16_t channels);

/* 0 when the sensors' errors cannot be undone or the channels do not determine the field. */
uint8_t hb_tensor_prepare(hb_tensor_system* system, const hb_field_sensors* sensors, uint8_t frames,
                          uint16_t used);

/* What ideal sensors would read, in place; a channel that is not in use counts as 0. */
void hb_field_correct(const hb_tensor_system* system, const hb_field_sensors* sensors, float current_A,
                      float reading_T[HB_FIELD_CHANNELS]);

/* Projectors, then one Gauss-Newton step over rotation and strength; with harmonics these are predicted and
 * subtracted, and the same is done again, three times. Of the four orientations with the same field the one
 * with the shaft up and gamma in -90 ... 90 degrees. The cone holds noise, the tolerance of the calibration
 * and, when chi-square shows more than both explain, that instead. 0, and nothing changed, when the system is
 * not determined or the field is weaker than a twentieth of the calibrated one. */
uint8_t hb_orientation_solve(const hb_tensor_system* system, const hb_field_sensors* sensors,
                             const hb_rotor_field* rotor, const float corrected_T[HB_FIELD_CHANNELS],
                             hb_orientation* result);

#ifdef __cplusplus
}
#endif

#endif
