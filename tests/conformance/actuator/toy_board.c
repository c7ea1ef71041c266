/* SPDX-License-Identifier: MIT */
#include "tests/conformance/actuator/toy_board.h"

#include "devices/firmware/axes/hb_axes_tables.h"

static const hb_signal Signals[] = {
    HB_AXIS_SIGNALS("x", "m", "A", 0),
    HB_AXIS_SIGNALS("y", "m", "A", 1),
    HB_AXES_BOARD_SIGNALS,
};

static const hb_parameter Parameters[] = {
    HB_AXES_SET_FIRST,
    HB_AXIS_SETTINGS("x", "m", "A", 0, 100.0F, 0.0F, 5.0F, 2.0F, 0.1F, 1.0F),
    HB_AXIS_SETTINGS("y", "m", "A", 1, 100.0F, 0.0F, 5.0F, 2.0F, 0.1F, 1.0F),
    HB_AXES_BOARD_PARAMETERS,
    HB_AXIS_ORDERS("x", 0),
    HB_AXIS_ORDERS("y", 1),
};

static const hb_event Events[] = {{"fast", HB_TICK_MS, 6}};

const hb_actuator toy_actuator = {
    .model = "toy",
    .signals = Signals,
    .parameters = Parameters,
    .events = Events,
    .signal_count = sizeof Signals / sizeof Signals[0],
    .parameter_count = sizeof Parameters / sizeof Parameters[0],
    .event_count = 1,
    .axis_count = 2,
    .output_count = 2,
    HB_AXES_LAYOUT,
    HB_AXES_HOOKS,
    .drive = hb_axes_drive,
};
