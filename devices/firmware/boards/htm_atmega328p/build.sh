#!/bin/sh
# SPDX-License-Identifier: MIT
# usage: build.sh OUTPUT_DIRECTORY
# Compiles the board with avr-gcc and fails if it needs more flash than the 32256 octets beside a boot loader or leaves less than 512 octets of the
# 2 kB of RAM for the stack.
set -eu
output=$1
root=$(CDPATH= cd -- "$(dirname -- "$0")/../../../.." && pwd)
firmware=$root/devices/firmware
mkdir -p "$output"
avr-gcc -mmcu=atmega328p -Os -flto -mstrict-X -fno-move-loop-invariants -fno-tree-fre -std=c11 -Wall -Wextra -Werror -DF_CPU=16000000UL \
  '-DHB_BOARD_CONFIG="devices/firmware/boards/htm_atmega328p/board_config.h"' \
  -ffunction-sections -fdata-sections -mcall-prologues -Wl,--gc-sections -Wl,--relax -I "$root" \
  "$firmware"/xcp/*.c "$firmware"/control/*.c "$firmware"/htm/*.c "$firmware"/boards/htm_atmega328p/main.c \
  -lm -o "$output/htm_atmega328p.elf"
avr-size "$output/htm_atmega328p.elf" | tail -1 | {
  read -r text data bss _
  flash=$((text + data))
  ram=$((data + bss))
  echo "flash $flash of 32256 octets, RAM $ram of 2048 octets"
  [ "$flash" -le 32256 ] && [ "$ram" -le 1536 ]
}
