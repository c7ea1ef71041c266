/* SPDX-License-Identifier: MIT */
#include "devices/firmware/control/hb_constants.h"
#include "devices/firmware/planar/hb_planar_internal.h"

#include <math.h>
#include <string.h>

#define JUMP_M 0.5e-3F
#define TICK_S (0.001F * HB_TICK_MS)

static uint8_t isOn(float parameter) {
    return parameter > 0.5F;
}

static float volts(const hb_planar_hardware* hardware, float code) {
    return (code + 0.5F) * hardware->adc_V_per_code + hardware->adc_lowest_V;
}

/* Fields and temperatures from the codes; the chips whose converters are not at an end, bit by bit. A code
 * that is not finite is a fault and leaves everything as it was. */
static uint8_t convert(hb_planar* planar, const hb_planar_inputs* inputs, uint8_t* trusted) {
    hb_planar_signals* signals = &planar->signals;
    const hb_planar_hardware* hardware = &planar->hardware;
    for (uint8_t i = 0; i < HB_CHIP_FIELDS; i++) {
        if (!isfinite(inputs->field_code[i])) {
            return HB_FAULT_NOT_FINITE;
        }
    }
    for (uint8_t k = 0; k < HB_COILS; k++) {
        if (!isfinite(inputs->temperature_code[k])) {
            return HB_FAULT_NOT_FINITE;
        }
    }
    *trusted = HB_ALL_CHIPS;
    for (uint8_t i = 0; i < HB_CHIP_FIELDS; i++) {
        signals->field_T[i] = volts(hardware, inputs->field_code[i]) / hardware->field_V_per_T;
        if (inputs->field_code[i] <= 0.0F || inputs->field_code[i] >= hardware->adc_last_code) {
            *trusted &= (uint8_t) ~(1U << (i / 2U));
        }
    }
    for (uint8_t k = 0; k < HB_COILS; k++) {
        signals->temperature_degC[k] =
            25.0F + (volts(hardware, inputs->temperature_code[k]) - 0.75F) * 100.0F;
    }
    return HB_FAULT_NONE;
}

static hb_pose lastPose(const hb_planar* planar) {
    hb_pose pose;
    pose.x_m = planar->signals.position[0];
    pose.y_m = planar->signals.position[1];
    pose.phi_rad = planar->signals.position[2];
    return pose;
}

static float inNearestCell(float value_m, float near_m, float pitch_m) {
    return value_m + pitch_m * roundf((near_m - value_m) / pitch_m);
}

/* Without a pose to start from: closed form, in the cell nearest to the last pose, which at power-on is the
 * cell of the lattice's origin. */
static uint8_t startPose(const hb_planar* planar, const hb_planar_calibration* page,
                         const float field_T[HB_CHIP_FIELDS], uint8_t trusted, hb_pose* pose) {
    hb_pose last = lastPose(planar);
    if (!hb_pose_start(&page->chips, page->coils.pitch_m, field_T, trusted, pose)) {
        return 0;
    }
    pose->x_m = inNearestCell(pose->x_m, last.x_m, page->coils.pitch_m);
    pose->y_m = inNearestCell(pose->y_m, last.y_m, page->coils.pitch_m);
    return 1;
}

static hb_pose predictedPose(const hb_planar* planar) {
    hb_pose pose = lastPose(planar);
    pose.x_m += TICK_S * planar->signals.speed[0];
    pose.y_m += TICK_S * planar->signals.speed[1];
    pose.phi_rad += TICK_S * planar->signals.speed[2];
    return pose;
}

/* Under the currents that flowed since the tick before, about the centre of mass. */
static void predictMotion(hb_planar* planar, const hb_planar_calibration* page) {
    hb_pose pose = lastPose(planar);
    hb_wrench wrench = hb_planar_wrench(&page->coils, &pose, planar->flowing_A);
    float c = cosf(pose.phi_rad);
    float s = sinf(pose.phi_rad);
    float arm_x = c * page->centre_x_m - s * page->centre_y_m;
    float arm_y = s * page->centre_x_m + c * page->centre_y_m;
    float acceleration[HB_AXES];
    acceleration[0] = wrench.x_N / page->mass_kg;
    acceleration[1] = wrench.y_N / page->mass_kg;
    acceleration[2] = (wrench.torque_Nm - arm_x * wrench.y_N + arm_y * wrench.x_N) / page->inertia_kg_m2;
    hb_tracker_predict(&planar->tracker, acceleration);
}

/* The pose that least squares found starts the filter and proves the readings; then the filter is believed.
 */
static void track(hb_planar* planar, const hb_planar_calibration* page, const float field_T[HB_CHIP_FIELDS],
                  const hb_checked_pose* found) {
    hb_planar_signals* signals = &planar->signals;
    if (!planar->has_pose || !planar->tracker.is_started) {
        /* Of a reading: deviation over the largest slope, with room for a bad place. */
        float deviation_m =
            3.0F * page->chips.deviation_T * page->coils.pitch_m / (HB_TWO_PI * page->chips.amplitude_T[0]);
        hb_tracker_start(&planar->tracker, &found->estimate.pose, deviation_m);
    } else {
        predictMotion(planar, page);
        signals->innovation_square =
            hb_tracker_update(&planar->tracker, &page->chips, page->coils.pitch_m, field_T, found->used);
    }
    memcpy(signals->position, planar->tracker.mean, sizeof signals->position);
    memcpy(signals->speed, &planar->tracker.mean[HB_AXES], sizeof signals->speed);
}

