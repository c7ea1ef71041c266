/* SPDX-License-Identifier: MIT */
#ifndef HB_TEXT_H
#define HB_TEXT_H

/* Numbers as text without printf: the same characters on every machine. Integer arithmetic only. */

#include "devices/firmware/xcp/hb_config.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HB_NUMBER_CAPACITY = 20 };

/* Shortest decimal that reads back as the same float; "0", "-1.5", "2.3968449e-05". With HB_NUMBER_DIGITS 6:
 * six digits and an exponent, "-15e-1". Finite values only. */
void hb_format_float(float value, char text[HB_NUMBER_CAPACITY]);
void hb_format_unsigned(uint32_t value, char text[HB_NUMBER_CAPACITY]);
/* At least `digits` hexadecimal digits. */
void hb_format_hex(uint32_t value, uint8_t digits, char text[HB_NUMBER_CAPACITY]);

#ifdef __cplusplus
}
#endif

#endif
