/* SPDX-License-Identifier: MIT */
#ifndef HB_BOARD_HTM_OUTPUTS_H
#define HB_BOARD_HTM_OUTPUTS_H

/* The two MCP4725 converters at 0x60 and 0x61, written by interrupts over I2C at 400 kHz. */

#include <stdint.h>

void outputs_start(void);
/* Begins to write both codes (0..4095); it takes 0.15 ms. */
void outputs_write(const uint16_t code[2]);
/* 0 if a converter did not acknowledge since the last call, or the last writing never ended. */
uint8_t outputs_are_well(void);

#endif
