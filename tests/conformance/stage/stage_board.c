/* SPDX-License-Identifier: MIT */
#include "tests/conformance/stage/stage_board.h"

#include "devices/firmware/board/hb_board_tables.h"

#include <math.h>
#include <string.h>

#define TICK_S (0.001F * HB_TICK_MS)

static void sense(void* context, const void* page, const void* inputs) {
    stage_board* stage = (stage_board*)context;
    const float* position = (const float*)inputs;
    (void)page;
    for (int i = 0; i < STAGE_AXES; i++) {
        if (!isfinite(position[i])) {
            hb_board_raise_fault(&stage->board, HB_FAULT_NOT_FINITE);
            return;
        }
        stage->signals.speed[i] =
            stage->board.tick == 0 ? 0.0F : (position[i] - stage->signals.position[i]) / TICK_S;
        stage->signals.position[i] = position[i];
    }
}

static void supervise(void* context, const void* page) {
    stage_board* stage = (stage_board*)context;
    const stage_calibration* set = (const stage_calibration*)page;
    for (int i = 0; i < STAGE_AXES && stage->board.safety.armed; i++) {
        if (set->window_speed_enabled > 0.5F && fabsf(stage->signals.speed[i]) > set->window_speed_m_s) {
            hb_board_raise_fault(&stage->board, HB_FAULT_SPEED);
        }
        if (set->window_position_enabled > 0.5F &&
            fabsf(stage->signals.position[i] - stage->origin[i]) > set->window_m[i]) {
            hb_board_raise_fault(&stage->board, HB_FAULT_POSITION);
        }
    }
}

static float force(stage_board* stage, const stage_calibration* set, int i) {
    const stage_gains* gains = &set->gains[i];
    hb_reference_point point = hb_reference_evaluate(&stage->reference[i]);
    hb_law_config config;
    hb_law_input input;
    memset(&config, 0, sizeof config);
    memset(&input, 0, sizeof input);
    config.kp_A_per_rad = gains->kp;
    config.ki_A_per_rad_s = gains->ki;
    config.kd_As_per_rad = gains->kd;
    config.reference_weight = gains->reference_weight;
    config.derivative_filter_s = gains->derivative_filter_s;
    config.inertia_As2_per_rad = gains->inertia;
    for (int k = 0; k < HB_LAW_SECTIONS; k++) {
        config.sections[k].b0 = 1.0F;
    }
    config.limit_A = STAGE_FORCE_N_PER_A * set->limit_A;
    config.period_s = TICK_S;
    config.delay_samples = (uint8_t)(set->delay_samples + 0.5F);
    input.position_rad = stage->signals.position[i] - stage->origin[i];
    input.reference_rad = stage->live.setpoint[i] + point.value;
    input.reference_speed_rad_s = point.speed;
    input.reference_acceleration_rad_s2 = point.acceleration;
    stage->signals.reference[i] = stage->origin[i] + input.reference_rad;
    return hb_law_step(&stage->law[i], &config, &input);
}

static void control(void* context, const void* page) {
    stage_board* stage = (stage_board*)context;
    uint8_t is_position = stage->board.mode == STAGE_MODE_POSITION;
    static const hb_plateau_config NoPlateaus = {0};
    if (stage->board.mode != HB_MODE_IDLE && hb_board_take_start(&stage->board)) {
        for (int i = 0; i < STAGE_AXES; i++) {
            hb_reference_start(&stage->reference[i], &stage->live.reference[i], &NoPlateaus, is_position);
        }
    }
    stage->signals.board.reference_running = 0;
    for (int i = 0; i < STAGE_AXES; i++) {
        stage->signals.effort[i] =
            is_position ? force(stage, (const stage_calibration*)page, i)
                        : stage->live.setpoint[i] + hb_reference_evaluate(&stage->reference[i]).value;
        stage->signals.board.reference_running |= stage->reference[i].running;
    }
}

static void drive(void* context, const void* page) {
    stage_signals* signals = &((stage_board*)context)->signals;
    float limit_A = ((const stage_calibration*)page)->limit_A;
    for (int i = 0; i < STAGE_AXES; i++) {
        signals->current_A[i] = fminf(fmaxf(signals->effort[i] / STAGE_FORCE_N_PER_A, -limit_A), limit_A);
    }
}

static void enterMode(void* context, uint8_t mode) {
    stage_board* stage = (stage_board*)context;
    (void)mode;
    memcpy(stage->origin, stage->signals.position, sizeof stage->origin);
    memset(stage->live.setpoint, 0, sizeof stage->live.setpoint);
    for (int i = 0; i < STAGE_AXES; i++) {
        hb_law_reset(&stage->law[i]);
        hb_reference_clear(&stage->reference[i]);
    }
}

static uint8_t check(void* context, uint16_t offset, float value) {
    (void)context;
    (void)offset;
    (void)value;
    return HB_OK;
}

static void stopReference(void* context) {
    for (int i = 0; i < STAGE_AXES; i++) {
        hb_reference_stop(&((stage_board*)context)->reference[i]);
    }
}

static uint8_t advance(void* context) {
    stage_board* stage = (stage_board*)context;
    uint8_t runs = 0;
    for (int i = 0; i < STAGE_AXES; i++) {
        hb_reference_advance(&stage->reference[i]);
        runs |= stage->reference[i].running;
    }
    return runs;
}

#define SIGNAL(name, unit, member, text)                                                                     \
    HB_SIGNAL(name, unit, HB_FLOAT32, stage_signals, member, 1.0F, -100.0F, 100.0F, NULL, text)
