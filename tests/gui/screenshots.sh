#!/usr/bin/env bash
# Pictures of every perspective, empty, with a moving motor and with its results: light and dark, at 1x and 2x,
# into FOLDER. SIZE=1280x720 takes those of another window, SUBJECT=monitor only those of the Monitor's typical uses,
# SUBJECT=sim:planar those of another device.
# usage: [SIZE=WIDTHxHEIGHT] [SUBJECT=NAME] tests/gui/screenshots.sh FOLDER [LANGUAGE...]
set -euo pipefail
folder=$(realpath -m "${1:?usage: tests/gui/screenshots.sh FOLDER [LANGUAGE...]}")
shift
[ $# -gt 0 ] || set -- en
size=${SIZE:-1440x900}
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
ninja --quiet -C build/release halbench_screenshots
for language in "$@"; do
    for scale in 1 2; do
        QT_SCALE_FACTOR=$scale build/release/bin/halbench_screenshots "$folder" "$language" "${size%x*}" "${size#*x}" ${SUBJECT:+"$SUBJECT"}
    done
done
