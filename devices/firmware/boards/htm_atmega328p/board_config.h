/* SPDX-License-Identifier: MIT */
#ifndef HB_BOARD_HTM_ATMEGA328P_CONFIG_H
#define HB_BOARD_HTM_ATMEGA328P_CONFIG_H

/* What fits into 32 kB of flash and 2 kB of RAM: the A2L and the two pages stay, the capture, the error map,
 * chirp and multisine go. */
#define HB_MAX_CTO 32
#define HB_MAX_DTO 64
#define HB_RING_OCTETS 256
#define HB_DAQ_LISTS 2
#define HB_DAQ_ODTS 4
#define HB_DAQ_ENTRIES 32
#define HB_FEATURE_FULL 0
#define HB_FEATURE_CAPTURE 0
#define HB_FEATURE_ERROR_MAP 0
#define HB_FEATURE_GENERATOR 0
#define HB_FEATURE_STORE 1
#define HB_FEATURE_TEXTS 0
#define HB_FEATURE_TABLE_TRIG 1
#define HB_NUMBER_DIGITS 6
#define HB_PLATEAUS 16
/* With weights and a derivative filter the longest tick takes 83 % of its period. */
#define HB_LAW_WEIGHTS 0
#define HB_LAW_SECTIONS 0
#define HB_SXI_BAUD 115200
#define HB_ACTUATOR hb_htm_actuator

/* The fastest tick that divides the 10 ms of the position loop and whose longest run takes at most 80 % of
 * it: tests/devices/firmware/avr/budget_test.cpp measures. The speed is taken over the same 32 ms as on the
 * full board. */
#define HB_TICK_MS 2
#define HB_SPEED_WINDOW 16

/* The tick is an interrupt. */
void hb_board_lock(void);
void hb_board_unlock(void);
#define HB_LOCK() hb_board_lock()
#define HB_UNLOCK() hb_board_unlock()

#endif
