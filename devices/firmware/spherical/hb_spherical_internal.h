/* SPDX-License-Identifier: MIT */
#ifndef HB_SPHERICAL_INTERNAL_H
#define HB_SPHERICAL_INTERNAL_H

#include "devices/firmware/spherical/hb_spherical.h"

#ifdef __cplusplus
extern "C" {
#endif

/* hb_spherical_tables.c */
extern const HB_FLASH hb_actuator hb_spherical_actuator;

/* Hooks; `spherical` is an hb_spherical, `page` an hb_spherical_calibration. */
void hb_spherical_sense(void* spherical, const void* page, const void* inputs);
void hb_spherical_pass(void* spherical, const void* page);
void hb_spherical_enter_mode(void* spherical, uint8_t mode);
uint8_t hb_spherical_check(void* spherical, uint16_t offset, float value);
void hb_spherical_stop_reference(void* spherical);
uint8_t hb_spherical_advance(void* spherical);

#ifdef __cplusplus
}
#endif

#endif
