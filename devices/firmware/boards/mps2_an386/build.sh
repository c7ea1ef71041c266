#!/bin/sh
# SPDX-License-Identifier: MIT
# usage: build.sh ACTUATOR OUTPUT_DIRECTORY
# Compiles the board of ACTUATOR (a folder beside this file) for a Cortex-M4F into OUTPUT_DIRECTORY/mps2_ACTUATOR.elf.
# Products and sums are not contracted to one rounding, so that the host's build computes the same.
set -eu
actuator=$1
output=$2
root=$(CDPATH= cd -- "$(dirname -- "$0")/../../../.." && pwd)
firmware=$root/devices/firmware
board=$firmware/boards/mps2_an386
mkdir -p "$output"
arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -O3 -flto -ffp-contract=off -fno-math-errno \
  -std=c11 -g -Wall -Wextra -Wshadow -Wconversion -Wdouble-promotion -Werror \
  '-DHB_BOARD_CONFIG="devices/firmware/boards/mps2_an386/board_config.h"' "-DHB_ACTUATOR=hb_${actuator}_actuator" \
  -ffunction-sections -fdata-sections -Wl,--gc-sections -nostartfiles --specs=nano.specs -T "$board/program.ld" -I "$root" \
  "$firmware"/xcp/*.c "$firmware"/control/*.c "$firmware"/board/*.c "$firmware/$actuator"/*.c "$board"/*.c "$board/$actuator"/*.c \
  -lm -o "$output/mps2_$actuator.elf"
