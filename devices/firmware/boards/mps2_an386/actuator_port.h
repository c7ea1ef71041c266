/* SPDX-License-Identifier: MIT */
#ifndef HB_MPS2_ACTUATOR_PORT_H
#define HB_MPS2_ACTUATOR_PORT_H

/* An actuator's board between the octets of the plant line: each actuator has a folder with its own Port. */

#include "devices/firmware/board/hb_board.h"

#include <stdint.h>

/* Most octets of readings or outputs. */
enum { PORT_ROOM = 64 };

typedef struct {
    uint8_t reading_octets, output_octets;
    /* Called once, before the first tick. */
    hb_board* (*start)(const hb_board_config* config);
    /* One control tick: from the readings of the sensors to the codes of the converters. */
    void (*tick)(const uint8_t* readings, uint8_t* outputs);
} actuator_port;

extern const actuator_port Port;

#endif
