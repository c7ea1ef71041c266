/* SPDX-License-Identifier: MIT */

/* A controller board on the MPS2 with the AN386 image (Cortex-M4F at 25 MHz), which qemu-system-arm runs
 * instruction by instruction. Its first serial port carries XCP in the HB-SxI profile; the second one stands
 * for the converters and the timer. Orders of the plant on it, little endian:
 *
 *   'T' | readings          one control tick
 *   'S' | heard u32         serve until so many octets of the first port are obeyed, counted from power-on
 *
 * and the board's answer, when it has done that and has sent what it had to say on the first port:
 *
 *   said u32 | counts u32 | outputs
 *
 * `said` is how many octets it has sent on the first port since power-on, `counts` of the core's timer how
 * long the last tick took. With 'S' before each tick a run is the same whatever the host's timing; without it
 * the first port is served as octets come. */

#include "devices/firmware/boards/mps2_an386/actuator_port.h"
#include "devices/firmware/boards/mps2_an386/registers.h"
#include "devices/firmware/xcp/hb_sxi.h"
#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <string.h>

enum { TICK = 'T', SERVE = 'S', SERVE_OCTETS = 4, SAID = 0, COUNTS = 4, OUTPUTS = 8 };

typedef struct {
    hb_board* actuator;
    hb_sxi_receiver receiver;
    hb_sxi_sender sender;
    uint32_t heard, said; /* octets of the first port */
    uint32_t counts;
    uint8_t order[PORT_ROOM]; /* behind its kind */
    uint8_t answer[OUTPUTS + PORT_ROOM];
} mps2_state;

static mps2_state Board;

static void startPort(uart_registers* port) {
    port->divider = 25000000UL / HB_SXI_BAUD;
    port->control = UART_TRANSMIT | UART_RECEIVE | UART_RECEIVE_INTERRUPT;
}

static uint8_t take(uart_registers* port, uint8_t* octet) {
    if (!(port->state & UART_RECEIVER_FULL)) {
        return 0;
    }
    port->interrupt = UART_RECEIVED;
    *octet = (uint8_t)port->data;
    return 1;
}

static uint8_t put(uart_registers* port, uint8_t octet) {
    if (port->state & UART_TRANSMITTER_FULL) {
        return 0;
    }
    port->data = octet;
    return 1;
}

/* One octet of the first port, if one came. */
static uint8_t hear(void) {
    uint8_t octet;
    uint16_t length;
    if (!take(UART_XCP, &octet)) {
        return 0;
    }
    Board.heard++;
    length = hb_sxi_receive(&Board.receiver, octet);
    if (length > 0) {
        hb_board_receive(Board.actuator, hb_sxi_packet(&Board.receiver), length);
    }
    return 1;
}

static uint8_t nextOctet(uint8_t* octet) {
    uint16_t length;
    if (hb_sxi_next(&Board.sender, octet)) {
        return 1;
    }
    length = hb_board_transmit(Board.actuator, hb_sxi_room(&Board.sender), HB_SXI_LONGEST_PACKET);
    if (length == 0) {
        return 0;
    }
    hb_sxi_start(&Board.sender, length, hb_board_counter(Board.actuator));
    return hb_sxi_next(&Board.sender, octet);
}

/* All that the board has to say. */
static void say(void) {
    uint8_t octet;
    while (nextOctet(&octet)) {
        while (!put(UART_XCP, octet)) {
        }
        Board.said++;
    }
}

static void sleep(void) {
    __asm volatile("wfi" ::: "memory"); /* an interrupt that waits ends it, also where none is taken */
    NVIC_ICPR = UART_XCP_RECEIVED | UART_PLANT_RECEIVED;
}

/* The next octets of the plant; what comes on the first port is answered meanwhile. */
static void await(uint8_t* octets, uint8_t count) {
    uint8_t filled = 0;
    while (filled < count) {
        uint8_t has_heard = hear();
        if (has_heard) {
            say();
        }
        if (take(UART_PLANT, &octets[filled])) {
            filled++;
        } else if (!has_heard) {
            sleep();
        }
    }
}

static void tick(void) {
    uint32_t before;
    await(Board.order, Port.reading_octets);
    before = SYST_CVR;
    Port.tick(Board.order, &Board.answer[OUTPUTS]);
    Board.counts = (before - SYST_CVR) & SYST_LARGEST;
}

static void serve(void) {
    await(Board.order, SERVE_OCTETS);
    while (Board.heard < hb_get32(Board.order)) {
        (void)hear();
    }
}

static void answer(void) {
    hb_put32(&Board.answer[SAID], Board.said);
    hb_put32(&Board.answer[COUNTS], Board.counts);
    for (uint16_t i = 0; i < OUTPUTS + Port.output_octets; i++) {
        while (!put(UART_PLANT, Board.answer[i])) {
        }
    }
}

/* Anything else is not an order: it is passed over without an answer. */
static void obey(uint8_t kind) {
    if (kind == (uint8_t)TICK) {
        tick();
    } else if (kind == (uint8_t)SERVE) {
        serve();
    } else {
        return;
    }
    say();
    answer();
}

int main(void) {
    hb_board_config config;
    memset(&config, 0, sizeof config);
    config.max_dto = HB_SXI_LONGEST_PACKET;
    Board.actuator = Port.start(&config);
    hb_sxi_receiver_init(&Board.receiver);
    startPort(UART_XCP);
    startPort(UART_PLANT);
    NVIC_ISER = UART_XCP_RECEIVED | UART_PLANT_RECEIVED;
    SYST_RVR = SYST_LARGEST;
    SYST_CVR = 0;
    SYST_CSR = SYST_ENABLE | SYST_CORE_CLOCK;
    for (;;) {
        uint8_t kind;
        await(&kind, 1);
        obey(kind);
    }
}
