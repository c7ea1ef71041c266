/* SPDX-License-Identifier: MIT */
#include "devices/firmware/control/hb_reference.h"

#include "devices/firmware/control/hb_constants.h"
#include "devices/firmware/control/hb_trig.h"

#include <math.h>
#include <string.h>

#define TICK_S (0.001F * HB_TICK_MS)

static uint32_t ticksOf(float seconds) {
    return (uint32_t)(seconds * (1000.0F / HB_TICK_MS) + 0.5F);
}

#if HB_FEATURE_GENERATOR

/* Phases count in units of 2^-32/1000 turn, so that a frequency in Hz moves a whole number of them each
 * tick: a sine of hours does not drift against its frequency. */
#define PHASE_PER_HZ 4294967296.0F
#define PHASE_TURN ((uint64_t)1000 << 32)

static hb_phase advanced(hb_phase phase, float frequency_Hz) {
    uint32_t whole_Hz = (uint32_t)frequency_Hz;
    /* Exact, and without 64 bit floating point arithmetic. */
    uint64_t step = ((uint64_t)whole_Hz << 32) + (uint32_t)((frequency_Hz - (float)whole_Hz) * PHASE_PER_HZ);
    phase += step * HB_TICK_MS;
    return phase >= PHASE_TURN ? phase - PHASE_TURN : phase;
}

/* As (float)value, rounded once; compilers for a processor without double precision make a long call of that.
 * Below 2^41. */
static float rounded(uint64_t value) {
    uint8_t shift = 0;
    uint32_t kept;
    while ((value >> shift) > 0xFFFFFFFFU) {
        shift++;
    }
    kept = (uint32_t)(value >> shift);
    kept |= ((uint64_t)kept << shift) != value ? 1U : 0U; /* what is cut off decides a tie */
    return (float)kept * (float)(1UL << shift);
}

static float radiansOf(hb_phase phase) {
    uint8_t is_behind = phase > PHASE_TURN / 2U;
    float size = rounded(is_behind ? PHASE_TURN - phase : phase);
    return (is_behind ? -size : size) * (HB_TWO_PI / (1000.0F * PHASE_PER_HZ));
}

#else

/* Units of 2^-32 turn without 64 bit arithmetic: a sine of 1 Hz drifts by 1e-7 of its phase. */
static hb_phase advanced(hb_phase phase, float frequency_Hz) {
    return phase + (uint32_t)(frequency_Hz * (4294967.296F * HB_TICK_MS) + 0.5F);
}

static float radiansOf(hb_phase phase) {
    return (float)(int32_t)phase * (HB_TWO_PI / 4294967296.0F);
}

#endif

static const hb_plateau_config* plateausOf(const hb_reference* reference) {
#if HB_FEATURE_GENERATOR
    return &reference->plateaus;
#else
    return reference->plateaus;
#endif
}

static uint32_t durationTicks(const hb_reference* reference) {
    const hb_reference_config* config = &reference->config;
    if (config->shape == HB_SHAPE_STAIRCASE) {
        return config->count * ticksOf(config->period_s);
    }
    if (config->shape == HB_SHAPE_PLATEAUS) {
        return plateausOf(reference)->count * ticksOf(plateausOf(reference)->dwell_s);
    }
    return ticksOf(config->duration_s);
}

#if HB_FEATURE_GENERATOR

static uint16_t lineCount(const hb_reference_config* config) {
    return config->count < HB_MULTISINE_LINES ? config->count : HB_MULTISINE_LINES;
}

static float lineFrequency(const hb_reference_config* config, uint16_t line) {
    uint16_t lines = lineCount(config);
    if (lines < 2) {
        return config->frequency_Hz;
    }
    return config->frequency_Hz +
           (config->frequency_end_Hz - config->frequency_Hz) * (float)line / (float)(lines - 1);
}

static uint32_t xorshift(uint32_t state) {
    state ^= state << 13;
    state ^= state >> 17;
    return state ^ (state << 5);
}

/* Schroeder phases keep the peak near 1.7 times the rms value; k (k-1)/count is taken modulo two half turns.
 */
static void startMultisine(hb_reference* reference) {
    uint16_t lines = lineCount(&reference->config);
    uint32_t state = reference->config.seed;
    for (uint16_t line = 0; line < lines; line++) {
        uint32_t half_turns = (2U * lines - ((uint32_t)line * (line + 1U)) % (2U * lines)) % (2U * lines);
        state = xorshift(state);
        reference->line_phase[line] =
            reference->config.seed ? (uint64_t)state * 1000U : PHASE_TURN / (2U * lines) * half_turns;
    }
}

static hb_reference_point multisine(const hb_reference* reference) {
    hb_reference_point point = {0.0F, 0.0F, 0.0F};
    uint16_t lines = lineCount(&reference->config);
    float scale = reference->config.amplitude / sqrtf((float)lines);
    for (uint16_t line = 0; line < lines; line++) {
        float phase = radiansOf(reference->line_phase[line]);
        float omega = HB_TWO_PI * lineFrequency(&reference->config, line);
        float sine_now;
        float cosine_now;
        float value;
        hb_sine_cosine(phase, &sine_now, &cosine_now);
        value = scale * sine_now;
        point.value += value;
        if (reference->holds_position) {
            point.speed += omega * scale * cosine_now;
            point.acceleration -= omega * omega * value;
        }
    }
    return point;
}

static float chirpFrequency(const hb_reference* reference, float time_s) {
    const hb_reference_config* config = &reference->config;
    return config->frequency_Hz +
           (config->frequency_end_Hz - config->frequency_Hz) * time_s / config->duration_s;
}

