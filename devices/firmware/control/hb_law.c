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

#if HB_LAW_WEIGHTS
static float proportional(const hb_law_config* config, const hb_law_input* input, float error_rad) {
    (void)error_rad;
    return config->kp_A_per_rad * (config->reference_weight * input->reference_rad - input->position_rad);
}

static float derivative(hb_law* law, const hb_law_config* config, const hb_law_input* input) {
    float weight = config->derivative_reference_weight;
    float weighted = weight * input->reference_rad - input->position_rad;
    float moved = law->started ? weighted - law->previous_weighted_rad : 0.0F;
    float rate = (1.0F - weight) * input->reference_speed_rad_s + moved / config->period_s;
    law->previous_weighted_rad = weighted;
    if (config->derivative_filter_s > 0.0F) {
        rate = (config->derivative_filter_s * law->rate_rad_s + config->period_s * rate) /
               (config->derivative_filter_s + config->period_s);
    }
    law->rate_rad_s = rate;
    return config->kd_As_per_rad * rate;
}
#else
static float proportional(const hb_law_config* config, const hb_law_input* input, float error_rad) {
    (void)input;
    return config->kp_A_per_rad * error_rad;
}

static float derivative(hb_law* law, const hb_law_config* config, const hb_law_input* input) {
    float moved = law->started ? input->position_rad - law->previous_position_rad : 0.0F;
    law->previous_position_rad = input->position_rad;
    return config->kd_As_per_rad * (input->reference_speed_rad_s - moved / config->period_s);
}
#endif

#if HB_LAW_SECTIONS > 0
static float filtered(hb_law* law, const hb_law_config* config, float value) {
    uint8_t i;
    for (i = 0; i < HB_LAW_SECTIONS; ++i) {
        const hb_law_section* section = &config->sections[i];
        float* memory = law->filtered[i];
        float output;
        if (section->a1 == 0.0F) {
            memory[0] = 0.0F;
            memory[1] = 0.0F;
            value = section->b0 * value;
            continue;
        }
        output = section->b0 * value + memory[0];
        memory[0] += memory[1] + (section->b1 * value - section->a1 * output);
        memory[1] += section->b2 * value - section->a2 * output;
        value = output;
    }
    return value;
}
#endif

static float positional(hb_law* law, const hb_law_config* config, const hb_law_input* input) {
    float error = input->reference_rad - input->position_rad;
    float demand = proportional(config, input, error) + law->integral_A + derivative(law, config, input);
    float command;
#if HB_LAW_SECTIONS > 0
    demand = filtered(law, config, demand);
#endif
    demand = demand + feedForward(config, input) + stictionAssist(config, input, error);
    command = clampTo(demand, config->limit_A);
    if ((command == demand && !input->is_saturated) || error * demand < 0.0F) {
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
    law->started = 1;
    return delayed(law, config->delay_samples, command);
}
