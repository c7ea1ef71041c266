/* SPDX-License-Identifier: MIT */
#ifndef HB_BOARD_TABLES_H
#define HB_BOARD_TABLES_H

/* Rows of the signals and parameters that every board has, for the tables of an actuator. `structure` is the
 * actuator's signals or live parameters, `member` its hb_board_signals, hb_board_live or hb_board_capture. */

#include "devices/firmware/board/hb_board.h"

#define HB_LARGEST_ULONG 4294967296.0F

#define HB_STATUS_CHOICES "idle|armed|stopped by command|stopped by watchdog|fault"
#define HB_SWITCH_CHOICES "off|on"
#if HB_FEATURE_GENERATOR
#define HB_SHAPE_CHOICES "none|step|ramp|sine|staircase|chirp|multisine|plateaus"
#else
#define HB_SHAPE_CHOICES "none|step|ramp|sine|staircase|-|-|plateaus"
#endif

/* A state: whole numbers from 0, some of them with names. */
#define HB_STATE(name, structure, type, member, highest, choices, text)                                      \
    HB_SIGNAL(name, "", type, structure, member, 1.0F, 0.0F, highest, choices, text)
#define HB_LIVE_PARAM(name, unit, structure, type, member, initial, lower, upper, choices, text)             \
    HB_PARAM(HB_LIVE, name, unit, type, structure, member, initial, lower, upper, choices, text)
#define HB_PAGED_PARAM(name, unit, structure, member, initial, lower, upper, choices, text)                  \
    HB_PARAM(HB_PAGED, name, unit, HB_FLOAT32, structure, member, initial, lower, upper, choices, text)

/* First and last row of the calibration. */
#define HB_SET_FIRST(structure, member)                                                                      \
    HB_PARAM(HB_PAGED, "set.first", "", HB_ULONG, structure, member, 0.0F, 0.0F, HB_LARGEST_ULONG, NULL,     \
             "Mark of the transaction, equal to set.last")
#define HB_SET_LAST(structure, member)                                                                       \
    HB_PARAM(HB_PAGED, "set.last", "", HB_ULONG, structure, member, 0.0F, 0.0F, HB_LARGEST_ULONG, NULL,      \
             "Mark of the transaction, equal to set.first")

#define HB_BOARD_SIGNALS(structure, member, status_choices, fault_choices, highest_fault)                    \
    HB_STATE("status", structure, HB_UBYTE, member.status, 4.0F, status_choices, "State of the board"),      \
        HB_STATE("fault", structure, HB_UBYTE, member.fault, highest_fault, fault_choices, "Latched fault"), \
        HB_STATE("torn_count", structure, HB_ULONG, member.torn_count, HB_LARGEST_ULONG, NULL,               \
                 "Control cycles that saw a mixed parameter set")

#define HB_BOARD_REFERENCE_SIGNALS(structure, member)                                                        \
    HB_STATE("reference.segment", structure, HB_UWORD, member.reference_segment, 65535.0F, NULL,             \
             "Step or plateau, 0 = not running"),                                                            \
        HB_STATE("reference.running", structure, HB_UBYTE, member.reference_running, 1.0F, NULL,             \
                 "1 while the generator runs")

#define HB_BOARD_ARM(structure, member, mode_choices, highest_mode)                                          \
    HB_LIVE_PARAM("hb.arm", "", structure, HB_UBYTE, member.arm, 0.0F, 0.0F, 1.0F,                           \
                  HB_WORDS("disarmed|armed"), "Arm the outputs"),                                            \
        HB_LIVE_PARAM("hb.mode", "", structure, HB_UBYTE, member.mode, 0.0F, 0.0F, highest_mode,             \
                      mode_choices, "What the set-point means")

#if HB_FEATURE_TRIAL
#define HB_BOARD_TRIAL(structure, member)                                                                    \
    , HB_LIVE_PARAM("hb.trial", "", structure, HB_UBYTE, member.trial, 0.0F, 0.0F, 1.0F,                     \
                    HB_WORDS(HB_SWITCH_CHOICES), "A lost master brings this calibration back")
#else
#define HB_BOARD_TRIAL(structure, member)
#endif

