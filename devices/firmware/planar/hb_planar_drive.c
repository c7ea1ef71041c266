/* SPDX-License-Identifier: MIT */
#include "devices/firmware/planar/hb_planar_internal.h"

#include <math.h>
#include <string.h>

#define TICK_S (0.001F * HB_TICK_MS)
/* Room for the rounding of a demand that is meant to be the limit itself. */
#define LIMIT_ROUNDING 1.0001F
/* Braking: force = -mass speed/BRAKE_TIME, which the currents' limit bounds at first. It ends when the speed
 * estimate, which the noise of the chips shakes by some mm/s, has stayed small for a while. */
#define BRAKE_TIME_S 0.02F
#define REST_M_S 5.0e-3F
#define REST_RAD_S 0.1F
enum { REST_TICKS = 30 / HB_TICK_MS };

static hb_pose poseOf(const hb_planar* planar) {
    hb_pose pose;
    pose.x_m = planar->signals.position[0];
    pose.y_m = planar->signals.position[1];
    pose.phi_rad = planar->signals.position[2];
    return pose;
}

/* From a force at the centre of mass and the torque about it to the origin of the platen frame. */
static hb_wrench aboutOrigin(const hb_planar* planar, const hb_planar_calibration* page,
                             const float effort[HB_AXES]) {
    float c = cosf(planar->signals.position[2]);
    float s = sinf(planar->signals.position[2]);
    float arm_x = c * page->centre_x_m - s * page->centre_y_m;
    float arm_y = s * page->centre_x_m + c * page->centre_y_m;
    hb_wrench wrench;
    wrench.x_N = effort[0];
    wrench.y_N = effort[1];
    wrench.torque_Nm = effort[2] + arm_x * effort[1] - arm_y * effort[0];
    return wrench;
}

static void demand(hb_planar* planar, const hb_planar_calibration* page, const hb_wrench* wrench) {
    hb_pose pose = poseOf(planar);
    if (page->allocation < 0.5F) {
        hb_planar_allocate(&page->coils, &pose, wrench, planar->demand_A);
    } else {
        uint8_t orders = page->allocation < 1.5F ? 1U : (uint8_t)HB_WINDING_ORDERS;
        hb_coil_wrench forces = hb_planar_windings(&page->coils, &pose, orders);
        (void)hb_planar_least_norm(&forces, wrench, planar->demand_A); /* else no current */
    }
    planar->signals.current_scale = hb_planar_limit(planar->demand_A, page->limit_current_A);
}

/* A step, a staircase and a set-point have no speed: the law weights them. */
static uint8_t isStepped(uint8_t shape) {
    return shape == HB_SHAPE_NONE || shape == HB_SHAPE_STEP || shape == HB_SHAPE_STAIRCASE;
}

static void controlPosition(hb_planar* planar, const hb_planar_calibration* page) {
    float effort[HB_AXES];
    uint8_t may_integrate = planar->signals.current_scale >= 1.0F;
    hb_wrench wrench;
    for (uint8_t i = 0; i < HB_AXES; i++) {
        hb_reference_point point;
        hb_planar_law_input input;
        if (planar->profile[i].running) {
            planar->reference[i].held = hb_profile_point(&planar->profile[i]);
        }
        point = hb_reference_evaluate(&planar->reference[i]);
        memset(&input, 0, sizeof input);
        input.position = planar->signals.position[i] - planar->origin[i];
        input.speed = planar->signals.speed[i];
        input.step = planar->live.setpoint[i];
        if (isStepped(planar->reference[i].config.shape)) {
            input.step += point.value;
        } else {
            input.profile = point.value;
            input.profile_speed = point.speed;
            input.profile_acceleration = point.acceleration;
        }
        planar->signals.reference[i] = planar->origin[i] + input.step + input.profile;
        effort[i] = hb_planar_law_step(&planar->integral[i], &page->gains[i], &input, TICK_S, may_integrate);
    }
    wrench = aboutOrigin(planar, page, effort);
    demand(planar, page, &wrench);
}

static void controlWrench(hb_planar* planar, const hb_planar_calibration* page) {
    float demanded[HB_AXES];
    hb_wrench wrench;
    for (uint8_t i = 0; i < HB_AXES; i++) {
        demanded[i] = planar->live.setpoint[i] + hb_reference_evaluate(&planar->reference[i]).value;
        planar->signals.reference[i] = demanded[i];
    }
    wrench.x_N = demanded[0];
    wrench.y_N = demanded[1];
    wrench.torque_Nm = demanded[2];
    demand(planar, page, &wrench);
}

