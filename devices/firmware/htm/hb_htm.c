/* SPDX-License-Identifier: MIT */
#include "devices/firmware/htm/hb_htm.h"

#include <string.h>

void hb_htm_init(hb_htm* board, const hb_htm_config* config) {
    memset(board, 0, sizeof *board);
    board->store = config ? config->store : NULL;
}

void hb_htm_fast_tick(hb_htm* board, const hb_htm_inputs* inputs, hb_htm_outputs* outputs) {
    (void)inputs;
    board->tick++;
    memset(outputs, 0, sizeof *outputs);
    outputs->dac_code[0] = outputs->dac_code[1] = 2048;
}

void hb_htm_receive(hb_htm* board, const uint8_t* packet, uint16_t length) {
    (void)board;
    (void)packet;
    (void)length;
}

uint16_t hb_htm_transmit(hb_htm* board, uint8_t* packet, uint16_t capacity) {
    (void)board;
    (void)packet;
    (void)capacity;
    return 0;
}

uint16_t hb_htm_counter(const hb_htm* board) {
    return board->xcp.last_counter;
}
