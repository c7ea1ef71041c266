/* SPDX-License-Identifier: MIT */
#ifndef HB_AXES_TABLES_H
#define HB_AXES_TABLES_H

/* Rows of an actuator of hb_axes.h. `id` is the name of axis number `index` ("x"), `unit` of its position,
 * `effort` of its effort; units of gains are effort/position and so on. */

#include "devices/firmware/axes/hb_axes.h"
#include "devices/firmware/board/hb_board_tables.h"

#define HB_AXES_FAULTS                                                                                       \
    "none|temperature above its limit|current above its limit|speed above its window|position left its "     \
    "window|position jumped|sensor out of range|value not finite|output converter does not answer"

#define HB_AXIS_SIGNAL(name, unit, index, member, text)                                                      \
    HB_SIGNAL(name, unit, HB_FLOAT32, hb_axes_signals, axis[index].member, 1.0F, -1000.0F, 1000.0F, NULL,    \
              text)
#define HB_AXIS_SIGNALS(id, unit, effort, index)                                                             \
    HB_AXIS_SIGNAL("position." id, unit, index, position, "Position"),                                       \
        HB_AXIS_SIGNAL("speed." id, unit "/s", index, speed, "Speed over the last tick"),                    \
        HB_AXIS_SIGNAL("reference." id, unit, index, reference, "Reference, or effort in mode effort"),      \
        HB_AXIS_SIGNAL("effort." id, effort, index, command, "Effort of law and excitation")

/* Those that every board has, behind the axes' own. */
#define HB_AXES_BOARD_SIGNALS                                                                                \
    HB_BOARD_SIGNALS(hb_axes_signals, board, HB_WORDS(HB_STATUS_CHOICES), HB_WORDS(HB_AXES_FAULTS),          \
                     HB_FAULT_COUNT - 1.0F),                                                                 \
        HB_BOARD_REFERENCE_SIGNALS(hb_axes_signals, board), HB_BOARD_CAPTURE_SIGNALS(hb_axes_signals, board)

#define HB_AXIS_SETTING(name, unit, index, member, initial, upper, text)                                     \
    HB_PAGED_PARAM(name, unit, hb_axes_calibration, axis[index].member, initial, 0.0F, upper, NULL, text)
#if HB_LAW_WEIGHTS
#define HB_AXIS_WEIGHTS(id, index)                                                                           \
    HB_AXIS_SETTING("gain." id ".reference_weight", "", index, reference_weight, 1.0F, 1.0F,                 \
                    "Set-point weight b"),                                                                   \
        HB_AXIS_SETTING("gain." id ".derivative_reference_weight", "", index, derivative_reference_weight,   \
                        0.0F, 1.0F, "Set-point weight c"),                                                   \
        HB_AXIS_SETTING("gain." id ".derivative_filter", "s", index, derivative_filter_s, 0.0F, 1.0F,        \
                        "Time constant of the derivative filter"),
#else
#define HB_AXIS_WEIGHTS(id, index)
#endif
#define HB_AXIS_SETTINGS(id, unit, effort, index, kp0, ki0, kd0, limit0, window0, speed0)                    \
    HB_AXIS_SETTING("gain." id ".kp", effort "/" unit, index, kp, kp0, 1.0e6F, "Proportional gain"),         \
        HB_AXIS_SETTING("gain." id ".ki", effort "/(" unit "*s)", index, ki, ki0, 1.0e8F, "Integral gain"),  \
        HB_AXIS_SETTING("gain." id ".kd", effort "*s/" unit, index, kd, kd0, 1.0e4F, "Derivative gain"),     \
        HB_AXIS_WEIGHTS(id, index)                                                                           \
            HB_AXIS_SETTING("limit." id, effort, index, limit, limit0, 1000.0F, "Largest effort"),           \
        HB_AXIS_SETTING("window." id, unit, index, window_position, window0, 1000.0F,                        \
                        "Largest excursion from where the mode began"),                                      \
        HB_AXIS_SETTING("window.speed." id, unit "/s", index, window_speed, speed0, 1000.0F,                 \
                        "Largest speed")

#define HB_AXIS_LIVE(name, unit, type, index, member, initial, lower, upper, choices, text)                  \
    HB_LIVE_PARAM(name, unit, hb_axes_live, type, axis[index].member, initial, lower, upper, choices, text)
