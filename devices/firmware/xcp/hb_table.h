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

/* What signals and parameters have in common. `words` are name, unit and, in a build with texts, description,
 * a zero behind each. `choices` names the values 0, 1, 2... ("idle|armed"), or is NULL. `offset` counts from
 * the base pointer of the table, so one table serves many instances. Limits are physical. */
typedef struct {
    float lower, upper;
    hb_rom_char* words;
    hb_rom_char* choices;
    uint16_t offset;
    uint8_t type;
} hb_entry;

/* One measured variable: physical value = raw * scale. */
typedef struct {
    hb_entry entry;
    float scale;
#if HB_NUMBER_DIGITS > 6
    hb_rom_char* digits; /* the scale in decimal, where a float is not exact enough for a host; or NULL */
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
    HB_BLOCK, /* read-only block of float at address extension 2 */
    HB_EXTRA  /* plain variable of a hb_parameter_table */
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
    hb_entry entry;
    float initial;
    uint8_t space;
#if HB_FEATURE_CAPTURE
    hb_extent columns; /* 1 for a value */
#endif
    hb_extent rows;
} hb_parameter;

/* Further plain variables, all of them HB_EXTRA, in memory that holds their values from the start; `octets`
 * of it. */
typedef struct {
    const hb_parameter* entries;
    uint8_t* base;
    uint16_t count;
    uint16_t octets;
} hb_parameter_table;

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
#define HB_ENTRY(name, unit, type, structure, member, lower, upper, choices, text)                           \
    {                                                                                                        \
        lower, upper, HB_WORDS(name "\0" unit HB_TEXT(text)), choices,                                       \
            (uint16_t)offsetof(structure, member), type                                                      \
    }
#define HB_SIGNAL(name, unit, type, structure, member, scale, lower, upper, choices, text)                   \
    { HB_ENTRY(name, unit, type, structure, member, lower, upper, choices, text), scale HB_DIGITS(NULL) }
/* A signal whose scale is a literal of double precision without suffix, given to the host in full. */
#define HB_SIGNAL_EXACT(name, unit, type, structure, member, literal, lower, upper, text)                    \
    {                                                                                                        \
        HB_ENTRY(name, unit, type, structure, member, lower, upper, NULL, text),                             \
            (float)(literal)HB_DIGITS(HB_WORDS(#literal))                                                    \
    }
#define HB_PARAM(space, name, unit, type, structure, member, initial, lower, upper, choices, text)           \
    {                                                                                                        \
        HB_ENTRY(name, unit, type, structure, member, lower, upper, choices, text), initial, space,          \
            HB_COLUMNS(1) 1                                                                                  \
    }

/* `count` values of an array, each with the same name, its number behind it. */
#define HB_PARAM_LIST(space, name, unit, type, structure, member, count, initial, lower, upper, text)        \
    {                                                                                                        \
        HB_ENTRY(name, unit, type, structure, member, lower, upper, NULL, text), initial, space,             \
            HB_COLUMNS(1) count                                                                              \
    }

/* Copies of an entry out of the memory that tables lie in. */
void hb_signal_read(const hb_signal* entry, hb_signal* signal);
void hb_parameter_read(const hb_parameter* entry, hb_parameter* parameter);
/* The text `count` texts behind this one. */
hb_rom_char* hb_words_at(hb_rom_char* words, uint8_t count);
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
