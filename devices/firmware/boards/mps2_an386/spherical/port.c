/* SPDX-License-Identifier: MIT */

/* The sensing board of the spherical motor: nine signed field codes of 16 bit, coil current and temperature
 * as float; nothing is driven. */

#include "devices/firmware/boards/mps2_an386/actuator_port.h"
#include "devices/firmware/spherical/hb_spherical.h"
#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <string.h>

enum { CURRENT = 2 * HB_FIELD_CHANNELS, TEMPERATURE = CURRENT + 4, READING_OCTETS = TEMPERATURE + 4 };

static hb_spherical Spherical;

static hb_board* start(const hb_board_config* config) {
    hb_spherical_init(&Spherical, NULL, config);
    return &Spherical.board;
}

static void tick(const uint8_t* readings, uint8_t* outputs) {
    hb_spherical_inputs inputs;
    (void)outputs;
    for (uint8_t c = 0; c < HB_FIELD_CHANNELS; c++) {
        inputs.field_code[c] = (float)(int16_t)hb_get16(&readings[2U * c]);
    }
    memcpy(&inputs.coil_current_A, &readings[CURRENT], sizeof inputs.coil_current_A);
    memcpy(&inputs.temperature_degC, &readings[TEMPERATURE], sizeof inputs.temperature_degC);
    hb_spherical_tick(&Spherical, &inputs);
}

const actuator_port Port = {READING_OCTETS, 0, start, tick};
