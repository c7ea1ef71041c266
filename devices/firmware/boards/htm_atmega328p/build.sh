#!/bin/sh
# SPDX-License-Identifier: MIT
# usage: build.sh OUTPUT_DIRECTORY
# Compiles the board with avr-gcc into OUTPUT_DIRECTORY/htm_atmega328p.elf; size_report.sh tells whether it fits.
set -eu
output=$1
root=$(CDPATH= cd -- "$(dirname -- "$0")/../../../.." && pwd)
firmware=$root/devices/firmware
mkdir -p "$output"
avr-gcc -mmcu=atmega328p -Os -flto -mstrict-X -mcall-prologues -fno-move-loop-invariants -fno-tree-fre -fno-split-wide-types -fno-jump-tables \
  -std=gnu11 -gdwarf-2 -Wall -Wextra -Werror -DF_CPU=16000000UL \
  '-DHB_BOARD_CONFIG="devices/firmware/boards/htm_atmega328p/board_config.h"' \
  -ffunction-sections -fdata-sections -Wl,--gc-sections -Wl,--relax -I "$root" \
  "$firmware"/xcp/*.c "$firmware"/control/*.c "$firmware"/board/*.c "$firmware"/htm/*.c "$firmware"/boards/htm_atmega328p/*.c \
  -lm -o "$output/htm_atmega328p.elf"
