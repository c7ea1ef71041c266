/* SPDX-License-Identifier: MIT */
#ifndef HB_HTM_INTERNAL_H
#define HB_HTM_INTERNAL_H

#include "devices/firmware/htm/hb_htm.h"

#ifdef __cplusplus
extern "C" {
#endif

/* hb_htm_tables.c */
extern const HB_FLASH hb_actuator hb_htm_actuator;
enum { HB_HTM_EVENT_FAST, HB_HTM_EVENT_POSITION, HB_HTM_EVENT_COUNT };
enum { HB_HTM_LOOP_TICKS = 10 / HB_TICK_MS };

/* hb_htm_loop.c: the hooks, from the sampled angle to the phase currents. `motor` is an hb_htm, `page` an
 * hb_htm_calibration. */
void hb_htm_sense(void* motor, const void* page, const void* inputs);
void hb_htm_supervise(void* motor, const void* page);
void hb_htm_control(void* motor, const void* page);
void hb_htm_drive(void* motor, const void* page);
uint8_t hb_htm_advance(void* motor);

/* hb_htm.c */
void hb_htm_enter_mode(void* motor, uint8_t mode);
void hb_htm_stop_reference(void* motor);
uint8_t hb_htm_check(void* motor, uint16_t offset, float value);

#ifdef __cplusplus
}
#endif

#endif
