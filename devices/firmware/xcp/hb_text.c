/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_text.h"

#include <string.h>

enum base { DECIMAL = 10, HEXADECIMAL = 16 };

static char* putDigits(char* text, uint32_t value, enum base base, uint8_t least) {
    char reversed[10];
    uint8_t count = 0;
    do {
        uint8_t digit = (uint8_t)(value % base);
        reversed[count++] = (char)(digit < 10 ? '0' + digit : 'A' + digit - 10);
        value /= base;
    } while (value > 0 || count < least);
    while (count > 0) {
        *text++ = reversed[--count];
    }
    *text = 0;
    return text;
}

void hb_format_unsigned(uint32_t value, char text[HB_NUMBER_CAPACITY]) {
    (void)putDigits(text, value, DECIMAL, 1);
}

void hb_format_hex(uint32_t value, uint8_t digits, char text[HB_NUMBER_CAPACITY]) {
    (void)putDigits(text, value, HEXADECIMAL, digits);
}

#if HB_NUMBER_DIGITS > 6

/* Fixed point with four bits above the fraction: room for the factor 10 of one digit. */
typedef uint64_t wide_number;
enum { FRACTION_BITS = 56 };
enum { FLOAT_MANTISSA_BITS = 23, FLOAT_BIAS = 150 };
#define ONE ((wide_number)1 << FRACTION_BITS)
#define HIGHEST_BIT ((wide_number)1 << (FRACTION_BITS + 3))

typedef struct {
    wide_number scaled;    /* value * 10^-exponent, in [1, 10) */
    wide_number tolerance; /* half a unit in the last place of the float, same scale */
    int8_t exponent;
} decimal;

/* Distance at which a decimal still stands for the value. */
static wide_number toleranceOf(wide_number scaled, uint32_t mantissa) {
    wide_number tolerance = scaled / (2 * (wide_number)mantissa);
    if (mantissa == 0x800000UL) {
        tolerance /= 2; /* below a power of two the floats lie twice as close */
    }
    return tolerance - tolerance / 64; /* keeps clear of ties and of the truncation above */
}

/* value = mantissa * 2^power -> scaled decimal. Each step truncates one unit of 2^-(FRACTION_BITS + 3); at
 * most 45. */
static decimal normalise(uint32_t mantissa, int16_t power) {
    decimal result = {0, 0, 0};
    wide_number wide = mantissa;
    int16_t binary = power;
    while (wide < HIGHEST_BIT) {
        wide <<= 1;
        binary--;
    }
    while (binary > -FRACTION_BITS || (binary == -FRACTION_BITS && wide >= 10 * ONE)) {
        wide /= 10;
        result.exponent++;
        while (wide < HIGHEST_BIT) {
            wide <<= 1;
            binary--;
        }
    }
    while (binary < -FRACTION_BITS - 3) {
        wide = (wide >> 4) * 10; /* 1/16 of the value times 10 */
        binary = (int16_t)(binary + 4);
        result.exponent--;
        while (wide < HIGHEST_BIT) {
            wide <<= 1;
            binary--;
        }
    }
    result.scaled = wide >> (-FRACTION_BITS - binary);
    result.tolerance = toleranceOf(result.scaled, mantissa);
    return result;
}

/* Shortest digits within the tolerance; returns their number. A carry out of the first digit raises the
 * exponent. */
static uint8_t generateDigits(decimal* number, char digits[HB_NUMBER_DIGITS]) {
    wide_number rest = number->scaled;
    wide_number tolerance = number->tolerance;
    uint8_t count = 0;
    for (;;) {
        digits[count++] = (char)(rest >> FRACTION_BITS);
        rest &= ONE - 1;
        if (rest < tolerance || ONE - rest < tolerance || count == HB_NUMBER_DIGITS) {
            break; /* close enough from below or above: the nearer of the two */
        }
        rest *= 10;
        tolerance *= 10;
    }
    if (rest < ONE / 2) {
        return count;
    }
    while (count > 0 && ++digits[count - 1] == 10) {
        count--;
    }
    if (count == 0) {
        digits[0] = 1;
        number->exponent++;
        count = 1;
    }
    return count;
}

static char* putExponent(char* text, int8_t exponent) {
    uint8_t size = (uint8_t)(exponent < 0 ? -exponent : exponent);
    *text++ = 'e';
    *text++ = exponent < 0 ? '-' : '+';
    *text++ = (char)('0' + size / 10);
    *text++ = (char)('0' + size % 10);
    return text;
}

static char* putPlain(char* text, const char* digits, uint8_t count, int8_t exponent) {
    int8_t place = exponent < 0 ? exponent : 0;
    for (; place < 0; place++) {
        *text++ = '0';
        if (place == exponent) {
            *text++ = '.';
        }
    }
    for (uint8_t i = 0; i < count || i <= exponent; i++) {
        if (exponent >= 0 && i == exponent + 1) {
            *text++ = '.';
        }
        *text++ = i < count ? (char)('0' + digits[i]) : '0';
    }
    return text;
}

void hb_format_float(float value, char text[HB_NUMBER_CAPACITY]) {
    uint32_t bits;
    uint32_t mantissa;
    int16_t power;
    char digits[HB_NUMBER_DIGITS];
    decimal number;
    uint8_t count;
    memcpy(&bits, &value, sizeof bits);
    power = (int16_t)((bits >> FLOAT_MANTISSA_BITS) & 0xFF);
    mantissa = bits & 0x7FFFFFUL;
    if (power > 0) {
        mantissa |= 0x800000UL;
    } else {
        power = 1;
    }
    if (mantissa != 0 && (bits >> 31)) {
        *text++ = '-';
    }
    if (mantissa == 0) {
        memcpy(text, "0", 2);
        return;
    }
    number = normalise(mantissa, (int16_t)(power - FLOAT_BIAS));
    count = generateDigits(&number, digits);
    if (number.exponent >= -4 && number.exponent <= 9) {
        text = putPlain(text, digits, count, number.exponent);
    } else {
        text = putPlain(text, digits, count, 0);
        text = putExponent(text, number.exponent);
    }
    *text = 0;
}

#else

/* Six digits as a whole number and a power of ten: what 24 bits of a float give without wider arithmetic. */
void hb_format_float(float value, char text[HB_NUMBER_CAPACITY]) {
    int8_t exponent = 0;
    uint32_t digits;
    if (value < 0.0F) {
        *text++ = '-';
        value = -value;
    }
    for (; value >= 999999.5F; exponent++) {
        value *= 0.1F;
    }
    for (; value < 99999.95F && value > 0.0F; exponent--) {
        value *= 10.0F;
    }
    digits = (uint32_t)(value + 0.5F);
    for (; exponent != 0 && digits % 10U == 0; exponent++) {
        digits /= 10U;
    }
    text = putDigits(text, digits, DECIMAL, 1);
    if (exponent != 0) {
        *text++ = 'e';
        if (exponent < 0) {
            *text++ = '-';
            exponent = (int8_t)-exponent;
        }
        (void)putDigits(text, (uint8_t)exponent, DECIMAL, 1);
    }
}

#endif
