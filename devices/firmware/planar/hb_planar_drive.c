/* SPDX-License-Identifier: MIT */
#include "devices/firmware/planar/hb_planar_internal.h"

#include <float.h>
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

/* Of a profile, whose speed and acceleration are known, the proportional part sees all: no overshoot comes of
 * that. The limit of the effort is that of the currents, and so is their delay. */
static hb_law_config lawOf(const hb_planar_gains* gains, uint8_t is_stepped) {
    hb_law_config config;
    memset(&config, 0, sizeof config);
    config.law = HB_LAW_POSITIONAL;
    config.kp_A_per_rad = gains->kp;
    config.ki_A_per_rad_s = gains->ki;
    config.kd_As_per_rad = gains->kd;
    config.reference_weight = is_stepped ? gains->reference_weight : 1.0F;
    config.derivative_reference_weight = is_stepped ? gains->derivative_reference_weight : 0.0F;
    config.derivative_filter_s = gains->derivative_filter_s;
    memcpy(config.sections, gains->sections, sizeof config.sections);
    config.inertia_As2_per_rad = gains->inertia;
    config.limit_A = FLT_MAX;
    config.period_s = TICK_S;
    return config;
}

static float axisEffort(hb_planar* planar, const hb_planar_calibration* page, uint8_t axis) {
    uint8_t is_stepped = isStepped(planar->reference[axis].config.shape);
    hb_law_config config = lawOf(&page->gains[axis], is_stepped);
    hb_reference_point point;
    hb_law_input input;
    point = hb_reference_evaluate(&planar->reference[axis]);
    memset(&input, 0, sizeof input);
    input.position_rad = planar->signals.position[axis] - planar->origin[axis];
    input.reference_rad = planar->live.setpoint[axis] + point.value;
    if (!is_stepped) {
        /* The law knows the speed of the last period on average, half a period ago. */
        input.reference_speed_rad_s = point.speed - 0.5F * TICK_S * point.acceleration;
        input.reference_acceleration_rad_s2 = point.acceleration;
    }
    input.is_saturated = planar->signals.current_scale < 1.0F;
    planar->signals.reference[axis] = planar->origin[axis] + input.reference_rad;
    return hb_law_step(&planar->law[axis], &config, &input);
}

static void keepPathPoint(hb_planar* planar) {
    hb_reference_point point[HB_PATH_AXES];
    hb_path_point(&planar->path, point);
    for (uint8_t i = 0; i < HB_PATH_AXES; i++) {
        planar->reference[i].held = point[i];
    }
}

static void keepPiecePoint(hb_planar* planar) {
    hb_reference_point point[HB_PIECE_AXES];
    hb_pieces_point(&planar->pieces, point);
    for (uint8_t i = 0; i < HB_PIECE_AXES; i++) {
        planar->reference[i].held = point[i];
    }
}

/* The reference holds the present point of a travel, of the path or of the pieces. */
static void takeTravelPoints(hb_planar* planar) {
    for (uint8_t i = 0; i < HB_AXES; i++) {
        if (planar->profile[i].running) {
            planar->reference[i].held = hb_profile_point(&planar->profile[i]);
        }
    }
    if (planar->path.running) {
        keepPathPoint(planar);
    }
    if (planar->pieces.running) {
        keepPiecePoint(planar);
    }
}

