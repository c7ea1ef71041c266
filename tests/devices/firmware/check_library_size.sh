#!/bin/sh
# usage: check_library_size.sh SOURCE_DIRECTORY OUTPUT_DIRECTORY
# The library with its tables on an ATmega328P: at most 12 kB of flash, and the whole minimal board, which holds
# all of the library's variables, at most 1 kB of RAM (resources/help/firmware-guide.md, "Smaller boards").
set -eu
"$1/devices/firmware/boards/arduino_uno/build.sh" "$2"
python3 "$1/devices/firmware/size_by_file.py" "$2/arduino_uno.elf" 12288
avr-size "$2/arduino_uno.elf" | tail -1 | {
  read -r text data bss _
  echo "the whole program: flash $((text + data)), RAM $((data + bss)) of 1024 octets"
  [ $((data + bss)) -le 1024 ]
}
