#!/bin/sh
# usage: build.sh OUTPUT_DIRECTORY
# Compiles the board of thirty channels for an ATmega328P into OUTPUT_DIRECTORY/thirty_channels.elf.
set -eu
root=$(CDPATH= cd -- "$(dirname -- "$0")/../../../../.." && pwd)
mkdir -p "$1"
avr-gcc -mmcu=atmega328p -Os -flto -std=gnu11 -Wall -Wextra -Werror \
  '-DHB_BOARD_CONFIG="devices/firmware/boards/arduino_uno/board_config.h"' \
  -ffunction-sections -fdata-sections -Wl,--gc-sections -I "$root" \
  "$root"/devices/firmware/xcp/*.c "$root"/tests/devices/firmware/avr/thirty_channels/main.c -lm -o "$1/thirty_channels.elf"
