#!/bin/sh
# SPDX-License-Identifier: MIT
# usage: build.sh OUTPUT_DIRECTORY
# Compiles the minimal board for an ATmega328P into OUTPUT_DIRECTORY/arduino_uno.elf. The options beside -Os were
# measured one by one: each makes the program shorter.
set -eu
output=$1
root=$(CDPATH= cd -- "$(dirname -- "$0")/../../../.." && pwd)
firmware=$root/devices/firmware
mkdir -p "$output"
avr-gcc -mmcu=atmega328p -Os -flto -mstrict-X -mcall-prologues -fno-move-loop-invariants -fno-tree-fre -fno-split-wide-types -fno-jump-tables \
  -fno-tree-switch-conversion -fno-tree-scev-cprop -fno-ipa-cp -fno-inline-small-functions -fno-tree-ter \
  -std=gnu11 -gdwarf-2 -Wall -Wextra -Werror \
  '-DHB_BOARD_CONFIG="devices/firmware/boards/arduino_uno/board_config.h"' \
  -ffunction-sections -fdata-sections -Wl,--gc-sections -Wl,--relax -I "$root" \
  "$firmware"/xcp/*.c "$firmware"/control/hb_safety.c "$firmware"/examples/minimal_board.c "$firmware"/boards/arduino_uno/main.c \
  -lm -o "$output/arduino_uno.elf"
