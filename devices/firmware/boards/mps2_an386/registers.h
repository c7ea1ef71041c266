/* SPDX-License-Identifier: MIT */
#ifndef HB_MPS2_REGISTERS_H
#define HB_MPS2_REGISTERS_H

/* Registers of the core (ARMv7-M manual, B3) and of the board's serial ports (Cortex-M System Design Kit
 * manual, APB UART). */

#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t*)(address))

#define SYST_CSR REGISTER(0xE000E010UL)
#define SYST_RVR REGISTER(0xE000E014UL)
#define SYST_CVR REGISTER(0xE000E018UL)
enum { SYST_ENABLE = 1, SYST_CORE_CLOCK = 4 };
#define SYST_LARGEST 0xFFFFFFUL

#define NVIC_ISER REGISTER(0xE000E100UL)
#define NVIC_ICPR REGISTER(0xE000E280UL)
#define CPACR REGISTER(0xE000ED88UL)
#define CPACR_FLOATING_POINT (0xFUL << 20)

typedef struct {
    volatile uint32_t data, state, control, interrupt, divider;
} uart_registers;
enum { UART_TRANSMITTER_FULL = 1, UART_RECEIVER_FULL = 2 };               /* of state */
enum { UART_TRANSMIT = 1, UART_RECEIVE = 2, UART_RECEIVE_INTERRUPT = 8 }; /* of control */
enum { UART_RECEIVED = 2 };                                               /* of interrupt */
enum { UART_XCP_RECEIVED = 1, UART_PLANT_RECEIVED = 4 };                  /* of NVIC: lines 0 and 2 */
#define UART_XCP ((uart_registers*)0x40004000UL)
#define UART_PLANT ((uart_registers*)0x40005000UL)

#endif
