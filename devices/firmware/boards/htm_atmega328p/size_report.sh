#!/bin/sh
# SPDX-License-Identifier: MIT
# usage: size_report.sh ELF
# Prints what the board occupies and fails if it needs more flash than the 32256 octets beside a boot loader or
# leaves less than 512 octets of the 2 kB of RAM for the stack.
set -eu
avr-size "$1" | tail -1 | {
  read -r text data bss _
  flash=$((text + data))
  ram=$((data + bss))
  echo "flash $flash of 32256 octets, RAM $ram of 2048 octets"
  [ "$flash" -le 32256 ] && [ "$ram" -le 1536 ]
}