/* A demand beyond the limit is a mistake of its author: stopping beats bending the test signal. */
static void controlCurrents(hb_planar* planar, const hb_planar_calibration* page) {
    planar->signals.current_scale = 1.0F;
    for (uint8_t k = 0; k < HB_COILS; k++) {
        float current_A = planar->live.current_A[k];
        if (!(fabsf(current_A) <= page->limit_current_A * LIMIT_ROUNDING)) {
            hb_board_raise_fault(&planar->board, HB_FAULT_CURRENT);
            return;
        }
        planar->demand_A[k] = current_A;
    }
}

/* The reference that is held passes from the weighted part to the other or back without a bump. */
static void keepEffort(hb_planar* planar, const hb_planar_calibration* page, uint8_t axis) {
    uint8_t was_stepped = isStepped(planar->reference[axis].config.shape);
    uint8_t is_stepped = isStepped(planar->live.reference[axis].shape);
    float held = hb_reference_evaluate(&planar->reference[axis]).value;
    float change = page->gains[axis].kp * (1.0F - page->gains[axis].setpoint_weight) * held;
    if (was_stepped != is_stepped) {
        planar->integral[axis] += is_stepped ? change : -change;
    }
}

/* A travel keeps its points where the reference keeps the one it holds. */
static void startReference(hb_planar* planar, uint8_t axis, uint8_t is_position) {
    static const hb_plateau_config NoPlateaus = {0}; /* no shape of ours uses them */
    const hb_reference_config* config = &planar->live.reference[axis];
    hb_reference* reference = &planar->reference[axis];
    planar->profile[axis].running = 0;
    if (is_position && config->shape == HB_PLANAR_TRAPEZOID) {
        hb_reference_stop(reference);
        reference->config = *config;
        hb_profile_start(&planar->profile[axis], reference->held.value, config->amplitude, config->rate,
                         planar->live.acceleration[axis]);
    } else {
        hb_reference_start(reference, config, &NoPlateaus, is_position);
    }
}

static void startPendingReferences(hb_planar* planar, const hb_planar_calibration* page) {
    uint8_t is_position = planar->board.mode == HB_PLANAR_POSITION;
    if (planar->board.mode == HB_PLANAR_CURRENTS || !hb_board_take_start(&planar->board)) {
        return;
    }
    for (uint8_t i = 0; i < HB_AXES; i++) {
        if (is_position) {
            keepEffort(planar, page, i);
        }
        startReference(planar, i, is_position);
    }
}

static void publishReference(hb_planar* planar) {
    hb_board_signals* board = &planar->signals.board;
    board->reference_segment = 0;
    board->reference_running = 0;
    for (uint8_t i = 0; i < HB_AXES; i++) {
        uint8_t travels = planar->profile[i].running;
        board->reference_running |= planar->reference[i].running || travels;
        if (travels && board->reference_segment == 0) {
            board->reference_segment = 1;
        }
        if (planar->reference[i].segment > board->reference_segment) {
            board->reference_segment = planar->reference[i].segment;
        }
    }
}

void hb_planar_control(void* planar, const void* page) {
    hb_planar* self = (hb_planar*)planar;
    const hb_planar_calibration* calibration = (const hb_planar_calibration*)page;
    if (self->board.safety.armed && self->board.mode != HB_MODE_IDLE) {
        startPendingReferences(self, calibration);
        if (self->board.mode == HB_PLANAR_POSITION) {
            controlPosition(self, calibration);
        } else if (self->board.mode == HB_PLANAR_WRENCH) {
            controlWrench(self, calibration);
        } else {
            controlCurrents(self, calibration);
        }
    } else {
        memset(self->signals.reference, 0, sizeof self->signals.reference);
        self->signals.current_scale = 1.0F;
    }
    publishReference(self);
}

/* What was demanded `delay.samples` ticks ago. */
static void delay(hb_planar* planar, const hb_planar_calibration* page) {
    uint8_t samples = (uint8_t)(page->delay_samples + 0.5F);
    const float* out = samples == 0 ? planar->demand_A : planar->pending_A[samples - 1U];
    memcpy(planar->signals.current_A, out, sizeof planar->signals.current_A);
    memcpy(planar->pending_A[1], planar->pending_A[0], sizeof planar->pending_A[1]);
    memcpy(planar->pending_A[0], planar->demand_A, sizeof planar->pending_A[0]);
}

