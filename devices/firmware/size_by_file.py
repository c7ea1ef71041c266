#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""usage: size_by_file.py ELF [LIMIT]

Says where a board's flash goes, file by file, from the addresses in the program's own line table (build it with
-gdwarf-2, which adds nothing to the flash). The library is what comes from its sources (xcp, hb_safety) and all
constant tables and texts in flash; with LIMIT the program fails if that is more octets. `run-time` is what the
compiler's libraries and the start-up add."""
import bisect
import collections
import re
import subprocess
import sys

LIBRARY = re.compile(r"/xcp/|/control/hb_safety|^tables and texts$")
RUN_TIME = "run-time"


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def line_table(elf):
    """Sorted addresses and the file of each. A row names its file without the folder, a header with it."""
    text = output("avr-objdump", "--dwarf=decodedline", elf)
    folders = {path.rsplit("/", 1)[-1]: path for path in re.findall(r"^(?:CU: )?(\S+\.[ch]):", text, re.MULTILINE)}
    rows = re.findall(r"^(\S+\.[ch])\s+\d+\s+(0x[0-9a-f]+)\b", text, re.MULTILINE)
    return sorted({int(address, 16): folders.get(name, name) for name, address in rows}.items())


def symbols(elf):
    """Address, octets and name of everything in flash that has a size; a place once."""
    found = {}
    for line in output("avr-nm", "-S", elf).splitlines():
        parts = re.match(r"^(00[0-7]\S+) (\S+) [tTwW] (\S+)$", line)
        if parts:
            address, size = int(parts[1], 16), int(parts[2], 16)
            if size > found.get(address, (0, ""))[0]:
                found[address] = (size, parts[3])
    return [(address, size, name) for address, (size, name) in sorted(found.items())]


def shares(elf, end_of_constants):
    rows = line_table(elf)
    addresses = [address for address, _ in rows]
    octets = collections.Counter()
    for start, size, _ in symbols(elf):
        end = start + size
        first, last = bisect.bisect_left(addresses, start), bisect.bisect_left(addresses, end)
        if start < end_of_constants:
            octets["tables and texts"] += size
        elif first == last:
            octets[RUN_TIME] += size
        else:
            edges = [start] + addresses[first + 1:last] + [end]
            for i, (_, name) in enumerate(rows[first:last]):
                octets[name] += edges[i + 1] - edges[i]
    return octets


def main():
    elf = sys.argv[1]
    marks = {name: int(address, 16) for address, name in
             re.findall(r"^(\S+) . (__ctors_end|__data_load_end)$", output("avr-nm", elf), re.MULTILINE)}
    octets = shares(elf, marks["__ctors_end"])
    octets[RUN_TIME] += marks["__data_load_end"] - sum(octets.values())  # vectors, start-up, data's image
    for name, count in octets.most_common():
        print(f"{count:6d}  {re.sub('^.*devices/firmware/', '', name)}")
    library = sum(count for name, count in octets.items() if LIBRARY.search(name))
    limit = int(sys.argv[2]) if len(sys.argv) > 2 else None
    print(f"library with its tables: {library} octets of flash" + (f" of {limit}" if limit else ""))
    if not octets or (limit and library > limit):
        sys.exit("the library is larger than its limit")


main()
