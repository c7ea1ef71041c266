/* SPDX-License-Identifier: MIT */

/* The USB board on any Cortex-M: the core's SysTick gives the millisecond, four functions of yours the rest.
 * Compile with the library's sources (or the pair of make_pair.py) and your vendor's start-up code, USB stack
 * and clock set-up. */

#include "devices/firmware/examples/usb_board.h"

/* Yours: device set-up with one bulk OUT and one bulk IN endpoint (resources/help/protocol.md 3.4). */
void board_start(void);
uint16_t board_usb_receive(void* context, uint8_t* octets, uint16_t capacity);
uint8_t board_usb_send(void* context, const uint8_t* octets, uint16_t count);
float board_position_rad(void* context);
void board_drive_A(void* context, float current_A);

#ifndef BOARD_CLOCK_HZ
#define BOARD_CLOCK_HZ 48000000UL
#endif

/* The core's own timer, the same on every Cortex-M (ARMv7-M manual, B3.3). */
#define SYST_CSR (*(volatile uint32_t*)0xE000E010UL)
#define SYST_RVR (*(volatile uint32_t*)0xE000E014UL)
#define SYST_CVR (*(volatile uint32_t*)0xE000E018UL)
enum { SYST_ENABLE = 1, SYST_CORE_CLOCK = 4 };
#define SYST_COUNTED (1UL << 16) /* reading clears it */

int main(void) {
    static usb_board Board;
    const usb_port port = {board_usb_receive, board_usb_send, board_position_rad, board_drive_A, NULL};
    board_start();
    usb_board_init(&Board, &port);
    SYST_RVR = BOARD_CLOCK_HZ / 1000UL - 1UL;
    SYST_CVR = 0;
    SYST_CSR = SYST_ENABLE | SYST_CORE_CLOCK;
    for (;;) {
        usb_board_poll(&Board);
        if (SYST_CSR & SYST_COUNTED) {
            usb_board_tick(&Board);
        }
    }
}
