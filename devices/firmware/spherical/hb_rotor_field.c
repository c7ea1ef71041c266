/* SPDX-License-Identifier: MIT */
#include "devices/firmware/spherical/hb_rotor_field.h"

#include "devices/firmware/spherical/hb_sensor_frames.h"

uint8_t hb_rotor_has_harmonics(const hb_rotor_field* rotor) {
    uint8_t has = 0;
    for (uint8_t i = 0; i < HB_FIELD_HARMONICS; i++) {
        if (rotor->harmonic_T[i] != 0.0F) {
            has = 1;
        }
    }
    return has;
}

/* Adds A/(l+1) [C ((l+m+1) G + z G') n - C G' e_z - G grad C] at the direction n = (x, y, z) of the rotor's
 * frame: the gradient of the potential C(x, y) G(z/r) r^-(l+m+1) with C = Re (x + jy)^m. */
static void addTerm(float scale, float fall_power, const float n[3], const float across[3],
                    const float axial[2], float field[3]) {
    float along = scale * across[0] * (fall_power * axial[0] + n[2] * axial[1]);
    field[0] += along * n[0] - scale * axial[0] * across[1];
    field[1] += along * n[1] - scale * axial[0] * across[2];
    field[2] += along * n[2] - scale * across[0] * axial[1];
}

/* Field of unit distance in the rotor's frame; `fall` = r_ref/r. */
static void harmonicField(const hb_rotor_field* rotor, float fall, const float n[3], float field[3]) {
    float x = n[0];
    float y = n[1];
    float z2 = n[2] * n[2];
    /* Powers of x + jy: 2, 4, 5, 9. */
    float re2 = x * x - y * y;
    float im2 = 2.0F * x * y;
    float re4 = re2 * re2 - im2 * im2;
    float im4 = 2.0F * re2 * im2;
    float re5 = re4 * x - im4 * y;
    float im5 = re4 * y + im4 * x;
    float re9 = re5 * re4 - im5 * im4;
    float im9 = re5 * im4 + im5 * re4;
    const float two[3] = {re2, 2.0F * x, -2.0F * y};
    const float six[3] = {re5 * x - im5 * y, 6.0F * re5, -6.0F * im5};
    const float ten[3] = {re9 * x - im9 * y, 10.0F * re9, -10.0F * im9};
    const float four_two[2] = {7.0F * z2 - 1.0F, 14.0F * n[2]};
    const float six_two[2] = {(33.0F * z2 - 18.0F) * z2 + 1.0F, (132.0F * z2 - 36.0F) * n[2]};
    static const float Constant[2] = {1.0F, 0.0F};
    float fall2 = fall * fall;
    float fall6 = fall2 * fall2 * fall2;
    float fall8 = fall6 * fall2;
    field[0] = 0.0F;
    field[1] = 0.0F;
    field[2] = 0.0F;
    addTerm(rotor->harmonic_T[0] * fall6 / 5.0F, 7.0F, n, two, four_two, field);
    addTerm(rotor->harmonic_T[1] * fall8 / 7.0F, 9.0F, n, two, six_two, field);
    addTerm(rotor->harmonic_T[2] * fall8 / 7.0F, 13.0F, n, six, Constant, field);
    addTerm(rotor->harmonic_T[3] * fall8 * fall2 * fall2 / 11.0F, 21.0F, n, ten, Constant, field);
}

void hb_harmonic_readings(const hb_rotor_field* rotor, const hb_tensor_system* system, float axis[3][3],
                          float reading_T[HB_FIELD_CHANNELS]) {
    for (uint8_t s = 0; s < HB_FIELD_SENSORS; s++) {
        float own[3];
        float field[3];
        float stator[3];
        for (uint8_t k = 0; k < 3; k++) {
            own[k] = hb_dot(axis[k], system->place[s]);
        }
        harmonicField(rotor, system->fall[s], own, field);
        for (uint8_t i = 0; i < 3; i++) {
            stator[i] = field[0] * axis[0][i] + field[1] * axis[1][i] + field[2] * axis[2][i];
        }
        for (uint8_t k = 0; k < 3; k++) {
            reading_T[3U * s + k] = hb_dot(system->axis[3U * s + k], stator);
        }
    }
}
