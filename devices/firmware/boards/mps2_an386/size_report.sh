#!/bin/sh
# SPDX-License-Identifier: MIT
# usage: size_report.sh ELF
# Prints what a board occupies of a Cortex-M4F with 128 kB of flash and of RAM and fails when less than 8 kB of the RAM
# are left for the stack.
set -eu
arm-none-eabi-size "$1" | tail -1 | {
  read -r text data bss _
  flash=$((text + data))
  ram=$((data + bss))
  echo "flash $flash of 131072 octets, RAM $ram of 131072 octets"
  [ "$flash" -le 131072 ] && [ "$ram" -le $((131072 - 8192)) ]
}
