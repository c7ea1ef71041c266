/* SPDX-License-Identifier: MIT */
#include "devices/firmware/axes/hb_axes.h"

#include <math.h>
#include <string.h>

#define TICK_S (HB_TICK_MS * 0.001F)

static uint8_t axisCount(const hb_axes* axes) {
    return hb_board_actuator(&axes->board)->axis_count;
}

static float clamped(float value, float limit) {
    return fminf(fmaxf(value, -limit), limit);
}

void hb_axes_init(hb_axes* axes, const HB_FLASH hb_actuator* actuator, const hb_board_config* config) {
    hb_board_memory memory;
    memset(axes, 0, sizeof *axes);
    memory.context = axes;
    memory.pages[0] = &axes->pages[0];
    memory.pages[1] = &axes->pages[1];
    memory.trial_page = &axes->trial_page;
    memory.live = &axes->live;
    memory.signals = &axes->signals;
    hb_board_init(&axes->board, actuator, &memory, config);
}

void hb_axes_sense(void* axes, const void* page, const void* inputs) {
    hb_axes* self = (hb_axes*)axes;
    const float* position = (const float*)inputs;
    (void)page;
    for (uint8_t i = 0; i < HB_AXES_MOST; i++) {
        hb_axis_signals* signals = &self->signals.axis[i];
        if (!isfinite(position[i])) {
            hb_board_raise_fault(&self->board, HB_FAULT_NOT_FINITE);
            return;
        }
        /* At power-on nothing is known of a position before. */
        signals->speed = self->board.tick == 0U ? 0.0F : (position[i] - signals->position) / TICK_S;
        signals->position = position[i];
    }
}

void hb_axes_supervise(void* axes, const void* page) {
    hb_axes* self = (hb_axes*)axes;
    const hb_axes_calibration* calibration = (const hb_axes_calibration*)page;
    if (!self->board.safety.armed) {
        return;
    }
    for (uint8_t i = 0; i < axisCount(self); i++) {
        const hb_axis_signals* signals = &self->signals.axis[i];
        const hb_axis_settings* settings = &calibration->axis[i];
        if (fabsf(signals->speed) > settings->window_speed) {
            hb_board_raise_fault(&self->board, HB_FAULT_SPEED);
        } else if (fabsf(signals->position - self->axis[i].origin) > settings->window_position) {
            hb_board_raise_fault(&self->board, HB_FAULT_POSITION);
        }
    }
}

static void startPendingReferences(hb_axes* axes) {
    static const hb_plateau_config NoPlateaus = {0}; /* no shape of ours uses them */
    uint8_t is_position = axes->board.mode == HB_AXES_POSITION;
    if (!hb_board_take_start(&axes->board)) {
        return;
    }
    for (uint8_t i = 0; i < axisCount(axes); i++) {
        const hb_axis_live* live = &axes->live.axis[i];
        hb_axis* axis = &axes->axis[i];
        if (is_position && live->target == HB_AXES_TO_EFFORT) { /* the reference before goes on */
            hb_reference_start(&axis->excitation, &live->reference, &NoPlateaus, 0);
        } else {
            hb_reference_stop(&axis->excitation);
            hb_reference_start(&axis->reference, &live->reference, &NoPlateaus, is_position);
        }
    }
}

static float lawEffort(hb_axes* axes, uint8_t number, const hb_axis_settings* settings,
                       const hb_reference_point* point) {
    hb_axis* axis = &axes->axis[number];
    hb_law_config config;
    hb_law_input input;
    memset(&config, 0, sizeof config);
    memset(&input, 0, sizeof input);
    config.law = HB_LAW_POSITIONAL;
    config.kp_A_per_rad = settings->kp;
    config.ki_A_per_rad_s = settings->ki;
    config.kd_As_per_rad = settings->kd;
#if HB_LAW_WEIGHTS
    config.reference_weight = settings->reference_weight;
    config.derivative_reference_weight = settings->derivative_reference_weight;
    config.derivative_filter_s = settings->derivative_filter_s;
#endif
#if HB_LAW_SECTIONS > 0
    for (uint8_t k = 0; k < HB_LAW_SECTIONS; k++) {
        config.sections[k].b0 = 1.0F; /* no filter */
    }
#endif
    config.limit_A = settings->limit;
    config.period_s = TICK_S;
    input.position_rad = axes->signals.axis[number].position - axis->origin;
    input.reference_rad = point->value;
    input.reference_speed_rad_s = point->speed;
    input.reference_acceleration_rad_s2 = point->acceleration;
    return hb_law_step(&axis->law, &config, &input) + hb_reference_evaluate(&axis->excitation).value;
}

