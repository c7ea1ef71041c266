/* SPDX-License-Identifier: MIT */
#include "devices/firmware/control/hb_law.h"

#include <math.h>
#include <string.h>

void hb_law_reset(hb_law* law) {
    memset(law, 0, sizeof *law);
}

static float clampTo(float value, float limit) {
    if (value > limit) {
        return limit;
    }
    return value < -limit ? -limit : value;
}

/* sat(r'/v): the sign with a linear transition; v = 0 is a plain sign. */
static float smoothSign(float speed, float transition) {
    if (speed == 0.0F) {
        return 0.0F;
    }
    if (fabsf(speed) >= transition) {
        return speed > 0.0F ? 1.0F : -1.0F;
    }
    return speed / transition;
}

static float feedForward(const hb_law_config* config, const hb_law_input* input) {
    return config->inertia_As2_per_rad * input->reference_acceleration_rad_s2 +
           config->viscous_As_per_rad * input->reference_speed_rad_s +
           config->coulomb_A * smoothSign(input->reference_speed_rad_s, config->coulomb_speed_rad_s);
}

/* Friction help at rest, only where the loop could not move by itself. */
static float stictionAssist(const hb_law_config* config, const hb_law_input* input, float error_rad) {
    if (fabsf(input->reference_speed_rad_s) < config->stiction_speed_rad_s &&
        fabsf(error_rad) > config->stiction_threshold_rad) {
        return error_rad > 0.0F ? config->stiction_A : -config->stiction_A;
    }
    return 0.0F;
}

static float positional(hb_law* law, const hb_law_config* config, const hb_law_input* input) {
    float error = input->reference_rad - input->position_rad;
    float moved = law->started ? input->position_rad - law->previous_position_rad : 0.0F;
    float demand = config->kp_A_per_rad * error + law->integral_A +
                   config->kd_As_per_rad * (input->reference_speed_rad_s - moved / config->period_s) +
                   feedForward(config, input) + stictionAssist(config, input, error);
    float command = clampTo(demand, config->limit_A);
    if (command == demand || error * demand < 0.0F) {
        law->integral_A += config->period_s * config->ki_A_per_rad_s * error;
    }
    return command;
}

/* i[k] = Kp e[k] - Kp e[k-1] + i[k-1] as printed: no integrator is left in it. Demonstration only. */
static float literal(hb_law* law, const hb_law_config* config, const hb_law_input* input) {
    float error = input->reference_rad - input->position_rad;
    float command;
    law->memory_A += config->kp_A_per_rad * (error - law->previous_error_rad);
    law->previous_error_rad = error;
    command = clampTo(law->memory_A, config->limit_A);
    if (config->law == HB_LAW_LITERAL_CLAMPED) {
        law->memory_A = command;
    }
    return command;
}

static float delayed(hb_law* law, uint8_t samples, float command) {
    float one = law->delayed_A[0];
    float two = law->delayed_A[1];
    law->delayed_A[1] = one;
    law->delayed_A[0] = command;
    if (samples == 0) {
        return command;
    }
    return samples == 1 ? one : two;
}

float hb_law_step(hb_law* law, const hb_law_config* config, const hb_law_input* input) {
    float command =
        config->law == HB_LAW_POSITIONAL ? positional(law, config, input) : literal(law, config, input);
    law->previous_position_rad = input->position_rad;
    law->started = 1;
    return delayed(law, config->delay_samples, command);
}
