/* SPDX-License-Identifier: MIT */
#ifndef HB_HTM_INTERNAL_H
#define HB_HTM_INTERNAL_H

#include "devices/firmware/htm/hb_htm.h"

#ifdef __cplusplus
extern "C" {
#endif

/* hb_htm_tables.c */
extern const hb_signal hb_htm_signal_table[];
extern const uint16_t hb_htm_signal_count;
extern const hb_parameter hb_htm_parameter_table[];
extern const uint16_t hb_htm_parameter_count;
extern const hb_event hb_htm_event_table[];
enum { HB_HTM_EVENT_FAST, HB_HTM_EVENT_POSITION, HB_HTM_EVENT_COUNT };
/* The words of a fault: HB_ROM text up to its end or to '|'. */
hb_rom_char* hb_htm_fault_text(uint8_t fault);

/* hb_htm_drive.c: arming and its opposite. */
/* Starts the mode in force from the present position with set-points at zero. */
void hb_htm_enter_mode(hb_htm* board, uint8_t mode);
void hb_htm_arm(hb_htm* board);
/* Every output and set-point to zero; what is latched stays latched. */
void hb_htm_release(hb_htm* board);
uint8_t hb_htm_stop(hb_htm* board, uint8_t latch);
#if HB_FEATURE_TRIAL
/* hb.trial = 1 keeps a copy of the calibration. When the master is lost before it wrote 0 again (watchdog,
 * disconnect, a new connection) the copy runs again, so that nobody finds half-tried gains. */
void hb_htm_begin_trial(hb_htm* board);
void hb_htm_abandon_trial(hb_htm* board);
#endif

/* hb_htm_loop.c: one tick from the sampled angle to the phase currents. */
void hb_htm_sense(hb_htm* board, const hb_htm_calibration* page, const hb_htm_inputs* inputs);
void hb_htm_supervise(hb_htm* board, const hb_htm_calibration* page);
void hb_htm_control(hb_htm* board, const hb_htm_calibration* page);
void hb_htm_commutate(hb_htm* board, const hb_htm_calibration* page);
/* Rotor angle since arming, rad. */
float hb_htm_excursion(const hb_htm* board);

#ifdef __cplusplus
}
#endif

#endif
