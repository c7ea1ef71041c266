/* SPDX-License-Identifier: MIT */
#ifndef HB_PLANAR_INTERNAL_H
#define HB_PLANAR_INTERNAL_H

#include "devices/firmware/planar/hb_planar.h"

#ifdef __cplusplus
extern "C" {
#endif

/* hb_planar_tables.c */
extern const HB_FLASH hb_actuator hb_planar_actuator;

/* hb_planar_sense.c: the hooks that look. `planar` is an hb_planar, `page` an hb_planar_calibration. */
void hb_planar_sense(void* planar, const void* page, const void* inputs);
void hb_planar_supervise(void* planar, const void* page);

/* hb_planar_drive.c: the hooks that act. */
void hb_planar_control(void* planar, const void* page);
void hb_planar_drive(void* planar, const void* page);
uint8_t hb_planar_brake(void* planar, const void* page);
void hb_planar_enter_mode(void* planar, uint8_t mode);
uint8_t hb_planar_check(void* planar, uint16_t offset, float value);
void hb_planar_written(void* planar, uint16_t offset);
void hb_planar_stop_reference(void* planar);
uint8_t hb_planar_advance(void* planar);

#ifdef __cplusplus
}
#endif

#endif