static void controlPosition(hb_planar* planar, const hb_planar_calibration* page) {
    float effort[HB_AXES];
    hb_wrench wrench;
    takeTravelPoints(planar);
    for (uint8_t i = 0; i < HB_AXES; i++) {
        effort[i] = axisEffort(planar, page, i) + hb_reference_evaluate(&planar->excitation[i]).value;
        planar->signals.command[i] = effort[i];
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
        planar->signals.command[i] = demanded[i];
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

static uint8_t isOnPath(const hb_planar* planar, uint8_t axis) {
    uint8_t shape = planar->live.path.shape;
    return shape == HB_PATH_TABLE || (axis < HB_PATH_AXES && shape != HB_PATH_NONE);
}

static uint8_t wantedShape(const hb_planar* planar, uint8_t axis) {
    return isOnPath(planar, axis) ? (uint8_t)HB_PLANAR_ON_PATH : planar->live.reference[axis].shape;
}

/* The reference that is held passes from weighted to whole or back without a bump. */
static void keepEffort(hb_planar* planar, const hb_planar_calibration* page, uint8_t axis) {
    const hb_planar_gains* gains = &page->gains[axis];
    uint8_t was_stepped = isStepped(planar->reference[axis].config.shape);
    uint8_t is_stepped = isStepped(wantedShape(planar, axis));
    float held = planar->live.setpoint[axis] + hb_reference_evaluate(&planar->reference[axis]).value;
    float change = gains->kp * (1.0F - gains->reference_weight) * held;
    float step = gains->derivative_reference_weight * held; /* the derivative sees no jump either */
    if (was_stepped != is_stepped) {
        planar->law[axis].integral_A += is_stepped ? change : -change;
        planar->law[axis].previous_weighted_rad += is_stepped ? step : -step;
    }
}

static uint8_t isExcitation(const hb_planar* planar, uint8_t axis) {
    return planar->board.mode == HB_PLANAR_POSITION && planar->live.target[axis] == HB_TARGET_EFFORT;
}

/* A travel and the path keep their points where the reference keeps the one it holds. */
static void startReference(hb_planar* planar, uint8_t axis, uint8_t is_position) {
    static const hb_plateau_config NoPlateaus = {0}; /* no shape of ours uses them */
    const hb_reference_config* config = &planar->live.reference[axis];
    hb_reference* reference = &planar->reference[axis];
    uint8_t shape = is_position ? wantedShape(planar, axis) : config->shape;
    if (isExcitation(planar, axis)) { /* the reference before goes on */
        hb_reference_start(&planar->excitation[axis], config, &NoPlateaus, 0);
        return;
    }
    hb_reference_stop(&planar->excitation[axis]);
    planar->profile[axis].running = 0;
    if (is_position && shape >= HB_PLANAR_TRAPEZOID) {
        hb_reference_stop(reference);
        reference->config = *config;
        reference->config.shape = shape;
        if (shape != HB_PLANAR_ON_PATH) {
            hb_profile_limits limits;
            limits.speed = config->rate;
            limits.acceleration = planar->live.acceleration[axis];
            limits.jerk = shape == HB_PLANAR_S_CURVE ? planar->live.jerk[axis] : INFINITY;
            hb_profile_start(&planar->profile[axis], reference->held.value, config->amplitude, &limits);
        }
    } else {
        hb_reference_start(reference, config, &NoPlateaus, is_position);
    }
}

static void startPath(hb_planar* planar) {
    float from[HB_AXES];
    for (uint8_t i = 0; i < HB_AXES; i++) {
        from[i] = planar->reference[i].held.value;
    }
    if (planar->live.path.shape == HB_PATH_TABLE) {
        hb_pieces_start(&planar->pieces, planar->live.piece_count, from);
    } else {
        hb_path_start(&planar->path, &planar->live.path, from);
    }
    planar->live.path.shape = HB_PATH_NONE; /* the next start needs it anew */
}

static void startPendingReferences(hb_planar* planar, const hb_planar_calibration* page) {
    uint8_t is_position = planar->board.mode == HB_PLANAR_POSITION;
    if (planar->board.mode == HB_PLANAR_CURRENTS || !hb_board_take_start(&planar->board)) {
        return;
    }
    for (uint8_t i = 0; i < HB_AXES; i++) {
        if (is_position && !isExcitation(planar, i)) {
            keepEffort(planar, page, i);
        }
        startReference(planar, i, is_position);
    }
    planar->path.running = 0;
    planar->pieces.running = 0;
    if (is_position && planar->live.path.shape != HB_PATH_NONE) {
        startPath(planar);
    }
}

static void publishReference(hb_planar* planar) {
    hb_board_signals* board = &planar->signals.board;
    board->reference_segment = planar->path.running ? (uint16_t)(planar->path.piece + 1U) : 0;
    if (planar->pieces.running) {
        board->reference_segment = (uint16_t)(planar->pieces.piece + 1U);
    }
    board->reference_running = planar->path.running || planar->pieces.running;
    for (uint8_t i = 0; i < HB_AXES; i++) {
        uint8_t travels = planar->profile[i].running;
        board->reference_running |= planar->reference[i].running || planar->excitation[i].running || travels;
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
        memset(self->signals.command, 0, sizeof self->signals.command);
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
    if (mode == HB_MODE_IDLE) {
        self->live.path.shape = HB_PATH_NONE; /* an order that was not taken is none for later */
    }
    memcpy(self->origin, self->signals.position, sizeof self->origin);
    memset(self->demand_A, 0, sizeof self->demand_A);
    memset(self->pending_A, 0, sizeof self->pending_A);
    memset(self->live.setpoint, 0, sizeof self->live.setpoint);
    memset(self->live.current_A, 0, sizeof self->live.current_A);
    self->signals.current_scale = 1.0F;
    self->rest_ticks = 0;
    for (uint8_t i = 0; i < HB_AXES; i++) {
        hb_law_reset(&self->law[i]);
        hb_reference_clear(&self->reference[i]);
        hb_reference_clear(&self->excitation[i]);
        self->profile[i].running = 0;
    }
    self->path.running = 0;
    self->pieces.running = 0;
}

void hb_planar_written(void* planar, uint16_t offset) {
    hb_planar* self = (hb_planar*)planar;
    if (offset == offsetof(hb_planar_live, piece_number)) {
        hb_pieces_store(&self->pieces, self->live.piece_number, &self->live.piece);
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
    if (offset == offsetof(hb_planar_live, piece_number) && self->pieces.running) {
        return HB_ERR_ACCESS_DENIED; /* the motion under way would change */
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
        hb_reference_stop(&self->excitation[i]);
        self->profile[i].running = 0;
        self->reference[i].held.speed = 0.0F;
        self->reference[i].held.acceleration = 0.0F;
    }
    self->path.running = 0;
    self->pieces.running = 0;
    self->live.path.shape =
        HB_PATH_NONE; /* nor does an order that was not taken yet start with the next one */
}

uint8_t hb_planar_advance(void* planar) {
    hb_planar* self = (hb_planar*)planar;
    uint8_t runs = 0;
    for (uint8_t i = 0; i < HB_AXES; i++) {
        hb_reference_advance(&self->reference[i]);
        hb_reference_advance(&self->excitation[i]);
        if (self->profile[i].running) {
            hb_profile_advance(&self->profile[i]);
            self->reference[i].held = hb_profile_point(&self->profile[i]);
        }
        runs |= self->reference[i].running || self->excitation[i].running || self->profile[i].running;
    }
    if (self->path.running) {
        hb_path_advance(&self->path);
        keepPathPoint(self);
        runs |= self->path.running;
    }
    if (self->pieces.running) {
        hb_pieces_advance(&self->pieces);
        keepPiecePoint(self);
        runs |= self->pieces.running;
    }
    return runs;
}
