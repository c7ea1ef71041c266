/* SPDX-License-Identifier: MIT */
#include "devices/firmware/planar/hb_planar_law.h"

float hb_planar_law_step(float* integral, const hb_planar_gains* gains, const hb_planar_law_input* input,
                         float period_s, uint8_t may_integrate) {
    float error = input->step + input->profile - input->position;
    float effort = gains->kp * (gains->setpoint_weight * input->step + input->profile - input->position) +
                   gains->kd * (input->profile_speed - input->speed) +
                   gains->inertia * input->profile_acceleration + *integral;
    if (may_integrate) {
        *integral += gains->ki * period_s * error;
    }
    return effort;
}
