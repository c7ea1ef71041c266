/* SPDX-License-Identifier: MIT */
#ifndef HB_USB_BOARD_H
#define HB_USB_BOARD_H

/* The minimal board on USB bulk endpoints, for any processor and any vendor's USB stack: its two endpoints,
 * its sensor and its output are functions that the board's author supplies. */

#include "devices/firmware/examples/minimal_board.h"
#include "devices/firmware/xcp/hb_stream.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    /* What the host sent on the OUT endpoint, at most `capacity` octets; 0: nothing now. */
    uint16_t (*receive)(void* context, uint8_t* octets, uint16_t capacity);
    /* Begins a transfer on the IN endpoint; the octets stay as they are until the next call. 0: the last
     * transfer is still on its way. */
    uint8_t (*send)(void* context, const uint8_t* octets, uint16_t count);
    float (*position_rad)(void* context);
    void (*drive_A)(void* context, float current_A);
    void* context;
} usb_port;

/* The longest packet is an answer or a sample. */
enum {
    USB_LONGEST_PACKET = HB_MAX_DTO > HB_MAX_CTO ? HB_MAX_DTO : HB_MAX_CTO,
    USB_TRANSFER = 2 * (USB_LONGEST_PACKET + (int)HB_STREAM_HEADER)
};

typedef struct {
    minimal_board board;
    usb_port port;
    hb_stream_receiver receiver;
    uint8_t transfer[2][USB_TRANSFER]; /* one on its way, one being filled */
    uint16_t filled;
    uint8_t filling;
} usb_board;

void usb_board_init(usb_board* usb, const usb_port* port);
/* The host configured the device (again): nothing of an earlier session is left on the line. */
void usb_board_connected(usb_board* usb);
/* As often as possible, and usb_board_tick() every millisecond, both from the same context. */
void usb_board_poll(usb_board* usb);
void usb_board_tick(usb_board* usb);

#ifdef __cplusplus
}
#endif

#endif
