/* SPDX-License-Identifier: MIT */
#include "devices/firmware/examples/usb_board.h"

#include <string.h>

enum { FULL_SPEED_PACKET = 64 };

void usb_board_init(usb_board* usb, const usb_port* port) {
    memset(usb, 0, sizeof *usb);
    usb->port = *port;
    minimal_board_init(&usb->board);
    usb_board_connected(usb);
}

void usb_board_connected(usb_board* usb) {
    hb_stream_receiver_init(&usb->receiver);
    usb->filled = 0;
}

static void takeCommands(usb_board* usb) {
    uint8_t octets[FULL_SPEED_PACKET];
    uint16_t count = usb->port.receive(usb->port.context, octets, sizeof octets);
    for (uint16_t i = 0; i < count; i++) {
        uint16_t length = hb_stream_receive(&usb->receiver, octets[i]);
        if (length > 0) {
            hb_xcp_receive(&usb->board.xcp, hb_stream_packet(&usb->receiver), length);
        }
    }
}

/* As many packets as fit into one transfer: at thousands of samples a second that is what makes it work. */
static void fillTransfer(usb_board* usb) {
    uint8_t* transfer = usb->transfer[usb->filling];
    while (usb->filled + HB_STREAM_HEADER + USB_LONGEST_PACKET <= USB_TRANSFER) {
        uint8_t* message = &transfer[usb->filled];
        uint16_t length = hb_xcp_transmit(&usb->board.xcp, &message[HB_STREAM_HEADER], USB_LONGEST_PACKET);
        if (length == 0) {
            return;
        }
        hb_stream_header(message, length, hb_xcp_counter(&usb->board.xcp));
        usb->filled = (uint16_t)(usb->filled + HB_STREAM_HEADER + length);
    }
}

void usb_board_poll(usb_board* usb) {
    takeCommands(usb);
    fillTransfer(usb);
    if (usb->filled > 0 && usb->port.send(usb->port.context, usb->transfer[usb->filling], usb->filled)) {
        usb->filling = 1U - usb->filling;
        usb->filled = 0;
    }
}

void usb_board_tick(usb_board* usb) {
    float position_rad = usb->port.position_rad(usb->port.context);
    usb->port.drive_A(usb->port.context, minimal_board_tick(&usb->board, position_rad));
}
