/* SPDX-License-Identifier: MIT */
#ifndef HB_CONFIG_H
#define HB_CONFIG_H

#include <stdint.h>

/* Sizes and features of one build. A small board defines HB_BOARD_CONFIG (a quoted header name) on the
 * compiler's command line and overrides any of these there. The values below are the full build. */
#ifdef HB_BOARD_CONFIG
#include HB_BOARD_CONFIG
#endif

#ifndef HB_MAX_CTO
#define HB_MAX_CTO 255 /* longest command and response, octets (8..255) */
#endif
#ifndef HB_MAX_DTO
#define HB_MAX_DTO 508 /* longest measurement packet: with a 4 octet header a datagram of 512 octets */
#endif
#ifndef HB_RING_OCTETS
#define HB_RING_OCTETS 32768 /* transmit queue; a power of two, at most 32768 */
#endif
#ifndef HB_DAQ_LISTS
#define HB_DAQ_LISTS 8
#endif
#ifndef HB_DAQ_ODTS
#define HB_DAQ_ODTS 64
#endif
#ifndef HB_DAQ_ENTRIES
#define HB_DAQ_ENTRIES 512
#endif
#ifndef HB_FEATURE_FULL
#define HB_FEATURE_FULL 1 /* commands marked F in resources/help/protocol.md 3.5 */
#endif
#ifndef HB_FEATURE_STORE
#define HB_FEATURE_STORE HB_FEATURE_FULL /* SET_REQUEST: the calibration in non-volatile memory */
#endif
#ifndef HB_FEATURE_CAPTURE
#define HB_FEATURE_CAPTURE 1
#endif
#ifndef HB_FEATURE_ERROR_MAP
#define HB_FEATURE_ERROR_MAP 1
#endif
#ifndef HB_FEATURE_GENERATOR
#define HB_FEATURE_GENERATOR 1 /* chirp and multisine; step, ramp, sine, staircase are always in */
#endif
#ifndef HB_LAW_WEIGHTS
#define HB_LAW_WEIGHTS 1 /* set-point weights and a filter on the derivative in the position law */
#endif
#ifndef HB_LAW_SECTIONS
#define HB_LAW_SECTIONS 4 /* second-order sections behind the position law's PID (0 or 4) */
#endif
#ifndef HB_PLATEAUS
#define HB_PLATEAUS 32 /* currents in the list that procedures excite the actuator with */
#endif
#ifndef HB_FEATURE_TABLE_TRIG
#define HB_FEATURE_TABLE_TRIG 0 /* sine and arctangent from tables: for processors without floating point */
#endif
#ifndef HB_FEATURE_FUSED_TRIG
#define HB_FEATURE_FUSED_TRIG                                                                                \
    0 /* sine and cosine by one reduction: for a processor with fused multiply-add */
#endif
#ifndef HB_FEATURE_TRIAL
#define HB_FEATURE_TRIAL                                                                                     \
    HB_FEATURE_FULL /* a third copy of the calibration that a lost master brings back                        \
                     */
#endif
#ifndef HB_FEATURE_BRAKE
#define HB_FEATURE_BRAKE HB_FEATURE_FULL /* actuators that brake before their outputs go to zero */
#endif
#ifndef HB_FEATURE_TEXTS
#define HB_FEATURE_TEXTS 1 /* descriptions of signals and parameters; names and units are always in */
#endif
#ifndef HB_NUMBER_DIGITS
#define HB_NUMBER_DIGITS 9 /* digits of a number in the A2L; 6 needs no 64 bit arithmetic */
#endif
#ifndef HB_TICK_MS
#define HB_TICK_MS 1 /* period of the control tick: 1, 2, 5 or 10 */
#endif
#ifndef HB_SPEED_WINDOW
#define HB_SPEED_WINDOW 32 /* samples of the speed estimate */
#endif
#if HB_RING_OCTETS <= 256
typedef uint8_t hb_length; /* of a packet */
#else
typedef uint16_t hb_length;
#endif
#if HB_FEATURE_FULL
typedef uint32_t hb_address;
typedef uint16_t hb_daq_count;
enum { HB_SIGNAL_TABLES = 2 };
#else
typedef uint16_t hb_address;  /* the description of a small board is shorter than 64 kB */
typedef uint8_t hb_daq_count; /* fewer than 256 entries, and packets shorter than 256 octets */
enum { HB_SIGNAL_TABLES = 1 };
#endif

/* Where the control tick may interrupt everything else, it waits between these two. They enclose what it must
 * not see half done: never more than some hundred octets. */
#ifndef HB_LOCK
#define HB_LOCK() ((void)0)
#define HB_UNLOCK() ((void)0)
#endif
/* A board on a serial line gives HB_SXI_BAUD instead. */
#if !defined HB_A2L_TRANSPORT && !defined HB_SXI_BAUD
#define HB_A2L_TRANSPORT "/begin XCP_ON_TCP_IP 0x0100 5555 ADDRESS \"127.0.0.1\" /end XCP_ON_TCP_IP\n"
#endif

#if HB_FEATURE_TEXTS
#define HB_TEXT(text) "\0" text
#else
#define HB_TEXT(text)
#endif

/* Where the compiler would copy a function to each of its callers, which on a small processor is longer. */
#ifdef __AVR__
#define HB_NOINLINE __attribute__((noinline))
#else
#define HB_NOINLINE
#endif

/* Constant tables and their words live in flash on machines with separate program memory; there they are C
 * with GNU extensions (-std=gnu11), because only those give a string of a table its place in flash. */
#ifdef __AVR__
#include <avr/pgmspace.h>
#define HB_ROM PROGMEM
#define hb_rom_copy(destination, source, octets) memcpy_P((destination), (source), (octets))
#define hb_rom_octet(address) pgm_read_byte(address)
#define hb_rom_word(address) pgm_read_word(address)
#else
#include <string.h>
#define HB_ROM
#define hb_rom_copy(destination, source, octets) memcpy((destination), (source), (octets))
#define hb_rom_octet(address) (*(const unsigned char*)(address))
#define hb_rom_word(address) (*(address))
#endif
#if defined(__AVR__) && !defined(__cplusplus)
#define HB_FLASH __flash
typedef const __flash char hb_rom_char;
#define HB_WORDS(words) ((hb_rom_char[]){words})
#else
#define HB_FLASH
typedef const char hb_rom_char;
#define HB_WORDS(words) words
#endif

#endif
