/* SPDX-License-Identifier: MIT */
#include "devices/firmware/control/hb_constants.h"
#include "devices/firmware/control/hb_trig.h"
#include "devices/firmware/htm/hb_htm_internal.h"

#include <math.h>
#include <string.h>

#define POSITION_PERIOD_S 0.01F
#define COUNTS_PER_RAD ((float)HB_HTM_COUNTS_PER_TURN / HB_TWO_PI)
#define RAD_S_PER_COUNT_TICK (1000.0F / HB_TICK_MS / COUNTS_PER_RAD)
/* Below this part of the expected amplitude the field is not the rotor's. */
#define LEAST_AMPLITUDE_RATIO 0.3F
/* Room for the rounding of a demand that is meant to be the limit itself. */
#define LIMIT_ROUNDING 1.0001F

static uint8_t isOn(float parameter) {
    return parameter > 0.5F;
}

static uint8_t asInteger(float parameter) {
    return (uint8_t)(parameter + 0.5F);
}

static hb_hall_correction correctionOf(const hb_htm* motor, const hb_htm_calibration* page) {
    hb_hall_correction correction;
    float stray = isOn(page->stray_enabled) ? page->stray_coefficient : 0.0F;
    correction.offset_T[0] = page->hall_offset_a;
    correction.offset_T[1] = page->hall_offset_b;
    correction.gain_ratio = page->hall_gain_ratio;
    correction.quadrature_rad = page->hall_quadrature;
    correction.amplitude_T = page->hall_amplitude;
    correction.stray_T[0] = stray * motor->flowing_A[0];
    correction.stray_T[1] = stray * motor->flowing_A[1];
    correction.decode = isOn(page->decode_method) ? HB_DECODE_LINEAR : HB_DECODE_ARCTANGENT;
    return correction;
}

/* turns * 2^18 + fraction; wraps after 8192 turns without touching the control, which uses turns and
 * fraction. */
static int32_t positionCounts(const hb_sensing* sensing) {
    float fraction = sensing->angle_rad * COUNTS_PER_RAD;
    int32_t rounded = (int32_t)(fraction >= 0.0F ? fraction + 0.5F : fraction - 0.5F);
    return (int32_t)((uint32_t)sensing->turns * (uint32_t)HB_HTM_COUNTS_PER_TURN + (uint32_t)rounded);
}

void hb_htm_sense(void* motor, const void* page, const void* inputs) {
    hb_htm* self = (hb_htm*)motor;
    const hb_htm_calibration* calibration = (const hb_htm_calibration*)page;
    const hb_htm_inputs* codes = (const hb_htm_inputs*)inputs;
    hb_sensing* sensing = &self->sensing;
    uint8_t fault = hb_sensing_convert(sensing, codes->hall_code, codes->temperature_code);
    if (fault != HB_FAULT_NOT_FINITE) {
        hb_hall_correction correction = correctionOf(self, calibration);
        float least_T = LEAST_AMPLITUDE_RATIO * calibration->hall_amplitude;
        float amplitude_T2;
        uint8_t jumped;
        float angle = hb_sensing_decode(sensing, &correction, &amplitude_T2);
#if HB_FEATURE_ERROR_MAP
        if (isOn(calibration->errormap_enabled)) {
            angle = hb_error_map_correct(angle, calibration->errormap_cosine, calibration->errormap_sine);
        }
#endif
        if (amplitude_T2 < least_T * least_T) {
            fault = HB_FAULT_SENSOR_RANGE;
        }
        jumped = hb_sensing_unwrap(sensing, angle);
        fault = fault ? fault : jumped;
        self->signals.position = positionCounts(sensing);
        self->signals.speed_rad_s =
            hb_speed_update(&self->speed, self->signals.position) * RAD_S_PER_COUNT_TICK;
    }
    for (uint8_t i = 0; i < 2; i++) {
        self->signals.hall_T[i] = sensing->field_T[i];
        self->signals.temperature_degC[i] = sensing->temperature_degC[i];
    }
    if (fault) {
        hb_board_raise_fault(&self->board, fault);
    }
}

/* Rotor angle since arming, rad. */
static float excursion(const hb_htm* motor) {
    return (float)(motor->sensing.turns - motor->origin_turns) * HB_TWO_PI +
           (motor->sensing.angle_rad - motor->origin_angle_rad);
}

void hb_htm_supervise(void* motor, const void* page) {
    hb_htm* self = (hb_htm*)motor;
    const hb_htm_calibration* calibration = (const hb_htm_calibration*)page;
    hb_safety_limits limits;
    hb_safety_state state;
    uint8_t fault;
    limits.limit_degC = calibration->limit_temperature;
    limits.speed_rad_s = calibration->window_speed;
    limits.window_rad = calibration->window_position;
    limits.speed_enabled = isOn(calibration->window_speed_enabled);
    limits.window_enabled = isOn(calibration->window_position_enabled);
    state.temperature_degC[0] = self->sensing.temperature_degC[0];
    state.temperature_degC[1] = self->sensing.temperature_degC[1];
    state.speed_rad_s = self->signals.speed_rad_s;
    if (limits.window_enabled || self->board.loop_phase == 0) {
        self->excursion_rad = excursion(self);
    }
    state.excursion_rad = self->excursion_rad;
    fault = hb_safety_check(&self->board.safety, &limits, &state);
    if (fault) {
        hb_board_raise_fault(&self->board, fault);
    }
}