#define HB_BOARD_WATCHDOG(structure, member)                                                                 \
    HB_LIVE_PARAM("hb.watchdog_ms", "ms", structure, HB_UWORD, member.watchdog_ms, 0.0F, 0.0F,               \
                  HB_LONGEST_WATCHDOG_MS, NULL, "Silence of the host that stops the board"),                 \
        HB_LIVE_PARAM("hb.stop", "", structure, HB_UBYTE, member.stop, 0.0F, 0.0F, 1.0F,                     \
                      HB_WORDS("run|stop"), "Write 1 to stop and latch") HB_BOARD_TRIAL(structure, member)

#define HB_BOARD_START(structure, member)                                                                    \
    HB_LIVE_PARAM("reference.start", "", structure, HB_UBYTE, member.reference_start, 0.0F, 0.0F, 255.0F,    \
                  NULL, "0 stops, 1 starts the generator, 2 to 255 start it once")

#if HB_FEATURE_CAPTURE
#define HB_BOARD_CAPTURE_SIGNALS(structure, member)                                                          \
    HB_STATE("capture.state", structure, HB_UBYTE, member.capture_state, 4.0F,                               \
             HB_WORDS("idle|filling|waiting|running|full"), "State of the capture"),                         \
        HB_SIGNAL("capture.time", "s", HB_ULONG, structure, member.capture_time_us, 1.0e-6F, 0.0F, 4294.97F, \
                  NULL, "Device time of the trigger sample")

#define HB_CAPTURE_CHANNEL(structure, member, number)                                                        \
    HB_LIVE_PARAM("capture.signal_" #number, "", structure, HB_UBYTE, member.config.signal[number - 1],      \
                  255.0F, 0.0F, 255.0F, NULL,                                                                \
                  "Signal of channel " #number " as handle (address/8), 255 = none")

#define HB_BOARD_CAPTURE(structure, member)                                                                  \
    HB_CAPTURE_CHANNEL(structure, member, 1), HB_CAPTURE_CHANNEL(structure, member, 2),                      \
        HB_CAPTURE_CHANNEL(structure, member, 3), HB_CAPTURE_CHANNEL(structure, member, 4),                  \
        HB_LIVE_PARAM("capture.trigger", "", structure, HB_UBYTE, member.config.trigger, 0.0F, 0.0F, 2.0F,   \
                      HB_WORDS("immediate|level|reference start"), "What starts the capture"),               \
        HB_LIVE_PARAM("capture.trigger_signal", "", structure, HB_UBYTE, member.config.trigger_signal, 0.0F, \
                      0.0F, 255.0F, NULL, "Handle of the signal compared with the level"),                   \
        HB_LIVE_PARAM("capture.level", "", structure, HB_FLOAT32, member.config.level, 0.0F, -1.0e6F,        \
                      1.0e6F, NULL, "Level of the trigger"),                                                 \
        HB_LIVE_PARAM("capture.slope", "", structure, HB_UBYTE, member.config.slope, 0.0F, 0.0F, 1.0F,       \
                      HB_WORDS("rising|falling"), "Direction of the crossing"),                              \
        HB_LIVE_PARAM("capture.pretrigger", "", structure, HB_UWORD, member.config.pretrigger, 0.0F, 0.0F,   \
                      4095.0F, NULL, "Samples before the trigger"),                                          \
        HB_LIVE_PARAM("capture.prescaler", "", structure, HB_UWORD, member.config.prescaler, 1.0F, 1.0F,     \
                      1000.0F, NULL, "Milliseconds per sample"),                                             \
        HB_LIVE_PARAM("capture.start", "", structure, HB_UBYTE, member.start, 0.0F, 0.0F, 255.0F, NULL,      \
                      "0 stops, 1 starts the capture, 2 to 255 start it once"),                              \
    {                                                                                                        \
        {-1.0e6F,                                                                                            \
         1.0e6F,                                                                                             \
         HB_WORDS("capture.data\0" HB_TEXT("Captured samples, channel after channel, oldest first")),        \
         NULL,                                                                                               \
         0,                                                                                                  \
         HB_FLOAT32},                                                                                        \
            0.0F, HB_BLOCK, HB_CAPTURE_SAMPLES, HB_CAPTURE_SIGNALS                                           \
    }
#endif

#endif
