/* SPDX-License-Identifier: MIT */
#ifndef HB_BOARD_ARDUINO_UNO_CONFIG_H
#define HB_BOARD_ARDUINO_UNO_CONFIG_H

/* The library on a processor with 2 kB of RAM and an HB-SxI line. */
#define HB_MAX_CTO 32
#define HB_MAX_DTO 64
#define HB_RING_OCTETS 256
#define HB_DAQ_LISTS 2
#define HB_DAQ_ODTS 4
#define HB_DAQ_ENTRIES 32
#define HB_FEATURE_FULL 0
#define HB_FEATURE_CAPTURE 0
#define HB_FEATURE_TEXTS 0
#define HB_NUMBER_DIGITS 6
#define HB_SXI_BAUD 115200

#endif