static hb_law_config lawOf(const hb_htm_calibration* page) {
    hb_law_config config;
    config.law = asInteger(page->law);
    config.kp_A_per_rad = page->kp;
    config.ki_A_per_rad_s = page->ki;
    config.kd_As_per_rad = page->kd;
#if HB_LAW_WEIGHTS
    config.reference_weight = page->reference_weight;
    config.derivative_reference_weight = page->derivative_reference_weight;
    config.derivative_filter_s = page->derivative_filter;
#endif
#if HB_LAW_SECTIONS > 0
    memcpy(config.sections, page->sections, sizeof config.sections);
#endif
    config.inertia_As2_per_rad = page->ff_inertia;
    config.viscous_As_per_rad = page->ff_viscous;
    config.coulomb_A = page->ff_coulomb;
    config.coulomb_speed_rad_s = page->ff_coulomb_speed;
    config.stiction_A = page->stiction_current;
    config.stiction_threshold_rad = page->stiction_threshold;
    config.stiction_speed_rad_s = page->stiction_speed;
    config.limit_A = page->limit_current;
    config.period_s = POSITION_PERIOD_S;
    config.delay_samples = asInteger(page->delay_samples);
    return config;
}

static void startPendingReference(hb_htm* motor) {
    uint8_t is_position = motor->board.mode == HB_MODE_POSITION;
    if ((is_position && motor->board.loop_phase != 0) || !hb_board_take_start(&motor->board)) {
        return;
    }
    hb_reference_start(&motor->reference, &motor->live.reference, &motor->live.plateaus, is_position);
}

static void controlPosition(hb_htm* motor, const hb_htm_calibration* page) {
    hb_law_config config = lawOf(page);
    hb_reference_point point = hb_reference_evaluate(&motor->reference);
    hb_law_input input;
    float command_A;
    input.position_rad = motor->excursion_rad;
    input.reference_rad = point.value + motor->live.setpoint;
    input.reference_speed_rad_s = point.speed;
    input.reference_acceleration_rad_s2 = point.acceleration;
    input.is_saturated = 0; /* the current follows its command up to the limit */
    command_A = hb_law_step(&motor->law, &config, &input);
    motor->signals.reference =
        (float)motor->origin_turns * HB_TWO_PI + motor->origin_angle_rad + input.reference_rad;
    if (isfinite(command_A)) {
        motor->signals.current_command_A = command_A;
    } else {
        hb_board_raise_fault(&motor->board, HB_FAULT_NOT_FINITE);
    }
}

/* A demand beyond the limit is a mistake of its author: stopping beats bending the test signal. */
static void controlCurrent(hb_htm* motor, const hb_htm_calibration* page) {
    float demand = hb_reference_evaluate(&motor->reference).value + motor->live.setpoint;
    if (!isfinite(demand)) {
        hb_board_raise_fault(&motor->board, HB_FAULT_NOT_FINITE);
    } else if (fabsf(demand) > page->limit_current * LIMIT_ROUNDING) {
        hb_board_raise_fault(&motor->board, HB_FAULT_CURRENT);
    } else {
        motor->signals.current_command_A = demand;
        motor->signals.reference = demand;
    }
}

static void control(hb_htm* motor, const hb_htm_calibration* page) {
    if (!hb_board_is_driving(&motor->board)) {
        motor->signals.current_command_A = 0.0F;
        motor->signals.reference = 0.0F;
        return;
    }
    startPendingReference(motor);
    if (motor->board.mode != HB_MODE_POSITION) {
        controlCurrent(motor, page);
    } else if (motor->board.loop_phase == 0) {
        controlPosition(motor, page);
    }
}

void hb_htm_control(void* motor, const void* page) {
    hb_htm* self = (hb_htm*)motor;
    control(self, (const hb_htm_calibration*)page);
    self->signals.board.reference_segment = self->reference.segment;
    self->signals.board.reference_running = self->reference.running;
}

/* Commutation. */
void hb_htm_drive(void* motor, const void* page) {
    hb_htm* self = (hb_htm*)motor;
    const hb_htm_calibration* calibration = (const hb_htm_calibration*)page;
    hb_htm_signals* signals = &self->signals;
    float angle;
    float sine;
    float cosine;
    if (calibration->commutation_divider > 1.5F &&
        self->board.tick % asInteger(calibration->commutation_divider) != 0) {
        return;
    }
    if (signals->current_command_A == 0.0F) {
        signals->current_A[0] = 0.0F;
        signals->current_A[1] = 0.0F;
        return;
    }
    angle = self->sensing.angle_rad;
    if (calibration->commutation_advance != 0.0F) {
        angle += signals->speed_rad_s * calibration->commutation_advance;
    }
    hb_sine_cosine(angle, &sine, &cosine);
    if (self->board.mode == HB_MODE_D_AXIS) {
        signals->current_A[0] = signals->current_command_A * cosine;
        signals->current_A[1] = signals->current_command_A * sine;
    } else {
        signals->current_A[0] = -signals->current_command_A * sine;
        signals->current_A[1] = signals->current_command_A * cosine;
    }
}

uint8_t hb_htm_advance(void* motor) {
    hb_reference* reference = &((hb_htm*)motor)->reference;
    hb_reference_advance(reference);
    return reference->running;
}
