/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_table.h"

#include <float.h>
#include <math.h>
#include <string.h>

void hb_signal_read(const hb_signal* entry, hb_signal_numbers* numbers) {
    hb_rom_copy(numbers, &entry->numbers, sizeof *numbers);
}

void hb_parameter_read(const hb_parameter* entry, hb_parameter_numbers* numbers) {
    hb_rom_copy(numbers, &entry->numbers, sizeof *numbers);
}

uint8_t hb_type_size(uint8_t type) {
    switch (type) {
    case HB_UBYTE:
    case HB_SBYTE:
        return 1;
    case HB_UWORD:
    case HB_SWORD:
        return 2;
    case HB_FLOAT64:
        return 8;
    default:
        return 4;
    }
}

typedef union {
    uint8_t u8;
    int8_t s8;
    uint16_t u16;
    int16_t s16;
    uint32_t u32;
    int32_t s32;
    float f32;
#if DBL_MANT_DIG == 53
    double f64;
#endif
} any_value;

float hb_value_as_float(uint8_t type, const void* source) {
    any_value value;
#if DBL_MANT_DIG != 53
    if (type == HB_FLOAT64) {
        return 0.0F;
    }
#endif
    memcpy(&value, source, hb_type_size(type));
    switch (type) {
    case HB_UBYTE:
        return (float)value.u8;
    case HB_SBYTE:
        return (float)value.s8;
    case HB_UWORD:
        return (float)value.u16;
    case HB_SWORD:
        return (float)value.s16;
    case HB_ULONG:
        return (float)value.u32;
    case HB_SLONG:
        return (float)value.s32;
#if DBL_MANT_DIG == 53
    case HB_FLOAT64:
        return (float)value.f64;
#endif
    default:
        return value.f32;
    }
}

/* Whole number next to `value`, saturated to an integer type of `octets` octets; all that is smaller than an
 * ULONG fits into an int32_t. */
static int32_t roundedTo(float value, uint8_t octets, uint8_t is_signed) {
    int32_t highest = INT32_MAX >> (32 - 8 * octets);
    int32_t lowest = is_signed ? -highest - 1 : 0;
    if (!is_signed) {
        highest = 2 * highest + 1;
    }
    if (value <= (float)lowest) {
        return lowest;
    }
    return value >= (float)highest ? highest : (int32_t)floorf(value + 0.5F);
}

static uint32_t roundedToUlong(float value) {
    if (value <= 0.0F) {
        return 0;
    }
    return value >= 4294967296.0F ? UINT32_MAX : (uint32_t)(value + 0.5F);
}

/* Little endian, like the wire. */
void hb_value_from_float(uint8_t type, void* destination, float value) {
    uint32_t whole;
    if (type == HB_FLOAT32) {
        memcpy(destination, &value, sizeof value);
        return;
    }
    if (type > HB_SLONG) {
        return;
    }
    whole =
        type == HB_ULONG ? roundedToUlong(value) : (uint32_t)roundedTo(value, hb_type_size(type), type % 2U);
    memcpy(destination, &whole, hb_type_size(type));
}

uint8_t hb_value_is_finite(uint8_t type, const void* source) {
    /* All exponent bits set means NaN or infinity; little endian, so they are in the last octets. */
    const uint8_t* octets = (const uint8_t*)source;
    if (type == HB_FLOAT32) {
        return (octets[3] & 0x7F) != 0x7F || (octets[2] & 0x80) == 0;
    }
    if (type == HB_FLOAT64) {
        return (octets[7] & 0x7F) != 0x7F || (octets[6] & 0xF0) != 0xF0;
    }
    return 1;
}

void hb_parameters_reset(const hb_parameter* table, uint16_t count, uint8_t space, void* base) {
    for (uint16_t i = 0; i < count; i++) {
        hb_parameter_numbers parameter;
        hb_parameter_read(&table[i], &parameter);
        for (hb_extent row = 0; parameter.space == space && row < parameter.rows; row++) {
            hb_value_from_float(parameter.type, (uint8_t*)base + parameter.offset, parameter.initial);
            parameter.offset = (uint16_t)(parameter.offset + hb_type_size(parameter.type));
        }
    }
}
