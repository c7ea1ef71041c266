/* SPDX-License-Identifier: MIT */
#ifndef HB_BOARD_H
#define HB_BOARD_H

/* What every controller board does, whatever it drives: an XCP session over the tables of one actuator, two
 * calibration pages and the copy that a trial falls back to, capture, watchdog, arming, mode changes, stop
 * and faults that stay latched, the count of ticks. An hb_actuator adds how it senses, its limits, its
 * control law and its outputs (resources/help/firmware-guide.md, "A board for another actuator").
 *
 * No safety path depends on the actuator: its outputs lie in memory that the board knows, and the board sets
 * them to zero whenever they may not drive and whenever one is not finite.
 *
 * One tick: take the calibration page, watchdog, sense, supervise, control, drive, capture, measurement. The
 * device clock is the count of ticks times HB_TICK_MS. */

#include "devices/firmware/control/hb_capture.h"
#include "devices/firmware/control/hb_safety.h"
#include "devices/firmware/xcp/hb_xcp.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The other modes are the actuator's, counted from 1. */
enum { HB_MODE_IDLE };

/* Parameters that every board has; part of the actuator's live parameters. */
typedef struct {
    uint16_t watchdog_ms;
    uint8_t arm, mode, stop;
#if HB_FEATURE_TRIAL
    uint8_t trial;
#endif
    uint8_t reference_start;
} hb_board_live;

#if HB_FEATURE_CAPTURE
/* As above. */
typedef struct {
    hb_capture_config config;
    uint8_t start;
} hb_board_capture;
#endif

/* Signals that every board has; part of the actuator's signals. Those of the reference are written by the
 * actuator, the others by the board. */
typedef struct {
    uint32_t torn_count;
    uint32_t capture_time_us;
    uint16_t reference_segment;
    uint8_t status, fault;
    uint8_t reference_running, capture_state;
} hb_board_signals;

/* One actuator: constant, in flash. `context` of the hooks is what hb_board_init() was given, `page` the
 * calibration in force. A hook may do nothing, but none is NULL except `brake` and `written`. Offsets count
 * from the start of the structure named. */
typedef struct {
    const char* model; /* "htm": the name of its description */
    const hb_signal* signals;
    const hb_parameter* parameters;
    const hb_event* events; /* the first is every tick, a second one every `loop_ticks` */
    uint16_t signal_count, parameter_count;
    hb_rom_char* faults;  /* the words of every fault code: "none|coil temperature above its limit|..." */
    uint16_t page_octets; /* of the calibration; its first and last member are the uint32_t marks of a set */
    uint16_t live_octets; /* of the live parameters */
    uint16_t live_offset; /* of hb_board_live in them */
    uint16_t signal_offset; /* of hb_board_signals in the signals */
    uint16_t output_offset; /* of the outputs in the signals: float, all zero = the actuator is passive */
#if HB_FEATURE_CAPTURE
    uint16_t capture_offset; /* of hb_board_capture in the live parameters */
#endif
    uint8_t output_count;
    uint8_t event_count;
    uint8_t loop_ticks; /* ticks between two samples of the control law */
    uint8_t axis_count; /* feedback loops; 0: the device only senses */
#if HB_FEATURE_BRAKE
    /* How an actuator that would glide on comes to rest after it may not drive any more: `brake` writes the
     * outputs and returns 0 when that is over; after `brake_ms` it is over in any case. Bit f of
     * `braking_faults`: fault f leaves the sensors good enough for that. Any other fault: no current at once.
     */
    uint8_t (*brake)(void* context, const void* page);
    uint16_t brake_ms;
    uint32_t braking_faults;
#endif
    /* The state of the actuator from the inputs; may raise faults. Always called. */
    void (*sense)(void* context, const void* page, const void* inputs);
    /* Raises the fault of the first limit that is violated. Always called. */
    void (*supervise)(void* context, const void* page);
    /* The control law; always called, also to follow the reference without driving. */
    void (*control)(void* context, const void* page);
    /* Outputs from what the law demands; called only when the outputs may drive. */
    void (*drive)(void* context, const void* page);
    /* Starts `mode` from the present state: set-points, law and reference at their beginning. */
    void (*enter_mode)(void* context, uint8_t mode);
    /* Before a value is taken; what the table's limits and the board's own rules cannot say. `offset` counts
     * from the live parameters, or is HB_NO_LIVE. HB_OK, or the error to answer. */
    uint8_t (*check)(void* context, uint16_t offset, float value);
    /* A live parameter was taken, `offset` as of `check`; for those that act by themselves. */
    void (*written)(void* context, uint16_t offset);
    void (*stop_reference)(void* context);
    /* One tick of the reference passes; 1 while it runs on. */
    uint8_t (*advance)(void* context);
} hb_actuator;

