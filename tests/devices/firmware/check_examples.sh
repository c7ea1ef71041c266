#!/bin/sh
# usage: check_examples.sh SOURCE_DIRECTORY OUTPUT_DIRECTORY
# Compiles what a board's author starts from, for the processors it is meant for, and prints what it occupies:
# the library as one pair, the Arduino-class example (the whole program within 15 kB of flash, 1 kB of RAM), the
# Cortex-M example with USB.
set -eu
root=$1
output=$2
warnings="-std=c11 -Os -Wall -Wextra -Werror -ffunction-sections -fdata-sections"
mkdir -p "$output"
python3 "$root/devices/firmware/make_pair.py" "$output/pair"
cd "$root"
library="devices/firmware/xcp/*.c devices/firmware/control/hb_safety.c devices/firmware/examples/minimal_board.c"

echo "the pair:"
cc $warnings -Wconversion -I "$output/pair" -c "$output/pair/halbench_board.c" -o "$output/pair.o"
small='-DHB_BOARD_CONFIG="devices/firmware/boards/arduino_uno/board_config.h"'
avr-gcc -mmcu=atmega328p $warnings -std=gnu11 "$small" -I . -c "$output/pair/halbench_board.c" -o "$output/pair-avr.o"
avr-size "$output/pair-avr.o" | tail -1 | awk '{ print "  ATmega328P, before the linker drops anything: flash " $1 + $2 ", RAM " $2 + $3 }'

echo "Arduino Uno:"
devices/firmware/boards/arduino_uno/build.sh "$output"
avr-size "$output/arduino_uno.elf" | tail -1 | {
  read -r text data bss _
  echo "  flash $((text + data)) of 15360, RAM $((data + bss)) of 1024 octets"
  [ $((text + data)) -le 15360 ] && [ $((data + bss)) -le 1024 ]
}

echo "Cortex-M4 with USB, without the vendor's code:"
for source in $library devices/firmware/examples/usb_board.c devices/firmware/boards/cortex_m_usb/main.c; do
  arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb $warnings -DHB_RING_OCTETS=4096 -I . -c "$source" \
    -o "$output/arm-$(basename "$source" .c).o"
done
arm-none-eabi-size -t "$output"/arm-*.o | tail -1 | awk '{ print "  flash " $1 + $2 ", RAM " $2 + $3 " octets" }'