#define HB_AXIS_ORDERS(id, index)                                                                            \
    HB_AXIS_LIVE("hb.setpoint." id, "", HB_FLOAT32, index, setpoint, 0.0F, -1000.0F, 1000.0F, NULL,          \
                 "Position from where the mode began, or effort"),                                           \
        HB_AXIS_LIVE("reference." id ".shape", "", HB_UBYTE, index, reference.shape, 0.0F, 0.0F,             \
                     HB_SHAPE_MULTISINE, HB_WORDS(HB_SHAPE_CHOICES), "Shape of the reference"),              \
        HB_AXIS_LIVE("reference." id ".amplitude", "", HB_FLOAT32, index, reference.amplitude, 0.0F,         \
                     -1000.0F, 1000.0F, NULL, "Height of a step, amplitude, end of the ramp"),               \
        HB_AXIS_LIVE("reference." id ".rate", "", HB_FLOAT32, index, reference.rate, 0.0F, -1000.0F,         \
                     1000.0F, NULL, "Slope of the ramp"),                                                    \
        HB_AXIS_LIVE("reference." id ".frequency", "Hz", HB_FLOAT32, index, reference.frequency_Hz, 1.0F,    \
                     0.0F, 200.0F, NULL, "Of sine; first of chirp and multisine"),                           \
        HB_AXIS_LIVE("reference." id ".frequency_end", "Hz", HB_FLOAT32, index, reference.frequency_end_Hz,  \
                     10.0F, 0.0F, 200.0F, NULL, "Last of chirp and multisine"),                              \
        HB_AXIS_LIVE("reference." id ".period", "s", HB_FLOAT32, index, reference.period_s, 1.0F, 0.001F,    \
                     3600.0F, NULL, "Time of one step of the staircase"),                                    \
        HB_AXIS_LIVE("reference." id ".count", "", HB_UWORD, index, reference.count, 10.0F, 1.0F, 1000.0F,   \
                     NULL, "Steps of the staircase, lines of the multisine"),                                \
        HB_AXIS_LIVE("reference." id ".duration", "s", HB_FLOAT32, index, reference.duration_s, 10.0F,       \
                     0.001F, 100000.0F, NULL, "Time until the generator ends"),                              \
        HB_AXIS_LIVE("reference." id ".base", "", HB_FLOAT32, index, reference.base, 0.0F, -1000.0F,         \
                     1000.0F, NULL, "Constant speed added in mode position, else effort"),                   \
        HB_AXIS_LIVE("reference." id ".target", "", HB_UBYTE, index, target, 0.0F, 0.0F, 1.0F,               \
                     HB_WORDS("position|effort"), "Where the reference goes in mode position"),              \
        HB_AXIS_LIVE("reference." id ".seed", "", HB_ULONG, index, reference.seed, 0.0F, 0.0F,               \
                     HB_LARGEST_ULONG, NULL, "Phases of the multisine; 0 = Schroeder")

/* First and last rows of the parameters. */
#define HB_AXES_SET_FIRST HB_SET_FIRST(hb_axes_calibration, set_first)
#define HB_AXES_BOARD_PARAMETERS                                                                             \
    HB_SET_LAST(hb_axes_calibration, set_last),                                                              \
        HB_BOARD_ARM(hb_axes_live, board, HB_WORDS("idle|effort|position"), HB_AXES_POSITION),               \
        HB_BOARD_WATCHDOG(hb_axes_live, board), HB_BOARD_START(hb_axes_live, board),                         \
        HB_BOARD_CAPTURE(hb_axes_live, capture)

/* What the row of an actuator has besides its name, tables and `drive`. */
#define HB_AXES_LAYOUT                                                                                       \
    .faults = HB_WORDS(HB_AXES_FAULTS), .page_octets = sizeof(hb_axes_calibration),                          \
    .live_octets = sizeof(hb_axes_live), .live_offset = offsetof(hb_axes_live, board),                       \
    .signal_offset = offsetof(hb_axes_signals, board), .output_offset = offsetof(hb_axes_signals, output),   \
    .capture_offset = offsetof(hb_axes_live, capture), .loop_ticks = 1
#define HB_AXES_HOOKS                                                                                        \
    .sense = hb_axes_sense, .supervise = hb_axes_supervise, .control = hb_axes_control,                      \
    .enter_mode = hb_axes_enter_mode, .check = hb_axes_check, .stop_reference = hb_axes_stop_reference,      \
    .advance = hb_axes_advance

#endif