#define PAIR(a, b, unit, member, text) SIGNAL(a, unit, member[0], text), SIGNAL(b, unit, member[1], text)
static const hb_signal Signals[] = {
    PAIR("position.a", "position.b", "m", position, "Slide"),
    PAIR("speed.a", "speed.b", "m/s", speed, "Slide"),
    PAIR("reference.a", "reference.b", "m", reference, "Reference"),
    PAIR("effort.a", "effort.b", "N", effort, "Force"),
    PAIR("current.a", "current.b", "A", current_A, "Coil"),
    HB_BOARD_SIGNALS(stage_signals, board, HB_STATUS_CHOICES, "none|temperature|current|speed|position",
                     8.0F),
    HB_BOARD_REFERENCE_SIGNALS(stage_signals, board),
    HB_BOARD_CAPTURE_SIGNALS(stage_signals, board),
};

#define PAGED(name, unit, member, initial, upper, text)                                                      \
    HB_PAGED_PARAM(name, unit, stage_calibration, member, initial, 0.0F, upper, NULL, text)
#define AXIS(axis, i)                                                                                        \
    PAGED("gain." axis ".kp", "N/m", gains[i].kp, 100.0F, 1.0e6F, "Proportional gain"),                      \
        PAGED("gain." axis ".ki", "N/(m*s)", gains[i].ki, 0.0F, 1.0e8F, "Integral gain"),                    \
        PAGED("gain." axis ".kd", "N*s/m", gains[i].kd, 10.0F, 1.0e4F, "Derivative gain"),                   \
        PAGED("gain." axis ".reference_weight", "", gains[i].reference_weight, 1.0F, 1.0F, "Weight b"),      \
        PAGED("gain." axis ".derivative_filter", "s", gains[i].derivative_filter_s, 0.0F, 1.0F, "Filter"),   \
        PAGED("feedforward." axis ".inertia", "kg", gains[i].inertia, 0.0F, 100.0F, "Mass"),                 \
        PAGED("window." axis, "m", window_m[i], 0.05F, 1.0F, "Largest excursion")
#define LIVE(name, unit, type, member, initial, lower, upper)                                                \
    HB_LIVE_PARAM(name, unit, stage_live, type, member, initial, lower, upper, NULL, "Generator")
#define REFERENCE(axis, i)                                                                                   \
    LIVE("hb.setpoint." axis, "", HB_FLOAT32, setpoint[i], 0.0F, -10.0F, 10.0F),                             \
        LIVE("reference." axis ".shape", "", HB_UBYTE, reference[i].shape, 0.0F, 0.0F, 6.0F),                \
        LIVE("reference." axis ".amplitude", "", HB_FLOAT32, reference[i].amplitude, 0.0F, -10.0F, 10.0F),   \
        LIVE("reference." axis ".rate", "", HB_FLOAT32, reference[i].rate, 0.0F, -10.0F, 10.0F),             \
        LIVE("reference." axis ".frequency", "Hz", HB_FLOAT32, reference[i].frequency_Hz, 1.0F, 0.0F,        \
             200.0F),                                                                                        \
        LIVE("reference." axis ".duration", "s", HB_FLOAT32, reference[i].duration_s, 1.0F, 0.001F, 1.0e5F), \
        LIVE("reference." axis ".base", "", HB_FLOAT32, reference[i].base, 0.0F, -10.0F, 10.0F)

static const hb_parameter Parameters[] = {
    HB_SET_FIRST(stage_calibration, set_first),
    AXIS("a", 0),
    AXIS("b", 1),
    PAGED("limit.current", "A", limit_A, 2.0F, 4.0F, "Largest current"),
    PAGED("delay.samples", "", delay_samples, 1.0F, 2.0F, "Delay of the currents"),
    PAGED("window.position_enabled", "", window_position_enabled, 1.0F, 1.0F, "Position window"),
    PAGED("window.speed", "m/s", window_speed_m_s, 1.0F, 5.0F, "Largest speed"),
    PAGED("window.speed_enabled", "", window_speed_enabled, 1.0F, 1.0F, "Speed window"),
    HB_SET_LAST(stage_calibration, set_last),
    HB_BOARD_ARM(stage_live, board, "idle|force|position", 2.0F),
    REFERENCE("a", 0),
    REFERENCE("b", 1),
    HB_BOARD_WATCHDOG(stage_live, board),
    HB_BOARD_START(stage_live, board),
    HB_BOARD_CAPTURE(stage_live, capture),
};

static const hb_event Events[] = {{"fast", HB_TICK_MS, 6}};

static const hb_actuator Stage = {
    .model = "stage",
    .signals = Signals,
    .parameters = Parameters,
    .events = Events,
    .signal_count = sizeof Signals / sizeof Signals[0],
    .parameter_count = sizeof Parameters / sizeof Parameters[0],
    .faults = "none|temperature|current|speed|position",
    .page_octets = sizeof(stage_calibration),
    .live_octets = sizeof(stage_live),
    .live_offset = offsetof(stage_live, board),
    .signal_offset = offsetof(stage_signals, board),
    .output_offset = offsetof(stage_signals, current_A),
    .capture_offset = offsetof(stage_live, capture),
    .output_count = STAGE_AXES,
    .event_count = 1,
    .loop_ticks = 1,
    .axis_count = STAGE_AXES,
    .sense = sense,
    .supervise = supervise,
    .control = control,
    .drive = drive,
    .enter_mode = enterMode,
    .check = check,
    .stop_reference = stopReference,
    .advance = advance,
};

void stage_board_init(stage_board* stage, const hb_board_config* config) {
    hb_board_memory memory = {
        stage, {&stage->pages[0], &stage->pages[1]}, &stage->trial_page, &stage->live, &stage->signals};
    memset(stage, 0, sizeof *stage);
    hb_board_init(&stage->board, &Stage, &memory, config);
}
