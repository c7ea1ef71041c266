#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""usage: make_pair.py OUTPUT_DIRECTORY

Writes the board library as one pair, halbench_board.h and halbench_board.c, to add to a project that has no
folder for it: the link (xcp/) and the latches (control/hb_safety). hb_config.h's settings stay macros."""
import pathlib
import re
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
INCLUDE = re.compile(r'#include "devices/firmware/((?:xcp|control)/\w+\.h)"\n')
PUBLIC = ["xcp/hb_xcp.h", "xcp/hb_sxi.h", "xcp/hb_stream.h", "control/hb_safety.h"]
LICENSE = "/* SPDX-License-Identifier: MIT */\n"


def flat(name, done):
    """The file with what it includes in place, each header once."""
    if name in done:
        return ""
    done.add(name)
    text = (FOLDER / name).read_text().replace(LICENSE, "")
    return INCLUDE.sub(lambda found: flat(found[1], done), text)


def main():
    output = pathlib.Path(sys.argv[1])
    output.mkdir(parents=True, exist_ok=True)
    done = set()
    header = "".join(flat(name, done) for name in PUBLIC)
    sources = sorted(FOLDER.glob("xcp/*.c")) + [FOLDER / "control/hb_safety.c"]
    source = "".join(flat(str(path.relative_to(FOLDER)), done) for path in sources)
    (output / "halbench_board.h").write_text(LICENSE + "#pragma once\n" + header)
    (output / "halbench_board.c").write_text(LICENSE + '#include "halbench_board.h"\n' + source)


main()
