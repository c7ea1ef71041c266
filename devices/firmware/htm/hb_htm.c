/* SPDX-License-Identifier: MIT */
#include "devices/firmware/htm/hb_htm.h"

#include "devices/firmware/htm/hb_htm_internal.h"

#include <math.h>
#include <string.h>

#define DAC_CODES_PER_A 409.6F /* 4096 codes, 5 V, 2 A/V */
#define DAC_MIDDLE 2048.0F
#define DAC_HIGHEST 4095.0F

static uint8_t drivesCurrent(const hb_htm* motor) {
    return motor->board.safety.armed &&
           (motor->board.mode == HB_MODE_CURRENT || motor->board.mode == HB_MODE_D_AXIS);
}

uint8_t hb_htm_check(void* motor, uint16_t offset, float value) {
    const hb_htm* self = (const hb_htm*)motor;
#if !HB_FEATURE_GENERATOR
    if (offset == offsetof(hb_htm_live, reference.shape) &&
        (value == (float)HB_SHAPE_CHIRP || value == (float)HB_SHAPE_MULTISINE)) {
        return HB_ERR_OUT_OF_RANGE;
    }
#endif
    if (offset == offsetof(hb_htm_live, board.arm) && value > 0.5F && !self->sensing.started) {
        return HB_ERR_BUSY; /* the position to start from is not known yet */
    }
    if (offset == offsetof(hb_htm_live, setpoint) && drivesCurrent(self) &&
        fabsf(value) > self->pages[self->board.xcp.active_page].limit_current) {
        return HB_ERR_OUT_OF_RANGE;
    }
    return HB_OK;
}

void hb_htm_enter_mode(void* motor, uint8_t mode) {
    hb_htm* self = (hb_htm*)motor;
    (void)mode;
    self->origin_turns = self->sensing.turns;
    self->origin_angle_rad = self->sensing.angle_rad;
    self->signals.current_command_A = 0.0F;
    self->live.setpoint = 0.0F;
    hb_law_reset(&self->law);
    hb_reference_clear(&self->reference);
}

void hb_htm_stop_reference(void* motor) {
    hb_reference_stop(&((hb_htm*)motor)->reference);
}

void hb_htm_init(hb_htm* motor, const hb_htm_config* config) {
    hb_board_memory memory;
    memset(motor, 0, sizeof *motor);
    memory.context = motor;
    memory.pages[0] = &motor->pages[0];
    memory.pages[1] = &motor->pages[1];
#if HB_FEATURE_TRIAL
    memory.trial_page = &motor->trial_page;
#endif
    memory.live = &motor->live;
    memory.signals = &motor->signals;
    hb_sensing_init(&motor->sensing);
    hb_speed_init(&motor->speed);
    hb_board_init(&motor->board, &hb_htm_actuator, &memory, config);
}

static uint16_t dacCode(float current_A) {
    float code = current_A * DAC_CODES_PER_A + DAC_MIDDLE;
    if (code <= 0.0F) {
        return 0;
    }
    return (uint16_t)(code >= DAC_HIGHEST ? DAC_HIGHEST : code + 0.5F);
}

void hb_htm_fast_tick(hb_htm* motor, const hb_htm_inputs* inputs, hb_htm_outputs* outputs) {
    hb_board_tick(&motor->board, inputs);
    for (uint8_t i = 0; i < 2; i++) {
        outputs->phase_current_A[i] = motor->signals.current_A[i];
        outputs->dac_code[i] = dacCode(motor->signals.current_A[i]);
        motor->flowing_A[i] = motor->signals.current_A[i];
    }
    outputs->current_command_A = motor->signals.current_command_A;
    outputs->output_enabled = hb_board_is_driving(&motor->board);
}
