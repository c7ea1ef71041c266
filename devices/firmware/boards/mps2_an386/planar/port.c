/* SPDX-License-Identifier: MIT */

/* The planar positioner: six field codes and six temperature codes in, six current codes out, 16 bit each. */

#include "devices/firmware/boards/mps2_an386/actuator_port.h"
#include "devices/firmware/planar/hb_planar.h"
#include "devices/firmware/xcp/hb_xcp_internal.h"

enum { READINGS = HB_CHIP_FIELDS + HB_COILS };
#define LAST_CODE 65535.0F

static hb_planar Planar;

static hb_board* start(const hb_board_config* config) {
    hb_planar_init(&Planar, NULL, config);
    return &Planar.board;
}

static uint16_t rounded(float code) {
    float limited = code > 0.0F ? code : 0.0F;
    return (uint16_t)((limited < LAST_CODE ? limited : LAST_CODE) + 0.5F);
}

static void tick(const uint8_t* readings, uint8_t* outputs) {
    hb_planar_inputs inputs;
    hb_planar_outputs driven;
    for (uint8_t i = 0; i < HB_CHIP_FIELDS; i++) {
        inputs.field_code[i] = (float)hb_get16(&readings[2U * i]);
    }
    for (uint8_t k = 0; k < HB_COILS; k++) {
        inputs.temperature_code[k] = (float)hb_get16(&readings[2U * (HB_CHIP_FIELDS + (unsigned)k)]);
    }
    hb_planar_tick(&Planar, &inputs, &driven);
    for (uint8_t k = 0; k < HB_COILS; k++) {
        hb_put16(&outputs[2U * k], rounded(driven.dac_code[k]));
    }
}

const actuator_port Port = {2U * READINGS, 2U * HB_COILS, start, tick};
