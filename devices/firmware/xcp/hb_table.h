/* SPDX-License-Identifier: MIT */
#ifndef HB_TABLE_H
#define HB_TABLE_H

/* What a board's author writes: one table of signals, one of parameters. The library serves the values by
 * handle address, renders the A2L description and enforces the limits from these tables alone
 * (resources/help/protocol.md 3.13). */

#include "devices/firmware/xcp/hb_config.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Integers without sign are even, their twins with sign follow. */
enum hb_type { HB_UBYTE, HB_SBYTE, HB_UWORD, HB_SWORD, HB_ULONG, HB_SLONG, HB_FLOAT32, HB_FLOAT64 };

/* One measured variable: physical value = raw * scale. `choices` names the values 0, 1, 2... ("idle|armed"),
 * or is NULL. `offset` counts from the base pointer of the table, so one table serves many instances. */
typedef struct {
    uint8_t type;
    uint16_t offset;
    float scale;
    float lower, upper; /* physical */
    const char* choices;
#if HB_NUMBER_DIGITS > 6
    const char* digits; /* the scale in decimal, where a float is not exact enough for a host; or NULL */
#endif
} hb_signal_numbers;

typedef struct {
    hb_signal_numbers numbers;
    char name[HB_NAME_CAPACITY];
    char unit[HB_UNIT_CAPACITY];
#if HB_FEATURE_TEXTS
    char text[HB_SIGNAL_TEXT_CAPACITY];
#endif
} hb_signal;

typedef struct {
    const hb_signal* entries;
    uint16_t count;
    const void* base;
} hb_signal_table;

enum hb_space {
    HB_PAGED, /* on the two calibration pages, segment 0: changes as a set, in one control cycle */
    HB_LIVE,  /* plain variable: a write acts at once */
    HB_BLOCK  /* read-only block of float at address extension 2 */
};

#if HB_FEATURE_CAPTURE
typedef uint16_t hb_extent;
#define HB_COLUMNS(columns) columns,
#else
typedef uint8_t hb_extent;
#define HB_COLUMNS(columns)
#endif

/* One parameter. `rows` > 1: so many in a row, called NAME_1, NAME_2, ... (the name leaves room for that); of
 * a HB_BLOCK the size, with `columns`. A finite value outside the limits is clamped, a value that is not
 * finite is refused. */
typedef struct {
    uint8_t type;
    uint8_t space;
    uint16_t offset;
#if HB_FEATURE_CAPTURE
    hb_extent columns; /* 1 for a value */
#endif
    hb_extent rows;
    float initial;
    float lower, upper;
    const char* choices;
} hb_parameter_numbers;

typedef struct {
    hb_parameter_numbers numbers;
    char name[HB_NAME_CAPACITY];
    char unit[HB_UNIT_CAPACITY];
#if HB_FEATURE_TEXTS
    char text[HB_PARAMETER_TEXT_CAPACITY];
#endif
} hb_parameter;

typedef struct {
    char name[12];
    uint8_t cycle;     /* in units of `unit`; 0 = sporadic */
    uint8_t time_unit; /* 6 = 1 ms */
} hb_event;

#if HB_NUMBER_DIGITS > 6
#define HB_DIGITS(digits) , digits
#else
#define HB_DIGITS(digits)
#endif
#define HB_SIGNAL(name, unit, type, structure, member, scale, lower, upper, choices, text)                   \
    {                                                                                                        \
        {type, (uint16_t)offsetof(structure, member), scale, lower, upper, choices HB_DIGITS(NULL)}, name,   \
            unit HB_TEXT(text)                                                                               \
    }
/* A signal whose scale is a literal of double precision without suffix, given to the host in full. */
#define HB_SIGNAL_EXACT(name, unit, type, structure, member, literal, lower, upper, text)                    \
    {                                                                                                        \
        {type,                                                                                               \
         (uint16_t)offsetof(structure, member),                                                              \
         (float)(literal),                                                                                   \
         lower,                                                                                              \
         upper,                                                                                              \
         NULL HB_DIGITS(#literal)},                                                                          \
            name, unit HB_TEXT(text)                                                                         \
    }
#define HB_PARAM(space, name, unit, type, structure, member, initial, lower, upper, choices, text)           \
    {                                                                                                        \
        {                                                                                                    \
            type,  space,  (uint16_t)offsetof(structure, member), HB_COLUMNS(1) 1, initial, lower,           \
            upper, choices},                                                                                 \
            name, unit HB_TEXT(text)                                                                         \
    }

/* `count` values of an array, each with the same name, its number behind it. */
#define HB_PARAM_LIST(space, name, unit, type, structure, member, count, initial, lower, upper, text)        \
    {                                                                                                        \
        {type,  space, (uint16_t)offsetof(structure, member), HB_COLUMNS(1) count, initial, lower,           \
         upper, NULL},                                                                                       \
            name, unit HB_TEXT(text)                                                                         \
    }

/* The numbers of one entry, without its strings. */
void hb_signal_read(const hb_signal* entry, hb_signal_numbers* numbers);
void hb_parameter_read(const hb_parameter* entry, hb_parameter_numbers* numbers);
/* Octets of a value of this type. */
uint8_t hb_type_size(uint8_t type);
/* The value at `source`, which need not be aligned, as float. HB_FLOAT64 reads as 0 on a processor whose
 * double has less than 8 octets. */
float hb_value_as_float(uint8_t type, const void* source);
/* Stores a finite float, rounded and saturated for integers, at `destination`. */
void hb_value_from_float(uint8_t type, void* destination, float value);
/* True for everything except a NaN or an infinity in HB_FLOAT32 and HB_FLOAT64. */
uint8_t hb_value_is_finite(uint8_t type, const void* source);
/* Sets every variable of one space below `base` to its initial value. */
void hb_parameters_reset(const hb_parameter* table, uint16_t count, uint8_t space, void* base);

#ifdef __cplusplus
}
#endif

#endif
