/* SPDX-License-Identifier: MIT */
#include "devices/firmware/planar/hb_planar.h"

#include "devices/firmware/planar/hb_planar_internal.h"

#include <string.h>

static const hb_planar_hardware Published = {10.0F / 65536.0F,          -5.0F,   65535.0F, 200.0F,
                                             65536.0F / 10.0F / 0.506F, 32768.0F};

void hb_planar_init(hb_planar* planar, const hb_planar_hardware* hardware, const hb_board_config* config) {
    hb_board_memory memory;
    memset(planar, 0, sizeof *planar);
    planar->hardware = hardware ? *hardware : Published;
    memory.context = planar;
    memory.pages[0] = &planar->pages[0];
    memory.pages[1] = &planar->pages[1];
#if HB_FEATURE_TRIAL
    memory.trial_page = &planar->trial_page;
#endif
    memory.live = &planar->live;
    memory.signals = &planar->signals;
    hb_board_init(&planar->board, &hb_planar_actuator, &memory, config);
}

void hb_planar_tick(hb_planar* planar, const hb_planar_inputs* inputs, hb_planar_outputs* outputs) {
    hb_board_tick(&planar->board, inputs);
    for (uint8_t k = 0; k < HB_COILS; k++) {
        planar->flowing_A[k] = planar->signals.current_A[k];
        outputs->dac_code[k] =
            planar->signals.current_A[k] * planar->hardware.dac_codes_per_A + planar->hardware.dac_zero_code;
    }
}