static void controlAxis(hb_axes* axes, uint8_t number, const hb_axis_settings* settings) {
    hb_axis_signals* signals = &axes->signals.axis[number];
    hb_reference_point point = hb_reference_evaluate(&axes->axis[number].reference);
    float effort;
    point.value += axes->live.axis[number].setpoint;
    signals->reference = point.value;
    effort = point.value;
    if (axes->board.mode == HB_AXES_POSITION) {
        signals->reference += axes->axis[number].origin;
        effort = lawEffort(axes, number, settings, &point);
    }
    signals->command = clamped(effort, settings->limit);
}

void hb_axes_control(void* axes, const void* page) {
    hb_axes* self = (hb_axes*)axes;
    const hb_axes_calibration* calibration = (const hb_axes_calibration*)page;
    hb_board_signals* board = &self->signals.board;
    uint8_t is_driving = self->board.safety.armed && self->board.mode != HB_MODE_IDLE;
    board->reference_segment = 0;
    board->reference_running = 0;
    if (is_driving) {
        startPendingReferences(self);
    }
    for (uint8_t i = 0; i < axisCount(self); i++) {
        const hb_axis* axis = &self->axis[i];
        if (is_driving) {
            controlAxis(self, i, &calibration->axis[i]);
        } else {
            self->signals.axis[i].reference = 0.0F;
            self->signals.axis[i].command = 0.0F;
        }
        board->reference_running |= axis->reference.running || axis->excitation.running;
        if (axis->reference.segment > board->reference_segment) {
            board->reference_segment = axis->reference.segment;
        }
    }
}

void hb_axes_drive(void* axes, const void* page) {
    hb_axes* self = (hb_axes*)axes;
    (void)page;
    for (uint8_t i = 0; i < axisCount(self); i++) {
        self->signals.output[i] = self->signals.axis[i].command;
    }
}

void hb_axes_enter_mode(void* axes, uint8_t mode) {
    hb_axes* self = (hb_axes*)axes;
    (void)mode;
    for (uint8_t i = 0; i < axisCount(self); i++) {
        hb_axis* axis = &self->axis[i];
        axis->origin = self->signals.axis[i].position;
        self->live.axis[i].setpoint = 0.0F;
        hb_law_reset(&axis->law);
        hb_reference_clear(&axis->reference);
        hb_reference_clear(&axis->excitation);
    }
}

uint8_t hb_axes_check(void* axes, uint16_t offset, float value) {
    (void)axes;
    (void)offset;
    (void)value;
    return HB_OK; /* the limits of the table say all */
}

void hb_axes_stop_reference(void* axes) {
    hb_axes* self = (hb_axes*)axes;
    for (uint8_t i = 0; i < axisCount(self); i++) {
        hb_axis* axis = &self->axis[i];
        hb_reference_stop(&axis->reference);
        hb_reference_stop(&axis->excitation);
        axis->reference.held.speed = 0.0F;
        axis->reference.held.acceleration = 0.0F;
    }
}

uint8_t hb_axes_advance(void* axes) {
    hb_axes* self = (hb_axes*)axes;
    uint8_t runs = 0;
    for (uint8_t i = 0; i < axisCount(self); i++) {
        hb_reference_advance(&self->axis[i].reference);
        hb_reference_advance(&self->axis[i].excitation);
        runs |= self->axis[i].reference.running || self->axis[i].excitation.running;
    }
    return runs;
}