static hb_reference_point chirp(const hb_reference* reference, float time_s) {
    hb_reference_point point;
    float amplitude = reference->config.amplitude;
    float phase = radiansOf(reference->phase);
    float omega = HB_TWO_PI * chirpFrequency(reference, time_s);
    float slope = HB_TWO_PI * (reference->config.frequency_end_Hz - reference->config.frequency_Hz) /
                  reference->config.duration_s;
    point.value = amplitude * sinf(phase);
    point.speed = amplitude * omega * cosf(phase);
    point.acceleration = slope * amplitude * cosf(phase) - omega * omega * point.value;
    return point;
}

#endif

static float plateau(hb_reference* reference) {
    uint32_t dwell = ticksOf(plateausOf(reference)->dwell_s);
    uint32_t index = reference->ticks / dwell;
    if (index >= plateausOf(reference)->count) {
        index = plateausOf(reference)->count - 1U;
    }
    reference->segment = (uint16_t)(index + 1U);
    return plateausOf(reference)->current_A[index];
}

static hb_reference_point ramp(const hb_reference_config* config, float time_s) {
    hb_reference_point point = {config->rate * time_s, config->rate, 0.0F};
    float end = fabsf(config->amplitude);
    if (end > 0.0F && fabsf(point.value) >= end) {
        point.value = config->rate > 0.0F ? end : -end;
        point.speed = 0.0F;
    }
    return point;
}

static hb_reference_point sine(const hb_reference* reference) {
    hb_reference_point point;
    float omega = HB_TWO_PI * reference->config.frequency_Hz;
    float sine_now;
    float cosine_now;
    hb_sine_cosine(radiansOf(reference->phase), &sine_now, &cosine_now);
    point.value = reference->config.amplitude * sine_now;
    point.speed = reference->config.amplitude * omega * cosine_now;
    point.acceleration = -omega * omega * point.value;
    return point;
}

static float staircase(hb_reference* reference) {
    uint32_t steps = reference->ticks / ticksOf(reference->config.period_s) + 1U;
    if (steps > reference->config.count) {
        steps = reference->config.count;
    }
    reference->segment = (uint16_t)steps;
    return reference->config.amplitude * (float)steps;
}

static hb_reference_point shapePoint(hb_reference* reference, float time_s) {
    hb_reference_point point = {0.0F, 0.0F, 0.0F};
    switch (reference->config.shape) {
    case HB_SHAPE_STEP:
        point.value = reference->config.amplitude;
        break;
    case HB_SHAPE_RAMP:
        return ramp(&reference->config, time_s);
    case HB_SHAPE_SINE:
        return sine(reference);
    case HB_SHAPE_STAIRCASE:
        point.value = staircase(reference);
        break;
#if HB_FEATURE_GENERATOR
    case HB_SHAPE_CHIRP:
        return chirp(reference, time_s);
    case HB_SHAPE_MULTISINE:
        return multisine(reference);
#endif
    case HB_SHAPE_PLATEAUS:
        point.value = plateau(reference);
        break;
    default:
        break;
    }
    return point;
}

void hb_reference_start(hb_reference* reference, const hb_reference_config* config,
                        const hb_plateau_config* plateaus, uint8_t is_position) {
    /* Where the reference before stands or is held. */
    reference->from = is_position ? hb_reference_evaluate(reference).value : 0.0F;
    reference->config = *config;
    reference->holds_position = is_position;
    reference->ticks = 0;
    reference->phase = 0;
    reference->segment = 1;
    reference->running = 1;
#if HB_FEATURE_GENERATOR
    reference->plateaus = *plateaus;
    if (config->shape == HB_SHAPE_MULTISINE) {
        startMultisine(reference);
    }
#else
    reference->plateaus = plateaus;
#endif
    reference->duration_ticks = durationTicks(reference);
}

void hb_reference_clear(hb_reference* reference) {
    memset(reference, 0, sizeof *reference);
}

hb_reference_point hb_reference_evaluate(hb_reference* reference) {
    float time_s = (float)reference->ticks * TICK_S;
    hb_reference_point point;
    if (!reference->running) {
        return reference->held;
    }
    point = shapePoint(reference, time_s);
    if (reference->holds_position) {
        point.value += reference->from + reference->config.base * time_s;
        point.speed += reference->config.base;
    } else {
        point.value += reference->config.base;
    }
    return point;
}

void hb_reference_stop(hb_reference* reference) {
    hb_reference_point rest = {0.0F, 0.0F, 0.0F};
    if (!reference->running) {
        return;
    }
    if (reference->holds_position) {
        rest.value = hb_reference_evaluate(reference).value;
    }
    reference->held = rest;
    reference->running = 0;
    reference->segment = 0;
}

/* The frequency at the middle of the tick makes the sum of a linear sweep exact. */
static void advancePhases(hb_reference* reference) {
    const hb_reference_config* config = &reference->config;
    if (config->shape == HB_SHAPE_SINE) {
        reference->phase = advanced(reference->phase, config->frequency_Hz);
    }
#if HB_FEATURE_GENERATOR
    if (config->shape == HB_SHAPE_CHIRP) {
        float middle_s = ((float)reference->ticks + 0.5F) * TICK_S;
        reference->phase = advanced(reference->phase, chirpFrequency(reference, middle_s));
    } else if (config->shape == HB_SHAPE_MULTISINE) {
        for (uint16_t line = 0; line < lineCount(config); line++) {
            reference->line_phase[line] = advanced(reference->line_phase[line], lineFrequency(config, line));
        }
    }
#endif
}

void hb_reference_advance(hb_reference* reference) {
    if (!reference->running) {
        return;
    }
    advancePhases(reference);
    reference->ticks++;
    if (reference->ticks >= reference->duration_ticks) {
        hb_reference_stop(reference);
    }
}
