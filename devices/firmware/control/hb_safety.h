/* SPDX-License-Identifier: MIT */
#ifndef HB_SAFETY_H
#define HB_SAFETY_H

/* Arm, stop, fault: latched until reset (resources/help/protocol.md 3.11, 3.15). */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hb_fault {
    HB_FAULT_NONE,
    HB_FAULT_TEMPERATURE,
    HB_FAULT_CURRENT,
    HB_FAULT_SPEED,
    HB_FAULT_POSITION,
    HB_FAULT_ANGLE_JUMPED,
    HB_FAULT_SENSOR_RANGE,
    HB_FAULT_NOT_FINITE,
    HB_FAULT_OUTPUT, /* a converter that drives an output does not answer */
    HB_FAULT_COUNT
};

/* A master that is gone is noticed after this time at the latest. */
#define HB_LONGEST_WATCHDOG_MS 2000.0F

enum hb_latch { HB_LATCH_NONE, HB_LATCH_COMMAND, HB_LATCH_WATCHDOG, HB_LATCH_FAULT };

enum hb_status { HB_STATUS_IDLE, HB_STATUS_ARMED, HB_STATUS_STOPPED, HB_STATUS_WATCHDOG, HB_STATUS_FAULT };

typedef struct {
    uint8_t armed;
    uint8_t stop;  /* HB_LATCH_NONE, HB_LATCH_COMMAND or HB_LATCH_WATCHDOG */
    uint8_t fault; /* the first one since the reset */
} hb_safety;

typedef struct {
    float limit_degC, speed_rad_s, window_rad;
    uint8_t speed_enabled, window_enabled;
} hb_safety_limits;

typedef struct {
    float temperature_degC[2], speed_rad_s, excursion_rad; /* excursion since arming */
} hb_safety_state;

void hb_safety_init(hb_safety* safety);
/* 1 if armed now; refused while a stop or fault is latched. */
uint8_t hb_safety_arm(hb_safety* safety);
void hb_safety_disarm(hb_safety* safety);
/* Disarms and latches; the first latch stays. Returns the latch code. */
uint8_t hb_safety_stop(hb_safety* safety, uint8_t latch);
void hb_safety_fault(hb_safety* safety, uint8_t fault);
void hb_safety_reset(hb_safety* safety);
uint8_t hb_safety_status(const hb_safety* safety);
uint8_t hb_safety_latch(const hb_safety* safety);
/* The first limit violated, or HB_FAULT_NONE. Speed and position count only while armed. */
uint8_t hb_safety_check(const hb_safety* safety, const hb_safety_limits* limits,
                        const hb_safety_state* state);

#ifdef __cplusplus
}
#endif

#endif
