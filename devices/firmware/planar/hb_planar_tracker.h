/* SPDX-License-Identifier: MIT */
#ifndef HB_PLANAR_TRACKER_H
#define HB_PLANAR_TRACKER_H

/* Tracking filter of the platen (resources/help/planar-theory.md section 7): pose, speed and disturbance
 * acceleration of x, y, phi under the known acceleration u = wrench/inertia of the currents that flow,
 *
 *   q' = q + T v + (T^2/2)(u + d),  v' = v + T (u + d),  d' = d.
 *
 * White acceleration of 0.05 m/s^2 and 1 rad/s^2 per sample, random walk of the disturbance of 3 m/s^2 and
 * 60 rad/s^2 per square root of a second. The readings of a tick are taken one after the other, linearised
 * at the predicted pose, which for independent noise is the joint update. */

#include "devices/firmware/planar/hb_planar_pose.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { HB_TRACKER_STATES = 9 }; /* poses, speeds, disturbances, each x, y, phi */

typedef struct {
    float mean[HB_TRACKER_STATES];
    float covariance[HB_TRACKER_STATES][HB_TRACKER_STATES];
    uint8_t is_started;
} hb_tracker;

/* At rest at this pose, known as well as one reading tells; speed and disturbance are open. */
void hb_tracker_start(hb_tracker* tracker, const hb_pose* pose, float deviation_m);

/* One period of T = HB_TICK_MS. */
void hb_tracker_predict(hb_tracker* tracker, const float acceleration[3]);

/* The corrected fields of the chips in use. Returns innovation^T S^-1 innovation: chi-square with as many
 * degrees of freedom as readings. */
float hb_tracker_update(hb_tracker* tracker, const hb_chips* chips, float pitch_m,
                        const float field_T[HB_CHIP_FIELDS], uint8_t used);

#ifdef __cplusplus
}
#endif

#endif
