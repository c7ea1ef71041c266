/* SPDX-License-Identifier: MIT */
#include "tests/conformance/actuator/toy_board.h"

#include "devices/firmware/board/hb_board_tables.h"

#include <math.h>
#include <string.h>

#define WAVE_NUMBER_1_M (6.28318531F / TOY_PITCH_M)

static void sense(void* context, const void* page, const void* inputs) {
    toy_board* toy = (toy_board*)context;
    float position_m = *(const float*)inputs;
    (void)page;
    if (!isfinite(position_m)) {
        hb_board_raise_fault(&toy->board, HB_FAULT_NOT_FINITE);
        return;
    }
    toy->signals.speed_m_s =
        toy->board.tick == 0 ? 0.0F : (position_m - toy->signals.position_m) * (1000.0F / HB_TICK_MS);
    toy->signals.position_m = position_m;
}

static void supervise(void* context, const void* page) {
    toy_board* toy = (toy_board*)context;
    if (toy->board.safety.armed &&
        fabsf(toy->signals.speed_m_s) > ((const toy_calibration*)page)->window_speed_m_s) {
        hb_board_raise_fault(&toy->board, HB_FAULT_SPEED);
    }
}

static void control(void* context, const void* page) {
    toy_board* toy = (toy_board*)context;
    const toy_calibration* set = (const toy_calibration*)page;
    float command_A = 0.0F;
    toy->signals.reference = toy->live.setpoint;
    if (toy->board.mode == TOY_MODE_CURRENT) {
        command_A = toy->live.setpoint;
    } else if (toy->board.mode == TOY_MODE_POSITION) {
        toy->signals.reference = toy->origin_m + toy->live.setpoint;
        command_A = set->kp_A_per_m * (toy->signals.reference - toy->signals.position_m) -
                    set->kd_As_per_m * toy->signals.speed_m_s;
    }
    toy->signals.command_A = fminf(fmaxf(command_A, -set->limit_A), set->limit_A);
}

static void drive(void* context, const void* page) {
    toy_signals* signals = &((toy_board*)context)->signals;
    (void)page;
    signals->current_A[0] = signals->command_A * cosf(WAVE_NUMBER_1_M * signals->position_m);
    signals->current_A[1] = signals->command_A * sinf(WAVE_NUMBER_1_M * signals->position_m);
}

static void enterMode(void* context, uint8_t mode) {
    toy_board* toy = (toy_board*)context;
    (void)mode;
    toy->origin_m = toy->signals.position_m;
    toy->live.setpoint = 0.0F;
}

static uint8_t check(void* context, uint16_t offset, float value) {
    (void)context;
    (void)offset;
    (void)value;
    return HB_OK;
}

static void stopReference(void* context) {
    (void)context;
}

static uint8_t advance(void* context) {
    (void)context;
    return 0;
}

static const hb_signal Signals[] = {
    HB_SIGNAL("position", "m", HB_FLOAT32, toy_signals, position_m, 1.0F, -10.0F, 10.0F, NULL, "Slide"),
    HB_SIGNAL("speed", "m/s", HB_FLOAT32, toy_signals, speed_m_s, 1.0F, -10.0F, 10.0F, NULL, "Slide"),
    HB_SIGNAL("reference", "m", HB_FLOAT32, toy_signals, reference, 1.0F, -10.0F, 10.0F, NULL, "Set-point"),
    HB_SIGNAL("current.a", "A", HB_FLOAT32, toy_signals, current_A[0], 1.0F, -5.0F, 5.0F, NULL, "Coil A"),
    HB_SIGNAL("current.b", "A", HB_FLOAT32, toy_signals, current_A[1], 1.0F, -5.0F, 5.0F, NULL, "Coil B"),
    HB_BOARD_SIGNALS(toy_signals, board, HB_STATUS_CHOICES, "none|temperature|current|speed", 8.0F),
    HB_BOARD_CAPTURE_SIGNALS(toy_signals, board),
};

static const hb_parameter Parameters[] = {
    HB_SET_FIRST(toy_calibration, set_first),
    HB_PAGED_PARAM("gain.kp", "A/m", toy_calibration, kp_A_per_m, 100.0F, 0.0F, 1.0e4F, NULL, "Gain"),
    HB_PAGED_PARAM("gain.kd", "A*s/m", toy_calibration, kd_As_per_m, 5.0F, 0.0F, 1.0e3F, NULL, "Damping"),
    HB_PAGED_PARAM("limit.current", "A", toy_calibration, limit_A, 2.0F, 0.0F, 4.0F, NULL, "Limit"),
    HB_PAGED_PARAM("window.speed", "m/s", toy_calibration, window_speed_m_s, 1.0F, 0.0F, 5.0F, NULL, "Limit"),
    HB_SET_LAST(toy_calibration, set_last),
    HB_BOARD_ARM(toy_live, board, "idle|current|position", 2.0F),
    HB_LIVE_PARAM("hb.setpoint", "", toy_live, HB_FLOAT32, setpoint, 0.0F, -10.0F, 10.0F, NULL, "A or m"),
    HB_BOARD_WATCHDOG(toy_live, board),
    HB_BOARD_CAPTURE(toy_live, capture),
};

static const hb_event Events[] = {{"fast", HB_TICK_MS, 6}};

const hb_actuator toy_actuator = {
    .model = "toy",
    .signals = Signals,
    .parameters = Parameters,
    .events = Events,
    .signal_count = sizeof Signals / sizeof Signals[0],
    .parameter_count = sizeof Parameters / sizeof Parameters[0],
    .faults = "none|temperature|current|speed",
    .page_octets = sizeof(toy_calibration),
    .live_octets = sizeof(toy_live),
    .live_offset = offsetof(toy_live, board),
    .signal_offset = offsetof(toy_signals, board),
    .output_offset = offsetof(toy_signals, current_A),
    .capture_offset = offsetof(toy_live, capture),
    .output_count = 2,
    .event_count = 1,
    .loop_ticks = 1,
    .axis_count = 1,
    .sense = sense,
    .supervise = supervise,
    .control = control,
    .drive = drive,
    .enter_mode = enterMode,
    .check = check,
    .stop_reference = stopReference,
    .advance = advance,
};

void toy_board_init(toy_board* board, const hb_actuator* actuator, const hb_board_config* config) {
    hb_board_memory memory = {
        board, {&board->pages[0], &board->pages[1]}, &board->trial_page, &board->live, &board->signals};
    memset(board, 0, sizeof *board);
    hb_board_init(&board->board, actuator, &memory, config);
}
