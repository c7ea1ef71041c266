#!/bin/sh
# usage: check_misra.sh SOURCE_DIRECTORY
# MISRA C:2012 over the board library by cppcheck's addon; deviations with their reasons are in
# devices/firmware/misra_deviations.txt, and one that is not needed any more is an error too.
set -eu
cd "$1"
findings=$(cppcheck --quiet --addon=misra --std=c11 --enable=style,warning,performance,portability,information --inline-suppr \
  --suppressions-list=devices/firmware/misra_deviations.txt --suppress=missingIncludeSystem --suppress=variableScope \
  '-DISR(vector)=static void vector(void)' -UHB_BOARD_CONFIG -U__AVR__ -U__cplusplus -I . --template='{file}:{line}: {id} {message}' \
  devices/firmware/xcp devices/firmware/control devices/firmware/board devices/firmware/axes devices/firmware/htm devices/firmware/planar devices/firmware/spherical devices/firmware/examples devices/firmware/boards 2>&1)
[ -z "$findings" ] || { echo "$findings"; exit 1; }
