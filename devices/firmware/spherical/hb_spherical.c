/* SPDX-License-Identifier: MIT */
#include "devices/firmware/spherical/hb_spherical.h"

#include "devices/firmware/spherical/hb_spherical_internal.h"

#include <math.h>
#include <string.h>

#define ALL_CHANNELS 0x1FFU
/* Channels that determine the tensor and leave nothing to test it with. */
#define UNTESTED_CHANNELS 5U

static const hb_spherical_hardware Published = {0.6F / 4096.0F, -2048.0F, 2047.0F};

void hb_spherical_init(hb_spherical* spherical, const hb_spherical_hardware* hardware,
                       const hb_board_config* config) {
    hb_board_memory memory;
    memset(spherical, 0, sizeof *spherical);
    spherical->hardware = hardware ? *hardware : Published;
    spherical->signals.orientation.quaternion[0] = 1.0F;
    memory.context = spherical;
    memory.pages[0] = &spherical->pages[0];
    memory.pages[1] = &spherical->pages[1];
#if HB_FEATURE_TRIAL
    memory.trial_page = &spherical->trial_page;
#endif
    memory.live = &spherical->live;
    memory.signals = &spherical->signals;
    hb_board_init(&spherical->board, &hb_spherical_actuator, &memory, config);
}

void hb_spherical_tick(hb_spherical* spherical, const hb_spherical_inputs* inputs) {
    hb_board_tick(&spherical->board, inputs);
}

static float finiteOrZero(float value) {
    return isfinite(value) ? value : 0.0F;
}

/* Fields from the codes; the channels that are finite and not at an end of the range, bit by bit. */
static uint16_t convert(hb_spherical* spherical, const hb_spherical_inputs* inputs) {
    const hb_spherical_hardware* hardware = &spherical->hardware;
    uint16_t good = 0;
    uint16_t off;
    for (uint8_t c = 0; c < HB_FIELD_CHANNELS; c++) {
        float code = inputs->field_code[c];
        uint8_t is_good = isfinite(code) && code > hardware->lowest_code && code < hardware->highest_code;
        good |= (uint16_t)((is_good ? 1U : 0U) << c);
        spherical->signals.field_T[c] = finiteOrZero(code) * hardware->field_T_per_code;
    }
    spherical->signals.coil_current_A = finiteOrZero(inputs->coil_current_A);
    spherical->signals.temperature_degC = finiteOrZero(inputs->temperature_degC);
    off = spherical->live.channels_off;
    return (uint16_t)(good & (unsigned)~(unsigned)off);
}

/* Of two sets of sensors, which hold nothing but float. */
static uint8_t areEqual(const void* one, const void* other) {
    const float* a = (const float*)one;
    const float* b = (const float*)other;
    for (uint16_t i = 0; i < sizeof(hb_field_sensors) / sizeof(float); i++) {
        if (a[i] != b[i]) {
            return 0;
        }
    }
    return 1;
}

/* The least-squares problem changes only with the calibration and the channels. */
static void prepare(hb_spherical* spherical, const hb_spherical_calibration* page, uint16_t used) {
    uint8_t is_same = spherical->is_prepared && spherical->system.used == used &&
                      spherical->prepared_frames == page->frames &&
                      areEqual(&spherical->prepared, &page->sensors);
    if (!is_same) {
        spherical->prepared = page->sensors;
        spherical->prepared_frames = page->frames;
        spherical->is_prepared = 1;
        (void)hb_tensor_prepare(&spherical->system, &page->sensors, (uint8_t)(page->frames + 0.5F), used);
    }
}

static uint8_t integrityOf(const hb_spherical* spherical, const hb_spherical_calibration* page) {
    const hb_spherical_signals* signals = &spherical->signals;
    uint8_t flags = signals->left_out ? HB_INTEGRITY_CHANNEL_LEFT_OUT : 0U;
    if (!signals->is_fresh) {
        return (uint8_t)(flags | HB_INTEGRITY_HELD);
    }
    if (hb_channel_count(spherical->system.used) <= UNTESTED_CHANNELS) {
        flags |= HB_INTEGRITY_UNTESTED;
    }
    if (signals->orientation.chi_square > page->chi_square_limit) {
        flags |= HB_INTEGRITY_RESIDUAL;
    }
    if (fabsf(signals->orientation.strength_T - signals->expected_T) >
        page->strength_tolerance * signals->expected_T) {
        flags |= HB_INTEGRITY_STRENGTH;
    }
    return flags;
}

void hb_spherical_sense(void* spherical, const void* page, const void* inputs) {
    hb_spherical* self = (hb_spherical*)spherical;
    const hb_spherical_calibration* calibration = (const hb_spherical_calibration*)page;
    hb_spherical_signals* signals = &self->signals;
    float corrected_T[HB_FIELD_CHANNELS];
    uint16_t used = convert(self, (const hb_spherical_inputs*)inputs);
    float current_A = calibration->coil_compensation > 0.5F ? signals->coil_current_A : 0.0F;
    prepare(self, calibration, used);
    memcpy(corrected_T, signals->field_T, sizeof corrected_T);
    hb_field_correct(&self->system, &calibration->sensors, current_A, corrected_T);
    signals->left_out = (uint16_t)(ALL_CHANNELS & ~(unsigned)used);
    signals->expected_T =
        calibration->rotor.strength_T *
        (1.0F + calibration->drift_per_K * (signals->temperature_degC - calibration->reference_degC));
    signals->is_fresh = hb_orientation_solve(&self->system, &calibration->sensors, &calibration->rotor,
                                             corrected_T, &signals->orientation);
    signals->integrity = integrityOf(self, calibration);
}

void hb_spherical_pass(void* spherical, const void* page) {
    (void)spherical;
    (void)page;
}

void hb_spherical_enter_mode(void* spherical, uint8_t mode) {
    (void)spherical;
    (void)mode;
}

uint8_t hb_spherical_check(void* spherical, uint16_t offset, float value) {
    (void)spherical;
    (void)offset;
    (void)value;
    return HB_OK;
}

void hb_spherical_stop_reference(void* spherical) {
    (void)spherical;
}

uint8_t hb_spherical_advance(void* spherical) {
    (void)spherical;
    return 0;
}
