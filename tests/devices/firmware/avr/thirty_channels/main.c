/* Thirty channels a hundred times a second: the stream that the library is to carry on an ATmega328P at
 * 115200 Bd (resources/help/firmware-guide.md). Each channel is a number of its own in every sample, so that
 * a value in the wrong place or of the wrong instant shows. */

#include "devices/firmware/boards/arduino_uno/uart_line.h"

#include <avr/interrupt.h>
#include <avr/io.h>

enum { CHANNELS = 30, SAMPLE_TICKS = 10, STEP_OF_SAMPLE = 37, STEP_OF_CHANNEL = 1009 };

typedef struct {
    uint16_t value[CHANNELS];
} channel_values;

typedef struct {
    uint16_t spare;
} channel_page;

#define CHANNEL(number)                                                                                      \
    HB_SIGNAL("channel." #number, "", HB_UWORD, channel_values, value[number], 1.0F, 0.0F, 65535.0F, NULL, "")

static const hb_signal Signals[] HB_ROM = {
    CHANNEL(0),  CHANNEL(1),  CHANNEL(2),  CHANNEL(3),  CHANNEL(4),  CHANNEL(5),  CHANNEL(6),  CHANNEL(7),
    CHANNEL(8),  CHANNEL(9),  CHANNEL(10), CHANNEL(11), CHANNEL(12), CHANNEL(13), CHANNEL(14), CHANNEL(15),
    CHANNEL(16), CHANNEL(17), CHANNEL(18), CHANNEL(19), CHANNEL(20), CHANNEL(21), CHANNEL(22), CHANNEL(23),
    CHANNEL(24), CHANNEL(25), CHANNEL(26), CHANNEL(27), CHANNEL(28), CHANNEL(29),
};
static const hb_parameter Parameters[] HB_ROM = {
    HB_PARAM(HB_PAGED, "spare", "", HB_UWORD, channel_page, spare, 0.0F, 0.0F, 65535.0F, NULL, ""),
};
static const hb_event Events[] HB_ROM = {{"sample", SAMPLE_TICKS, 6}};

typedef struct {
    hb_xcp xcp;
    channel_values channels;
    channel_page pages[2];
    uart_line line;
    uint32_t tick;
} board_state;

/* The interrupt handler has no argument to find it by. */
static board_state Board;

ISR(USART_RX_vect) {
    uart_line_take(&Board.line);
}

static void describe(void) {
    hb_xcp_description description = {0};
    description.model = "channels";
    description.device = "channels-1";
    description.signals[0].entries = Signals;
    description.signals[0].count = CHANNELS;
    description.signals[0].base = &Board.channels;
    description.parameters = Parameters;
    description.parameter_count = 1;
    description.events = Events;
    description.event_count = 1;
    description.pages[0] = (uint8_t*)&Board.pages[0];
    description.pages[1] = (uint8_t*)&Board.pages[1];
    description.page_octets = sizeof Board.pages[0];
    hb_xcp_init(&Board.xcp, &description);
}

static void start(void) {
    TCCR1B = (1 << WGM12) | (1 << CS11);
    OCR1A = 1999; /* 1 ms */
    describe();
    uart_line_start(&Board.line);
    sei();
}

static void sample(void) {
    uint16_t number = (uint16_t)(Board.tick / SAMPLE_TICKS);
    for (uint8_t i = 0; i < CHANNELS; i++) {
        Board.channels.value[i] = (uint16_t)(STEP_OF_SAMPLE * number + STEP_OF_CHANNEL * (uint16_t)i);
    }
    hb_xcp_event(&Board.xcp, 0);
}

int main(void) {
    start();
    for (;;) {
        uart_line_serve(&Board.line, &Board.xcp);
        if (TIFR1 & (1 << OCF1A)) {
            TIFR1 = 1 << OCF1A;
            (void)hb_xcp_take_page(&Board.xcp);
            (void)hb_xcp_watchdog_expired(&Board.xcp, 0);
            Board.xcp.time_us = 1000U * Board.tick;
            if (Board.tick % SAMPLE_TICKS == 0) {
                sample();
            }
            Board.tick++;
        }
    }
}