void hb_planar_drive(void* planar, const void* page) {
    delay((hb_planar*)planar, (const hb_planar_calibration*)page);
}

uint8_t hb_planar_brake(void* planar, const void* page) {
    hb_planar* self = (hb_planar*)planar;
    const hb_planar_calibration* calibration = (const hb_planar_calibration*)page;
    const float* speed = self->signals.speed;
    float effort[HB_AXES];
    hb_wrench wrench;
    uint8_t rests = fabsf(speed[0]) < REST_M_S && fabsf(speed[1]) < REST_M_S && fabsf(speed[2]) < REST_RAD_S;
    self->rest_ticks = rests ? (uint8_t)(self->rest_ticks + 1U) : 0;
    if (self->rest_ticks > REST_TICKS || !self->has_pose || self->signals.left_out != 0) {
        return 0;
    }
    effort[0] = -calibration->mass_kg / BRAKE_TIME_S * speed[0];
    effort[1] = -calibration->mass_kg / BRAKE_TIME_S * speed[1];
    effort[2] = -calibration->inertia_kg_m2 / BRAKE_TIME_S * speed[2];
    wrench = aboutOrigin(self, calibration, effort);
    demand(self, calibration, &wrench);
    delay(self, calibration);
    return 1;
}

void hb_planar_enter_mode(void* planar, uint8_t mode) {
    hb_planar* self = (hb_planar*)planar;
    (void)mode;
    memcpy(self->origin, self->signals.position, sizeof self->origin);
    memset(self->integral, 0, sizeof self->integral);
    memset(self->demand_A, 0, sizeof self->demand_A);
    memset(self->pending_A, 0, sizeof self->pending_A);
    memset(self->live.setpoint, 0, sizeof self->live.setpoint);
    memset(self->live.current_A, 0, sizeof self->live.current_A);
    self->signals.current_scale = 1.0F;
    self->rest_ticks = 0;
    for (uint8_t i = 0; i < HB_AXES; i++) {
        hb_reference_clear(&self->reference[i]);
        self->profile[i].running = 0;
    }
}

uint8_t hb_planar_check(void* planar, uint16_t offset, float value) {
    const hb_planar* self = (const hb_planar*)planar;
    if (offset == offsetof(hb_planar_live, board.arm) && value > 0.5F && !self->has_pose) {
        return HB_ERR_BUSY; /* the pose to start from is not known */
    }
    if (offset >= offsetof(hb_planar_live, current_A) &&
        offset < offsetof(hb_planar_live, current_A) + sizeof self->live.current_A &&
        fabsf(value) > self->pages[self->board.xcp.active_page].limit_current_A) {
        return HB_ERR_OUT_OF_RANGE;
    }
    for (uint8_t i = 0; i < HB_AXES; i++) {
        if (offset == offsetof(hb_planar_live, reference[0].shape) + i * sizeof(hb_reference_config) &&
            value == (float)HB_SHAPE_PLATEAUS) {
            return HB_ERR_OUT_OF_RANGE; /* a list of currents is for one phase */
        }
    }
    if (offset == offsetof(hb_planar_live, home) && value > 0.5F && hb_board_is_driving(&self->board)) {
        return HB_ERR_ACCESS_DENIED;
    }
    return HB_OK;
}

void hb_planar_stop_reference(void* planar) {
    hb_planar* self = (hb_planar*)planar;
    for (uint8_t i = 0; i < HB_AXES; i++) {
        hb_reference_stop(&self->reference[i]);
        self->profile[i].running = 0;
        self->reference[i].held.speed = 0.0F;
        self->reference[i].held.acceleration = 0.0F;
    }
}

uint8_t hb_planar_advance(void* planar) {
    hb_planar* self = (hb_planar*)planar;
    uint8_t runs = 0;
    for (uint8_t i = 0; i < HB_AXES; i++) {
        hb_reference_advance(&self->reference[i]);
        if (self->profile[i].running) {
            hb_profile_advance(&self->profile[i]);
            self->reference[i].held = hb_profile_point(&self->profile[i]);
        }
        runs |= self->reference[i].running || self->profile[i].running;
    }
    return runs;
}
