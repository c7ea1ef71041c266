/* SPDX-License-Identifier: MIT */
#include "devices/firmware/planar/hb_planar_tracker.h"

#include "devices/firmware/xcp/hb_config.h"

#include <string.h>

#define TICK_S (0.001F * HB_TICK_MS)
/* Nothing is known of the motion at the start. */
#define OPEN_M_S 0.2F
#define OPEN_RAD_S 2.0F

enum { AXES = 3, SPEED = AXES, DISTURBANCE = 2 * AXES };

static const float White[AXES] = {0.05F, 0.05F, 1.0F}; /* m/s^2, rad/s^2 per sample */
static const float Walk[AXES] = {3.0F, 3.0F, 60.0F};   /* per square root of a second */

static float squared(float value) {
    return value * value;
}

void hb_tracker_start(hb_tracker* tracker, const hb_pose* pose, float deviation_m) {
    memset(tracker, 0, sizeof *tracker);
    tracker->mean[0] = pose->x_m;
    tracker->mean[1] = pose->y_m;
    tracker->mean[2] = pose->phi_rad;
    for (uint8_t i = 0; i < AXES; i++) {
        float lever = i == 2U ? HB_POSE_LEVER_M : 1.0F;
        tracker->covariance[i][i] = squared(deviation_m / lever);
        tracker->covariance[SPEED + i][SPEED + i] = squared(i == 2U ? OPEN_RAD_S : OPEN_M_S);
        tracker->covariance[DISTURBANCE + i][DISTURBANCE + i] = squared(Walk[i]);
    }
    tracker->is_started = 1;
}

/* Row i takes row k times a factor, then column i column k: P <- E P E^T with E = I + factor e_i e_k^T. */
static void addState(hb_tracker* tracker, uint8_t i, uint8_t k, float factor) {
    for (uint8_t j = 0; j < HB_TRACKER_STATES; j++) {
        tracker->covariance[i][j] += factor * tracker->covariance[k][j];
    }
    for (uint8_t j = 0; j < HB_TRACKER_STATES; j++) {
        tracker->covariance[j][i] += factor * tracker->covariance[j][k];
    }
}

void hb_tracker_predict(hb_tracker* tracker, const float acceleration[3]) {
    const float half = 0.5F * TICK_S * TICK_S;
    for (uint8_t i = 0; i < AXES; i++) {
        uint8_t v = (uint8_t)(SPEED + i);
        uint8_t d = (uint8_t)(DISTURBANCE + i);
        float total = acceleration[i] + tracker->mean[d];
        float white = squared(White[i]);
        tracker->mean[i] += TICK_S * tracker->mean[v] + half * total;
        tracker->mean[v] += TICK_S * total;
        /* The pose first, from speed and disturbance of before. */
        addState(tracker, i, v, TICK_S);
        addState(tracker, i, d, half);
        addState(tracker, v, d, TICK_S);
        tracker->covariance[i][i] += half * half * white;
        tracker->covariance[i][v] += half * TICK_S * white;
        tracker->covariance[v][i] += half * TICK_S * white;
        tracker->covariance[v][v] += TICK_S * TICK_S * white;
        tracker->covariance[d][d] += TICK_S * squared(Walk[i]);
    }
}

/* One reading with its slope by the pose at the predicted pose; `moved` is what the readings before it have
 * changed of the mean. */
static float take(hb_tracker* tracker, const hb_chip_model* model, uint8_t axis, float reading_T,
                  float variance_T2, float moved[HB_TRACKER_STATES]) {
    float cross[HB_TRACKER_STATES];
    float innovation = reading_T - model->field_T[axis];
    float variance = variance_T2;
    for (uint8_t i = 0; i < HB_TRACKER_STATES; i++) {
        cross[i] = 0.0F;
        for (uint8_t k = 0; k < AXES; k++) {
            cross[i] += tracker->covariance[i][k] * model->slope[axis][k];
        }
    }
    for (uint8_t k = 0; k < AXES; k++) {
        variance += model->slope[axis][k] * cross[k];
        innovation -= model->slope[axis][k] * moved[k];
    }
    for (uint8_t i = 0; i < HB_TRACKER_STATES; i++) {
        moved[i] += cross[i] * innovation / variance;
        for (uint8_t k = 0; k < HB_TRACKER_STATES; k++) {
            tracker->covariance[i][k] -= cross[i] * cross[k] / variance;
        }
    }
    return innovation * innovation / variance;
}

float hb_tracker_update(hb_tracker* tracker, const hb_chips* chips, float pitch_m,
                        const float field_T[HB_CHIP_FIELDS], uint8_t used) {
    float moved[HB_TRACKER_STATES];
    float chi_square = 0.0F;
    hb_pose pose;
    memset(moved, 0, sizeof moved);
    pose.x_m = tracker->mean[0];
    pose.y_m = tracker->mean[1];
    pose.phi_rad = tracker->mean[2];
    for (uint8_t chip = 0; chip < HB_CHIPS; chip++) {
        hb_chip_model model;
        if ((((unsigned int)used >> chip) & 1U) == 0U) {
            continue;
        }
        model = hb_chip_model_at(chips, pitch_m, &pose, chip);
        for (uint8_t axis = 0; axis < 2U; axis++) {
            chi_square +=
                take(tracker, &model, axis, field_T[2U * chip + axis], squared(chips->deviation_T), moved);
        }
    }
    for (uint8_t i = 0; i < HB_TRACKER_STATES; i++) {
        tracker->mean[i] += moved[i];
    }
    return chi_square;
}
