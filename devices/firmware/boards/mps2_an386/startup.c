/* SPDX-License-Identifier: MIT */

/* Vectors and start of a Cortex-M4F: floating point on, variables in their initial state, then main(). No
 * interrupt is taken; a processor fault stops here. */

#include "devices/firmware/boards/mps2_an386/registers.h"

#include <string.h>

int main(void);
void start_processor(void);

/* Of the linker script; the address of a count is its value. */
extern uint8_t ImageOfData[], StartOfData[], StartOfBss[];
extern const uint8_t DataOctets[], BssOctets[];

static void halt(void) {
    for (;;) {
    }
}

void start_processor(void) {
    CPACR |= CPACR_FLOATING_POINT;
    __asm volatile("dsb\n isb\n cpsid i" ::: "memory");
    memcpy(StartOfData, ImageOfData, (size_t)DataOctets);
    memset(StartOfBss, 0, (size_t)BssOctets);
    (void)main();
    halt();
}

typedef void (*vector)(void);

/* Reset, NMI, hard fault, memory, bus and usage fault; the stack's end stands before them. */
static const vector Vectors[]
    __attribute__((section(".vectors"), used)) = {start_processor, halt, halt, halt, halt, halt};