enum { HB_NO_LIVE = 0xFFFF };

/* The actuator's memory, which the board's tables point into: the caller's, as long as the board lives. */
typedef struct {
    void* context;
    void* pages[2];
#if HB_FEATURE_TRIAL
    void* trial_page; /* what ran when a trial began */
#endif
    void* live;
    void* signals;
} hb_board_memory;

typedef struct {
    const char* device;  /* identity, e.g. "sim-htm-1"; NULL: the model */
    const char* variant; /* appended to the EPK; NULL: nothing */
#if HB_FEATURE_FULL
    const char* transport_a2l; /* A2L block of the line the board is served on; NULL: HB_A2L_TRANSPORT */
    uint16_t max_dto;          /* longest measurement packet that line carries; 0: HB_MAX_DTO */
    hb_signal_table extra;     /* further signals of the caller, e.g. the simulated truth; count 0: none */
    hb_parameter_table extra_parameters; /* likewise, e.g. what a simulated rotor is told to do */
#endif
    /* Stores a page in non-volatile memory: one of hb_store. NULL: SET_REQUEST is answered with an error. */
    uint8_t (*store)(void* context, const void* page);
    void* store_context;
    const void* stored; /* page to start with; NULL: the initial values of the table */
} hb_board_config;

/* Neither copied nor moved once initialised: it holds pointers into itself. */
typedef struct hb_board {
    hb_xcp xcp;
    hb_safety safety;
    const HB_FLASH hb_actuator* actuator;
    void* context;
    hb_board_live* live;
    hb_board_signals* signals;
    float* outputs;
    uint8_t (*store)(void* context, const void* page);
    void* store_context;
    uint32_t tick;      /* number of ticks done */
    uint8_t mode;       /* mode in force; a new one restarts the loop */
    uint8_t loop_phase; /* ticks since the control law's sample */
    uint8_t reference_pending, reference_started;
    uint8_t reference_order; /* number of the last start, so that its repetition is known */
#if HB_FEATURE_BRAKE
    uint16_t brake_ticks; /* left of braking; 0: none */
#endif
#if HB_FEATURE_TRIAL
    void* trial_page;
#endif
#if HB_FEATURE_CAPTURE
    uint8_t capture_order;
    hb_capture capture;
#endif
} hb_board;

/* A build for one actuator names it (HB_ACTUATOR in its board configuration): its hooks are then called
 * directly, which a small processor does faster. */
#ifdef HB_ACTUATOR
extern const HB_FLASH hb_actuator HB_ACTUATOR;
#endif

static inline const HB_FLASH hb_actuator* hb_board_actuator(const hb_board* board) {
#ifdef HB_ACTUATOR
    (void)board;
    return &HB_ACTUATOR;
#else
    return board->actuator;
#endif
}

/* Cannot fail; a NULL config means all defaults. Disarmed, not connected. The hook enter_mode is called once.
 */
void hb_board_init(hb_board* board, const HB_FLASH hb_actuator* actuator, const hb_board_memory* memory,
                   const hb_board_config* config);

/* Every HB_TICK_MS; `inputs` is handed to the hook `sense`. */
void hb_board_tick(hb_board* board, const void* inputs);

/* 1 while the outputs may be other than zero. */
uint8_t hb_board_is_driving(const hb_board* board);

/* Latches the fault, outputs at zero (or braking), tells the master. */
void hb_board_raise_fault(hb_board* board, uint8_t fault);

/* 1 once after the reference was started; its first tick is this one. */
uint8_t hb_board_take_start(hb_board* board);

/* One XCP packet from the master; may be any octets. */
void hb_board_receive(hb_board* board, const uint8_t* packet, uint16_t length);

/* Next packet for the master, 0 if none; HB_MAX_DTO octets always suffice. */
uint16_t hb_board_transmit(hb_board* board, uint8_t* packet, uint16_t capacity);

/* Message counter of the packet taken last, for the transport's CTR field; a gap = samples dropped in the
 * board. */
uint16_t hb_board_counter(const hb_board* board);

#ifdef __cplusplus
}
#endif

#endif
