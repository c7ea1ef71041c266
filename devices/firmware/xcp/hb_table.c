/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_table.h"

#include <float.h>
#include <math.h>
#include <string.h>

void hb_signal_read(const hb_signal* entry, hb_signal* signal) {
    hb_rom_copy(signal, entry, sizeof *signal);
}

void hb_parameter_read(const hb_parameter* entry, hb_parameter* parameter) {
    hb_rom_copy(parameter, entry, sizeof *parameter);
}

HB_NOINLINE hb_rom_char* hb_words_at(hb_rom_char* words, uint8_t count) {
    while (count > 0) {
        count = (uint8_t)(count - (*words == 0));
        words++;
    }
    return words;
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

static uint8_t isSigned(uint8_t type) {
    return type % 2U == 1U && type < HB_FLOAT32;
}

/* Little endian, like the wire; an integer is first widened to 32 bits. */
float hb_value_as_float(uint8_t type, const void* source) {
    uint8_t size = hb_type_size(type);
    uint32_t whole;
    if (type == HB_FLOAT64) {
#if DBL_MANT_DIG == 53
        double wide;
        memcpy(&wide, source, sizeof wide);
        return (float)wide;
#else
        return 0.0F;
#endif
    }
    if (type == HB_FLOAT32) {
        float value;
        memcpy(&value, source, sizeof value);
        return value;
    }
    memset(&whole, isSigned(type) && (((const uint8_t*)source)[size - 1] & 0x80) ? 0xFF : 0, sizeof whole);
    memcpy(&whole, source, size);
    return type == HB_ULONG ? (float)whole : (float)(int32_t)whole;
}

/* Rounded to the nearest and saturated; a float just below a limit of 32 bits does not exist. */
void hb_value_from_float(uint8_t type, void* destination, float value) {
    uint8_t size = hb_type_size(type);
    float magnitude = fabsf(value);
    uint32_t most = UINT32_MAX >> (32 - 8 * size);
    uint32_t whole;
    if (type == HB_FLOAT32) {
        memcpy(destination, &value, sizeof value);
        return;
    }
    if (type > HB_SLONG) {
        return;
    }
    if (isSigned(type)) {
        most >>= 1;
        most += value < 0.0F;
    } else if (value < 0.0F) {
        most = 0;
    }
    whole = magnitude >= (float)most ? most : (uint32_t)(magnitude + 0.5F);
    if (value < 0.0F) {
        whole = (uint32_t)-whole;
    }
    memcpy(destination, &whole, size);
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
        hb_parameter parameter;
        hb_parameter_read(&table[i], &parameter);
        for (hb_extent row = 0; parameter.space == space && row < parameter.rows; row++) {
            hb_value_from_float(parameter.entry.type, (uint8_t*)base + parameter.entry.offset,
                                parameter.initial);
            parameter.entry.offset = (uint16_t)(parameter.entry.offset + hb_type_size(parameter.entry.type));
        }
    }
}
