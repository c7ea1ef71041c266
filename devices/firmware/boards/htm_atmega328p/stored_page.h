/* SPDX-License-Identifier: MIT */
#ifndef HB_BOARD_HTM_STORED_PAGE_H
#define HB_BOARD_HTM_STORED_PAGE_H

/* The calibration in the EEPROM, in two slots that are written in turn, each with its number and a CRC:
 * whatever interrupts a save, the one before is still whole. The CRC begins with what names the program's
 * tables, so that another program does not take these octets for its own. Octets are written by interrupts,
 * 0.42 s in all. */

#include "devices/firmware/htm/hb_htm.h"

/* The newer page that is whole; NULL if there is none. It stays readable until the next save. */
const hb_htm_calibration* stored_page_load(uint32_t program);
/* Begins to write a copy of the page; 0 while the last one is being written. */
uint8_t stored_page_begin(const hb_htm_calibration* page, uint32_t program);
/* 1 once after each save has ended. */
uint8_t stored_page_take_end(void);

#endif
