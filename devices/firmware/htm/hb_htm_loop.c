/* SPDX-License-Identifier: MIT */
#include "devices/firmware/control/hb_constants.h"
#include "devices/firmware/control/hb_trig.h"
#include "devices/firmware/htm/hb_htm_internal.h"

#include <math.h>

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

static hb_hall_correction correctionOf(const hb_htm* board, const hb_htm_calibration* page) {
    hb_hall_correction correction;
    float stray = isOn(page->stray_enabled) ? page->stray_coefficient : 0.0F;
    correction.offset_T[0] = page->hall_offset_a;
    correction.offset_T[1] = page->hall_offset_b;
    correction.gain_ratio = page->hall_gain_ratio;
    correction.quadrature_rad = page->hall_quadrature;
    correction.amplitude_T = page->hall_amplitude;
    correction.stray_T[0] = stray * board->flowing_A[0];
    correction.stray_T[1] = stray * board->flowing_A[1];
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

void hb_htm_sense(hb_htm* board, const hb_htm_calibration* page, const hb_htm_inputs* inputs) {
    hb_sensing* sensing = &board->sensing;
    uint8_t fault = hb_sensing_convert(sensing, inputs->hall_code, inputs->temperature_code);
    if (fault != HB_FAULT_NOT_FINITE) {
        hb_hall_correction correction = correctionOf(board, page);
        float least_T = LEAST_AMPLITUDE_RATIO * page->hall_amplitude;
        float amplitude_T2;
        uint8_t jumped;
        float angle = hb_sensing_decode(sensing, &correction, &amplitude_T2);
#if HB_FEATURE_ERROR_MAP
        if (isOn(page->errormap_enabled)) {
            angle = hb_error_map_correct(angle, page->errormap_cosine, page->errormap_sine);
        }
#endif
        if (amplitude_T2 < least_T * least_T) {
            fault = HB_FAULT_SENSOR_RANGE;
        }
        jumped = hb_sensing_unwrap(sensing, angle);
        fault = fault ? fault : jumped;
        board->signals.position = positionCounts(sensing);
        board->signals.speed_rad_s =
            hb_speed_update(&board->speed, board->signals.position) * RAD_S_PER_COUNT_TICK;
    }
    if (fault) {
        hb_htm_raise_fault(board, fault);
    }
}

void hb_htm_supervise(hb_htm* board, const hb_htm_calibration* page) {
    hb_safety_limits limits;
    hb_safety_state state;
    uint8_t fault;
    limits.limit_degC = page->limit_temperature;
    limits.speed_rad_s = page->window_speed;
    limits.window_rad = page->window_position;
    limits.speed_enabled = isOn(page->window_speed_enabled);
    limits.window_enabled = isOn(page->window_position_enabled);
    state.temperature_degC[0] = board->sensing.temperature_degC[0];
    state.temperature_degC[1] = board->sensing.temperature_degC[1];
    state.speed_rad_s = board->signals.speed_rad_s;
    if (limits.window_enabled || board->loop_phase == 0) {
        board->excursion_rad = hb_htm_excursion(board);
    }
    state.excursion_rad = board->excursion_rad;
    fault = hb_safety_check(&board->safety, &limits, &state);
    if (fault) {
        hb_htm_raise_fault(board, fault);
    }
}

static hb_law_config lawOf(const hb_htm_calibration* page) {
    hb_law_config config;
    config.law = asInteger(page->law);
    config.kp_A_per_rad = page->kp;
    config.ki_A_per_rad_s = page->ki;
    config.kd_As_per_rad = page->kd;
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

static void startPendingReference(hb_htm* board) {
    uint8_t is_position = board->mode == HB_MODE_POSITION;
    if (!board->reference_pending || (is_position && board->loop_phase != 0)) {
        return;
    }
    board->reference_pending = 0;
    board->reference_started = 1;
    hb_reference_start(&board->reference, &board->live.reference, &board->live.plateaus, is_position);
}

static void controlPosition(hb_htm* board, const hb_htm_calibration* page) {
    hb_law_config config = lawOf(page);
    hb_reference_point point = hb_reference_evaluate(&board->reference);
    hb_law_input input;
    input.position_rad = board->excursion_rad;
    input.reference_rad = point.value + board->live.setpoint;
    input.reference_speed_rad_s = point.speed;
    input.reference_acceleration_rad_s2 = point.acceleration;
    board->command_A = hb_law_step(&board->law, &config, &input);
    board->signals.reference =
        (float)board->origin_turns * HB_TWO_PI + board->origin_angle_rad + input.reference_rad;
    if (!isfinite(board->command_A)) {
        hb_htm_raise_fault(board, HB_FAULT_NOT_FINITE);
    }
}

/* A demand beyond the limit is a mistake of whoever made it: stopping beats bending the test signal. */
static void controlCurrent(hb_htm* board, const hb_htm_calibration* page) {
    float demand = hb_reference_evaluate(&board->reference).value + board->live.setpoint;
    if (!isfinite(demand)) {
        hb_htm_raise_fault(board, HB_FAULT_NOT_FINITE);
    } else if (fabsf(demand) > page->limit_current * LIMIT_ROUNDING) {
        hb_htm_raise_fault(board, HB_FAULT_CURRENT);
    } else {
        board->command_A = demand;
        board->signals.reference = demand;
    }
}

void hb_htm_control(hb_htm* board, const hb_htm_calibration* page) {
    board->reference_started = 0;
    if (!board->safety.armed || board->mode == HB_MODE_IDLE) {
        board->command_A = 0.0F;
        board->signals.reference = 0.0F;
        return;
    }
    startPendingReference(board);
    if (board->mode != HB_MODE_POSITION) {
        controlCurrent(board, page);
    } else if (board->loop_phase == 0) {
        controlPosition(board, page);
    }
}

void hb_htm_commutate(hb_htm* board, const hb_htm_calibration* page) {
    float angle;
    float sine;
    float cosine;
    if (page->commutation_divider > 1.5F && board->safety.armed &&
        board->tick % asInteger(page->commutation_divider) != 0) {
        return;
    }
    if (board->command_A == 0.0F) {
        board->signals.current_A[0] = 0.0F;
        board->signals.current_A[1] = 0.0F;
        return;
    }
    angle = board->sensing.angle_rad;
    if (page->commutation_advance != 0.0F) {
        angle += board->signals.speed_rad_s * page->commutation_advance;
    }
    hb_sine_cosine(angle, &sine, &cosine);
    if (board->mode == HB_MODE_D_AXIS) {
        board->signals.current_A[0] = board->command_A * cosine;
        board->signals.current_A[1] = board->command_A * sine;
    } else {
        board->signals.current_A[0] = -board->command_A * sine;
        board->signals.current_A[1] = board->command_A * cosine;
    }
}