/* New pose and filtered difference: v <- D v + (1 - D)(q_k - q_k-1)/Ts, D = exp(-Ts/Tf). */
static void publishPose(hb_planar* planar, const hb_planar_calibration* page, const hb_pose* pose) {
    hb_planar_signals* signals = &planar->signals;
    const float next[HB_AXES] = {pose->x_m, pose->y_m, pose->phi_rad};
    float kept = page->speed_filter_s > 0.0F ? expf(-TICK_S / page->speed_filter_s) : 0.0F;
    for (uint8_t i = 0; i < HB_AXES; i++) {
        float speed = (next[i] - signals->position[i]) / TICK_S;
        signals->speed[i] = planar->has_pose ? kept * signals->speed[i] + (1.0F - kept) * speed : 0.0F;
        signals->position[i] = next[i];
    }
    planar->tracker.is_started = 0;
    signals->innovation_square = 0.0F;
}

static uint8_t findPose(hb_planar* planar, const hb_planar_calibration* page, uint8_t trusted) {
    float field_T[HB_CHIP_FIELDS];
    uint8_t had_pose = planar->has_pose;
    hb_checked_pose found;
    hb_pose predicted = predictedPose(planar);
    for (uint8_t i = 0; i < HB_CHIP_FIELDS; i++) {
        field_T[i] = planar->signals.field_T[i];
    }
    hb_chips_correct(&page->chips, field_T, planar->flowing_A);
    if (!had_pose && !startPose(planar, page, field_T, trusted, &predicted)) {
        return HB_FAULT_SENSOR_RANGE;
    }
    /* The closed form neglects the rotation: 20 mrad move a chip by 1.4 mm. */
    found = hb_pose_check(&page->chips, page->coils.pitch_m, field_T, &predicted, trusted,
                          had_pose ? JUMP_M : 10.0F * JUMP_M);
    planar->signals.chi_square = found.estimate.chi_square;
    planar->signals.left_out = (uint8_t)(HB_ALL_CHIPS & ~found.used);
    if (found.verdict == HB_CHIPS_CONTRADICT) {
        planar->has_pose = 0;
        planar->signals.left_out = HB_ALL_CHIPS;
        return HB_FAULT_SENSOR_RANGE;
    }
    if (isOn(page->estimator)) {
        track(planar, page, field_T, &found);
    } else {
        publishPose(planar, page, &found.estimate.pose);
    }
    planar->signals.cell[0] = (int16_t)roundf(planar->signals.position[0] / page->coils.pitch_m);
    planar->signals.cell[1] = (int16_t)roundf(planar->signals.position[1] / page->coils.pitch_m);
    planar->has_pose = 1;
    return HB_FAULT_NONE;
}

/* hb.home = 1 makes the present cell the one that is counted from, as long as nothing is driven. */
static void home(hb_planar* planar, const hb_planar_calibration* page) {
    hb_planar_signals* signals = &planar->signals;
    if (planar->live.home && planar->has_pose && !hb_board_is_driving(&planar->board)) {
        for (uint8_t i = 0; i < 2; i++) {
            planar->tracker.mean[i] -= page->coils.pitch_m * (float)signals->cell[i];
            signals->position[i] -= page->coils.pitch_m * (float)signals->cell[i];
            signals->cell[i] = 0;
        }
        signals->homed = 1;
    }
    planar->live.home = 0;
}

void hb_planar_sense(void* planar, const void* page, const void* inputs) {
    hb_planar* self = (hb_planar*)planar;
    const hb_planar_calibration* calibration = (const hb_planar_calibration*)page;
    uint8_t trusted = 0;
    uint8_t fault = convert(self, (const hb_planar_inputs*)inputs, &trusted);
    if (fault == HB_FAULT_NONE) {
        fault = findPose(self, calibration, trusted);
        home(self, calibration);
    }
    if (fault) {
        hb_board_raise_fault(&self->board, fault);
    }
}

static uint8_t violatedLimit(const hb_planar* planar, const hb_planar_calibration* page) {
    const hb_planar_signals* signals = &planar->signals;
    for (uint8_t k = 0; k < HB_COILS; k++) {
        if (signals->temperature_degC[k] > page->limit_temperature_degC) {
            return HB_FAULT_TEMPERATURE;
        }
    }
    if (!planar->board.safety.armed) {
        return HB_FAULT_NONE;
    }
    if (isOn(page->window_speed_enabled) && (fabsf(signals->speed[0]) > page->window_speed_m_s ||
                                             fabsf(signals->speed[1]) > page->window_speed_m_s ||
                                             fabsf(signals->speed[2]) > page->window_speed_rad_s)) {
        return HB_FAULT_SPEED;
    }
    for (uint8_t i = 0; i < HB_AXES && isOn(page->window_position_enabled); i++) {
        if (fabsf(signals->position[i] - planar->origin[i]) > page->window_position[i]) {
            return HB_FAULT_POSITION;
        }
    }
    if (signals->lift_N > page->limit_lift_N) {
        return HB_PLANAR_FAULT_LIFT;
    }
    return HB_FAULT_NONE;
}

void hb_planar_supervise(void* planar, const void* page) {
    hb_planar* self = (hb_planar*)planar;
    const hb_planar_calibration* calibration = (const hb_planar_calibration*)page;
    hb_pose pose = lastPose(self);
    hb_wrench wrench = hb_planar_wrench(&calibration->coils, &pose, self->flowing_A);
    uint8_t fault;
    self->signals.effort[0] = wrench.x_N;
    self->signals.effort[1] = wrench.y_N;
    self->signals.effort[2] = wrench.torque_Nm;
    self->signals.lift_N = hb_planar_lift_N(&calibration->coils, &pose, self->flowing_A);
    fault = violatedLimit(self, calibration);
    if (fault) {
        hb_board_raise_fault(&self->board, fault);
    }
}
