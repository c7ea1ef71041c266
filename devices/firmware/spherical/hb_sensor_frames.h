/* SPDX-License-Identifier: MIT */
#ifndef HB_SENSOR_FRAMES_H
#define HB_SENSOR_FRAMES_H

/* Places and axes of the field sensors, and rotations in three dimensions. */

#include "devices/firmware/spherical/hb_orientation.h"

#ifdef __cplusplus
extern "C" {
#endif

#define HB_REFERENCE_RADIUS_M 0.05F

typedef struct {
    float place[3];   /* unit vector from the centre */
    float axis[3][3]; /* e_R, e_Theta, e_Phi, stator axes */
} hb_sensor_frame;

/* Place S e_x, axes S e_x, -S e_z, S e_y, these turned by the mounting error. */
hb_sensor_frame hb_sensor_frame_of(const hb_field_sensors* sensors, uint8_t sensor, uint8_t frames);

/* ((I + K) diag(1 + gain))^-1; 0 when there is none. */
uint8_t hb_sensor_correction(const hb_field_sensors* sensors, uint8_t sensor, float correction[3][3]);

float hb_dot(const float a[3], const float b[3]);
void hb_cross(const float a[3], const float b[3], float product[3]);
/* x of matrix x = right; 0 when the matrix is singular. */
uint8_t hb_solve3(const float matrix[3][3], const float right[3], float x[3]);
/* Turns three orthonormal axes by a rotation vector given in these axes: M <- M exp([w]x). */
void hb_turn_own(float axis[3][3], const float turn_rad[3]);
/* w, x, y, z with w >= 0 */
void hb_quaternion_of(const float rotation[3][3], float quaternion[4]);

#ifdef __cplusplus
}
#endif

#endif
